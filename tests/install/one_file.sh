#!/usr/bin/env bash
# Compiles the library as one file, by the one command that src/amalgamate.py tells but for less optimisation, and plays
# the conformance scenes. Where the processor has them it may use AVX2 and FMA: nothing may be fused.
. "$(dirname "$0")/common.sh"

command -v python3 >/dev/null || { echo "SKIPPED: no python3 on this machine"; exit 77; }
out=$WORK/one_file
rm -rf "$out"
python3 "$SOURCE/src/amalgamate.py" "$out"

flags=
! grep -qs '^flags.* avx2.* fma\|^flags.* fma.* avx2' /proc/cpuinfo || flags="-mavx2 -mfma"
# shellcheck disable=SC2086 # flags are words
"$CXX" -std=c++17 -O1 -fno-math-errno -fno-trapping-math -Wall -Wextra -Wno-psabi -Werror $flags -c -I "$out" \
    "$out/contdyn.cpp" -o "$out/contdyn.o"
"$CC" -I "$out" -I "$SOURCE/bindings/conformance" "$SOURCE/tests/bindings/conformance.c" "$out/contdyn.o" -lm \
    -o "$out/conformance"
"$out/conformance" "$SOURCE/bindings/conformance/scenes.txt"
! needs "$out/conformance" | grep -E 'stdc|gcc' || fail "a C program with it needs the C++ run time"
"$CXX" -std=c++17 -fsyntax-only -I "$out" "$SOURCE/bindings/cpp/examples/rope.cpp" # the header for C++ lies beside it
! "$CXX" -std=c++17 -ffast-math -fsyntax-only -I "$out" "$out/contdyn.cpp" 2>"$out/said" || fail "-ffast-math is taken"
grep -q 'without -ffast-math' "$out/said" || fail "-ffast-math is refused without the reason"
