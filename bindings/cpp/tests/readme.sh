#!/usr/bin/env bash
# readme.sh SOURCE CXX: what a new user does with the C++ README, in an empty folder and an empty home: installs, compiles
# and runs its examples, and sees what it says.
set -euo pipefail
source=$1
export CXX=$2
readme=$source/bindings/cpp/README.md
. "$source/tests/readme/blocks.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir home tools
export HOME=$folder/home PATH=$folder/tools:$PATH
unset DESTDIR PKG_CONFIG_PATH CMAKE_PREFIX_PATH LD_LIBRARY_PATH
ln -s "$source" contdyn
ln -s "$(command -v "$CXX")" tools/c++ # the README's command, with the compiler that is tested

# run NAME: a command of the README; what it prints.
run() {
    local command
    command=$(block "$readme" "<!-- command: $1 -->")
    [ -n "$command" ] || { echo "no command $1 in $readme" >&2; exit 1; }
    bash -euo pipefail -c "$command"
}
expect() {
    block "$readme" "<!-- output -->" >expected
    [ -s expected ] || { echo "no output in $readme" >&2; exit 1; }
    tail -n "$(wc -l <expected)" printed | diff expected -
}

for file in rope.cpp CMakeLists.txt status.cpp; do
    block "$readme" "<!-- file: $file -->" >"$file"
    [ -s "$file" ] || { echo "no file $file in $readme" >&2; exit 1; }
done
run install
command -v pkg-config >/dev/null || { echo "SKIPPED: no pkg-config on this machine"; exit 77; }
run pkg-config >printed
expect
run cmake >printed
expect

lib=$HOME/.local/lib
"$CXX" -std=c++17 -Wall -Wextra -pedantic -Werror status.cpp -I"$HOME/.local/include" -L"$lib" -lcontdyn \
    -Wl,-rpath,"$lib" -o status
./status | grep -q "mass is -1"
