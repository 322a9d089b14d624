#!/usr/bin/env bash
# example.sh README NAME COMPILER INCLUDE LIBRARY: compiles the README's example NAME and compares what it prints with
# the block after <!-- output: NAME -->.
set -euo pipefail
readme=$1 name=$2 compiler=$3 include=$4 library=$5
. "$(dirname "$0")/blocks.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
block "$readme" "<!-- example: $name -->" >"$folder/$name"
block "$readme" "<!-- output: $name -->" >"$folder/expected"
[ -s "$folder/$name" ] && [ -s "$folder/expected" ] || { echo "no example $name with its output in $readme" >&2; exit 1; }
"$compiler" -std=c99 -Wall -Wextra -pedantic -Werror -I"$include" "$folder/$name" "$library" \
    -Wl,-rpath,"$(dirname "$library")" -o "$folder/program"
"$folder/program" >"$folder/printed"
diff "$folder/expected" "$folder/printed"
