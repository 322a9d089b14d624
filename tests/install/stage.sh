#!/usr/bin/env bash
# Installs into one place, moves it to another, and fails if any other file is there than the ones named here.
. "$(dirname "$0")/common.sh"

rm -rf "$WORK"
mkdir -p "$WORK"
quietly "$CMAKE" --install "$BUILD" --config "$CONFIG" --prefix "$WORK/stage"
mv "$WORK/stage" "$prefix"

config=${CONFIG,,}
headers=$(cd "$SOURCE/include" && find contdyn -name '*.h' | sed 's,^,include/,')
found=$(cd "$prefix" && find . ! -type d | sed 's,^\./,,' | sort)
named=$(sort <<EOT
$headers
include/contdyn/contdyn.hpp
$LIBDIR/libcontdyn.a
$LIBDIR/libcontdyn.so
$LIBDIR/libcontdyn.so.$ABI_VERSION
$LIBDIR/libcontdyn.so.$VERSION
$LIBDIR/pkgconfig/contdyn.pc
$LIBDIR/cmake/contdyn/contdynConfig.cmake
$LIBDIR/cmake/contdyn/contdynConfigVersion.cmake
$LIBDIR/cmake/contdyn/contdynTargets.cmake
$LIBDIR/cmake/contdyn/contdynTargets-${config:-noconfig}.cmake
EOT
)
diff <(cat <<<"$named") <(cat <<<"$found") || fail "other files than expected (<: missing, >: not expected)"
grep -qF "\"version-semver\": \"$VERSION\"" "$SOURCE/pkgconfig/vcpkg/contdyn/vcpkg.json" ||
    fail "vcpkg.json has another version"
! grep -rlIF -e "$WORK" -e "$SOURCE" -e "$BUILD" "$prefix" || fail "a path of the building machine is in these files"
