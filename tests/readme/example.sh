#!/usr/bin/env bash
# example.sh SOURCE NAME LIBRARY COMMAND...: compiles or interprets the README's example NAME by COMMAND and compares what
# it prints with the block after <!-- output: hello.c -->.
set -euo pipefail
source=$1 name=$2 library=$3
shift 3
. "$source/tests/readme/blocks.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
block "$source/README.md" "<!-- example: $name -->" >"$folder/$name"
block "$source/README.md" "<!-- output: hello.c -->" >"$folder/expected"
[ -s "$folder/$name" ] && [ -s "$folder/expected" ] || { echo "no example $name with its output in README.md" >&2; exit 1; }
if [ "${name##*.}" = py ]; then
    CONTDYN_LIBRARY=$library PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$source/bindings/python" \
        "$@" "$folder/$name" >"$folder/printed"
else
    "$@" -I"$source/include" "$folder/$name" "$library" -Wl,-rpath,"$(dirname "$library")" -o "$folder/program"
    "$folder/program" >"$folder/printed"
fi
diff "$folder/expected" "$folder/printed"
