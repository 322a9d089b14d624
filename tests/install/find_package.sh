#!/usr/bin/env bash
# Compiles, links and runs the consumers against the moved copy, found by find_package: in a C project, and with C++.
. "$(dirname "$0")/common.sh"

for with_cxx in OFF ON; do
    out=$WORK/find_package_$with_cxx
    configures "$out" -S "$here/find_package" -DCMAKE_PREFIX_PATH="$prefix" -DWITH_CXX=$with_cxx
    grep -q "^contdyn_DIR:.*=$prefix/" "$out/CMakeCache.txt" || fail "another contdyn was found than the moved one"
    builds "$out"
    runs shared "$out/rope_shared"
    runs static "$out/rope_static"
    for program in "$out/rope_shared" "$out/rope_static"; do
        ! needs "$program" | grep -E 'stdc|gcc' || fail "$program, in C, needs the C++ run time"
    done
done
runs shared "$out/rope_shared_cxx"
runs static "$out/rope_static_cxx"
runs shared "$out/rope_shared_header"
runs static "$out/rope_static_header"
