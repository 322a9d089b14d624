#!/usr/bin/env bash
# states.sh PROGRAM SCENES STATES: writes the states of the scenes into the file STATES. They are the same when the scenes
# are played again, and where a scene differs the line, step, field and place are told.
set -euo pipefail
program=$1 scenes=$2 states=$3
"$program" --write "$states" "$scenes"
"$program" --compare "$states" "$scenes"

# With a longer first step the difference is in that step:
other=$(mktemp)
trap 'rm -f "$other"' EXIT
line=$(grep -n -m 1 '^step ' "$scenes" | cut -d: -f1)
awk -v line="$line" 'NR == line { $2 *= 1.5 } { print }' "$scenes" >"$other"
said=$("$program" --compare "$states" "$other" 2>&1) && { echo "another time step was not noticed" >&2; exit 1; }
grep -E "^line $line, step 1, float32: field [0-9]+ at \([0-9]+, [0-9]+\), component [0-9]+: [^ ]+ here, [^ ]+ there$" \
    <<<"$said" || { printf 'not what was expected of a difference:\n%s\n' "$said" >&2; exit 1; }
