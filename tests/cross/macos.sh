#!/usr/bin/env bash
# macos.sh SOURCE CMAKE FOLDER: configures the library for macOS, which needs nothing of that system, and looks at the
# commands that would be run: universal binaries get no flags of one processor, and no linker options are GNU's.
set -euo pipefail
source=$1 cmake=$2 folder=$3

fail() { echo "macos: $*" >&2; exit 1; }

configures() { # configures PROCESSORS ARGUMENT...
    rm -rf "$folder"
    "$cmake" -S "$source" -B "$folder" -G 'Unix Makefiles' -Wno-dev \
        -DCMAKE_SYSTEM_NAME=Darwin -DCMAKE_SYSTEM_VERSION=20 \
        -DCMAKE_C_COMPILER=clang -DCMAKE_C_COMPILER_WORKS=ON -DCMAKE_C_COMPILER_TARGET=arm64-apple-macos11 \
        -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_COMPILER_WORKS=ON -DCMAKE_CXX_COMPILER_TARGET=arm64-apple-macos11 \
        -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY -DCMAKE_OSX_SYSROOT=/ -DCMAKE_INSTALL_NAME_TOOL=true \
        -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCONTDYN_TESTS=OFF -DCONTDYN_REPORT=OFF \
        "-DCMAKE_OSX_ARCHITECTURES=$1" "${@:2}" 2>&1
}
flags() { grep -o ' -m[a-z][a-z0-9=-]*' "$folder/compile_commands.json" | sort -u | tr -d '\n' || true; }

configures 'arm64;x86_64' >/dev/null
[ -z "$(flags)" ] || fail "a universal library is compiled with $(flags)"
grep -q -- '-arch arm64.* -arch x86_64' "$folder/compile_commands.json" || fail "no universal library is built"

link=$folder/src/CMakeFiles/contdyn.dir/link.txt
name='-install_name @rpath/libcontdyn\.[0-9.]*\.dylib'
for option in -dynamiclib "$name" "-Xlinker -exported_symbols_list -Xlinker /" -Wl,-dead_strip; do
    grep -q -e "$option" "$link" || fail "not linked by $option"
done
! grep -o -e '-Wl,-[a-z_-]*\(version-script\|as-needed\|gc-sections\|no-undefined\|soname\)[^ ]*' "$link" ||
    fail "linked by a GNU option"
! grep -q -e 'stdc++\|-lc++' "$link" || fail "linked to a C++ library"
listed=$(sort -u "$folder/src/contdyn.symbols" | grep -c '^_cd_[a-z0-9_]*$')
[ "$listed" = "$(wc -l <"$folder/src/contdyn.symbols")" ] || fail "the list of exports holds something else"
echo "$listed functions are exported"

configures x86_64 >/dev/null
[[ $(flags) == *-mavx2*-mavx512dq* ]] || fail "a library for x86-64 alone has no kernels for AVX: $(flags)"
configures arm64 >/dev/null
[ -z "$(flags)" ] || fail "a library for arm64 alone is compiled with $(flags)"
! said=$(configures 'arm64;x86_64' -DCONTDYN_AVX2=ON) || fail "a universal library with AVX2 is configured"
grep -q 'lipo -create' <<<"$said" || fail "it is refused without the reason: $said"
rm -rf "$folder"
