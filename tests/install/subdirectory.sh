#!/usr/bin/env bash
# Builds and runs the consumers in a C project that adds contdyn as a subdirectory; nothing but the library is built.
. "$(dirname "$0")/common.sh"

out=$WORK/subdirectory
configures "$out" -S "$here/subdirectory" -DCONTDYN_SOURCE="$SOURCE"
builds "$out"
runs shared "$out/rope_shared"
runs static "$out/rope_static"
! needs "$out/rope_static" | grep -E 'stdc|gcc' || fail "a C program with the archive needs the C++ run time"
[ ! -e "$out/contdyn/tests" ] || fail "contdyn builds its tests inside a user's project"
