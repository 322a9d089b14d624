#!/usr/bin/env bash
# check_equations.sh SRC: fails if model.md's equations are not numbered in turn, or if a comment cites one it lacks.
. "$(dirname "$0")/common.sh"

cd "$1"
numbers=$(grep -oE '^    .* \([0-9]+\)$' model.md | grep -oE '[0-9]+\)$' | tr -d ')')
count=$(wc -l <<<"$numbers")
[ "$numbers" = "$(seq "$count")" ] || fail "model.md's equations are not numbered in turn: $(tr '\n' ' ' <<<"$numbers")"
cited=$(grep -rnoE --include='*.cpp' --include='*.hh' '\(model\.md, [^)]*\)' . || true)
[ -n "$cited" ] || fail "no comment cites an equation of model.md"
awk -v count="$count" '
    {
        text = $0
        sub(/^.*model\.md, /, "", text)
        sub(/\..*$/, "", text)
        while (match(text, /[0-9]+/)) {
            number = substr(text, RSTART, RLENGTH) + 0
            if (number < 1 || number > count) print
            text = substr(text, RSTART + RLENGTH)
        }
    }' <<<"$cited" | fail_on_lines "no such equation in model.md:"
