#!/usr/bin/env bash
# check_baseline.sh BASELINE INCLUDE_DIR HEADER...: fails if a program that was compiled with the headers from which
# BASELINE was written might not run with these: functions or enumerators that are gone or have another value, other types
# of arguments, other members of structures. What is new is allowed. A baseline is of one version; after a version that
# may break programs --update BASELINE INCLUDE_DIR HEADER... writes it anew. Needs abidw and abidiff.
. "$(dirname "$0")/common.sh"

update=
[ "$1" != --update ] || { update=yes && shift; }
baseline=$1 include=$2
shift 2
command -v abidw abidiff >/dev/null || { echo "abidw or abidiff is missing (Debian: abigail-tools)" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A library with a body for every function that the headers declare, a variable of every enumeration, and nothing else:
# what the real library exports is held to the headers by check_exports.
for header; do
    printf '#include "%s"\n' "$header"
done | "$CC" -E -P -DCD_API=CD_DECLARES -I "$include" -x c - | tr '\n' ' ' | sed -E '
    s/CD_DECLARES ([^;]*);/\n\1 { __builtin_trap(); }\n/g
    s/\benum \{ *([A-Z0-9_]+)([^}]*)\} *;/\nenum of_\1 { \1\2 } variable_of_\1;\n/g' >"$work/interface.c"
"$CC" -g -O0 -fPIC -shared -x c "$work/interface.c" -o "$work/interface.so"

if [ "$update" ]; then
    abidw --no-corpus-path --no-comp-dir-path --no-show-locs --type-id-style hash "$work/interface.so" >"$baseline"
    exit
fi
said=$(abidiff --no-added-syms --fail-no-debug-info "$baseline" "$work/interface.so" 2>&1) && exit
fail "programs compiled with the headers of $(basename "$baseline") may not run with these:"$'\n'"$said"
