#!/usr/bin/env bash
# declared_functions.sh INCLUDE_DIR HEADER...: the functions that the public headers declare, as a C compiler reads
# them: every declaration outside braces that is no typedef, by the name before its first parenthesis.
. "$(dirname "$0")/common.sh"

include=$1
shift
for header; do
    printf '#include "%s"\n' "$header"
done | "$CC" -E -P -I "$include" -x c - | tr '\n\t' '  ' | sed 's/[;{}]/\n&\n/g' | awk '
    /^{/  { ++depth }
    /^}/  { --depth }
    /^;/ && depth == 0 && declaration !~ /^ *typedef / {
        if (match(declaration, /cd_[a-z0-9_]+ *\(/)) {
            name = substr(declaration, RSTART, RLENGTH)
            sub(/ *\($/, "", name)
            print name
        }
    }
    { declaration = $0 }' | sort -u
