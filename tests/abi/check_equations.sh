#!/usr/bin/env bash
# check_equations.sh SRC [TESTS]: fails if model.md's equations are not numbered in turn, if a comment cites one it lacks,
# or if one is cited nowhere.
. "$(dirname "$0")/common.sh"

cd "$1"
numbers=$(grep -oE '^    .* \([0-9]+\)$' model.md | grep -oE '[0-9]+\)$' | tr -d ')')
count=$(wc -l <<<"$numbers")
[ "$numbers" = "$(seq "$count")" ] || fail "model.md's equations are not numbered in turn: $(tr '\n' ' ' <<<"$numbers")"
shift
cited=$(grep -rnoE --include='*.c' --include='*.cpp' --include='*.hh' '\(model\.md, [^)]*\)' . "$@" || true)
[ -n "$cited" ] || fail "no comment cites an equation of model.md"
# What was cited as a number or as a range of numbers.
awk -v count="$count" '
    {
        text = $0
        sub(/^.*\(model\.md, /, "", text)
        sub(/\..*$/, "", text)
        gsub(/ to /, "-", text)
        while (match(text, /[0-9]+(-[0-9]+)?/)) {
            split(substr(text, RSTART, RLENGTH), ends, "-")
            last = RLENGTH > length(ends[1]) ? ends[2] : ends[1]
            if (ends[1] < 1 || last > count) print
            for (number = ends[1] + 0; number <= last + 0; ++number) is_cited[number] = 1
            text = substr(text, RSTART + RLENGTH)
        }
    }
    END { for (number = 1; number <= count; ++number) if (!is_cited[number]) print "nothing cites (" number ")" }
    ' <<<"$cited" | fail_on_lines "cited, but not in model.md, or the other way round:"
