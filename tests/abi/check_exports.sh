#!/usr/bin/env bash
# check_exports.sh LIBRARY INCLUDE_DIR HEADER...: fails unless the shared library exports exactly the functions that the
# headers declare, and nothing that is no function.
. "$(dirname "$0")/common.sh"

library=$1
shift
declared=$("$(dirname "$0")/declared_functions.sh" "$@")
[ -n "$declared" ] || fail "found no function in $*"
# name and kind; kind A is the version's own symbol
symbols=$("$NM" -D --defined-only --format=posix "$library" | awk '$2 != "A" { sub(/@.*/, "", $1); print $1, $2 }')
[ -n "$symbols" ] || fail "$library exports nothing"

awk '$2 != "T"' <<<"$symbols" | fail_on_lines "exported, but no function:"
exported=$(awk '{ print $1 }' <<<"$symbols" | sort -u)
comm -13 <(cat <<<"$declared") <(cat <<<"$exported") | fail_on_lines "exported, but in no header:"
comm -23 <(cat <<<"$declared") <(cat <<<"$exported") | fail_on_lines "declared, but not exported:"
