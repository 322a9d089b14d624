#!/usr/bin/env bash
# check_headers.sh COMPILER INCLUDE_DIR: fails if a public header does not compile alone, and twice in one file, in
# every C and C++ standard from C99 and C++11 on, without a warning. Exits with 77 if there is no such compiler.
. "$(dirname "$0")/common.sh"

compiler=$1
include=$2
command -v "$compiler" >/dev/null || { echo "SKIPPED: no $compiler on this machine"; exit 77; }
headers=$(cd "$include" && find . -name '*.h' | sed 's,^\./,,' | sort)
[ -n "$headers" ] || fail "no header in $include"

flags="-Wall -Wextra -Wundef -Wshadow -Wconversion -pedantic -Werror -fsyntax-only"
compiles() { # language, standard, more flags
    printf '#include "%s"\n#include "%s"\nint main(void) { return 0; }\n' "$header" "$header" |
        "$compiler" -x "$1" -std="$2" $flags $3 -I "$include" - || fail "$header: $compiler -x $1 -std=$2"
}
for header in $headers; do
    for standard in c99 c11 c17; do compiles c $standard "-Wstrict-prototypes -Wc++-compat"; done
    for standard in c++11 c++14 c++17 c++20; do compiles c++ $standard ""; done
done
