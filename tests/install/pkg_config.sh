#!/usr/bin/env bash
# Compiles, links and runs the consumers against the moved copy, told by pkg-config: shared, and as an archive.
. "$(dirname "$0")/common.sh"

command -v pkg-config >/dev/null || { echo "SKIPPED: no pkg-config on this machine"; exit 77; }
export PKG_CONFIG_PATH=$prefix/$LIBDIR/pkgconfig
export LD_LIBRARY_PATH=$prefix/$LIBDIR
out=$WORK/pkg_config
rm -rf "$out"
mkdir "$out"

version=$(pkg-config --modversion contdyn)
[ "$version" = "$VERSION" ] || fail "contdyn.pc says version '$version', not $VERSION"
! pkg-config --libs contdyn | grep -q -e '-lm' || fail "the shared library asks its users for libm"
pkg-config --static --libs contdyn | grep -q -e '-lm' || fail "the archive does not ask its users for libm"

flags=$(pkg-config --cflags contdyn)
shared=$(pkg-config --libs contdyn)
static=$(pkg-config --static --libs contdyn)
# shellcheck disable=SC2086 # flags are words
{
    "$CC" "$here/consumer.c" $flags $shared -o "$out/c_shared"
    "$CXX" "$here/consumer.cpp" $flags $shared -o "$out/cxx_shared"
    "$CXX" -std=c++17 "$here/consumer_header.cpp" $flags $shared -o "$out/header_shared"
    "$CC" -static "$here/consumer.c" $flags $static -o "$out/c_static"
    "$CXX" -static "$here/consumer.cpp" $flags $static -o "$out/cxx_static"
    "$CXX" -std=c++17 -static "$here/consumer_header.cpp" $flags $static -o "$out/header_static"
    # only contdyn from its archive, all else shared
    "$CC" "$here/consumer.c" $flags -Wl,-Bstatic $static -Wl,-Bdynamic -o "$out/c_archive"
}
runs shared "$out/c_shared"
runs shared "$out/cxx_shared"
runs shared "$out/header_shared"
unset LD_LIBRARY_PATH
runs static "$out/c_static"
runs static "$out/cxx_static"
runs static "$out/header_static"
runs static "$out/c_archive"
! needs "$out/c_archive" | grep -E 'stdc|gcc' || fail "a C program with the archive needs the C++ run time"
