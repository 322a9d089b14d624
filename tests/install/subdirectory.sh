#!/usr/bin/env bash
# Builds and runs the consumers in a C project that adds contdyn as a subdirectory; nothing but the library is built.
# The library is optimised there whatever the project's own build type; the name of its folder has a space.
. "$(dirname "$0")/common.sh"

out="$WORK/sub directory"
configures "$out" -S "$here/subdirectory" -DCONTDYN_SOURCE="$SOURCE"
builds "$out"
runs shared "$out/rope_shared"
runs static "$out/rope_static"
! needs "$out/rope_static" | grep -E 'stdc|gcc' || fail "a C program with the archive needs the C++ run time"
[ ! -e "$out/contdyn/tests" ] || fail "contdyn builds its tests inside a user's project"

installed() { # installed FOLDER: the files that the user's project installs from there
    local to=$WORK/subdirectory_installed
    rm -rf "$to"
    quietly "$CMAKE" --install "$1" --prefix "$to"
    [ ! -e "$to" ] || (cd "$to" && find . ! -type d)
}
installed "$out" | grep . && fail "contdyn is installed with a user's project that has not asked for it"
quietly "$CMAKE" -DCONTDYN_INSTALL=ON "$out"
builds "$out"
installed "$out" | grep -qx ./include/contdyn/contdyn.hpp || fail "contdyn is not installed with a user's project that asks"

flags() { # flags NAME TYPE ARGUMENT...: the lines that compile kernels
    local out=$WORK/subdirectory_$1
    rm -rf "$out"
    quietly "$CMAKE" -B "$out" -S "$here/subdirectory" -DCONTDYN_SOURCE="$SOURCE" -DCMAKE_C_COMPILER="$CC" \
        -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_BUILD_TYPE="$2" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${@:3}"
    grep '"command".*/src/kernel/' "$out/compile_commands.json" | grep -v choose_kernels # it runs once
}
for type in "" Debug; do
    lines=$(flags "type_$type" "$type")
    [ "$(grep -c . <<<"$lines")" -ge 10 ] || fail "no lines that compile kernels: what is looked for?"
    ! grep -v -e ' -O3 ' <<<"$lines" || fail "kernels are not optimised in build type '$type'"
done
! flags asked_otherwise Debug -DCONTDYN_OPTIMIZE=OFF | grep -e ' -O3 ' || fail "CONTDYN_OPTIMIZE=OFF optimises"

# Nothing is optimised at link time, which GCC 12 does not live through, where the user's project is.
lines=$(flags linked "" -DCMAKE_CXX_FLAGS=-flto -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON)
! grep -v -e ' -flto.* -fno-lto ' <<<"$lines" || fail "kernels are left for the linker to optimise"
! grep -e ' -fno-lto .* -flto' <<<"$lines" || fail "kernels are left for the linker to optimise"

# Nothing is fused where the user's flags would let it be. This file adds and subtracts by turns.
if [ "$(uname -m)" = x86_64 ]; then
    flags fused "" -DCMAKE_CXX_FLAGS="-mavx2 -mfma" >/dev/null
    out=$WORK/subdirectory_fused
    command=$(sed -n 's|^ *"command": "\(.*/model/water_hull_step.cpp\)",$|\1|p' "$out/compile_commands.json" | head -n 1)
    [ -n "$command" ] || fail "no line that compiles hulls: what is looked for?"
    (cd "$out" && eval "${command%% -o *} -c $SOURCE/src/model/water_hull_step.cpp -o $out/hulls.o")
    OBJDUMP=${OBJDUMP:-objdump} "$BASH" "$here/../abi/check_fma.sh" "$out/hulls.o"
fi
