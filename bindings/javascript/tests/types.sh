#!/usr/bin/env bash
# types.sh TSC PACKAGE FILE: a file of TypeScript that uses the package as an installed one passes the strictest check.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/node_modules"
ln -s "$2" "$folder/node_modules/contdyn"
cp "$3" "$folder/use.mts"
cd "$folder"
"$1" --strict --noEmit --noUnusedLocals --exactOptionalPropertyTypes --target es2022 --module node16 \
    --moduleResolution node16 --lib es2022,dom use.mts
