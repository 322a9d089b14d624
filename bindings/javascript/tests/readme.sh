#!/usr/bin/env bash
# readme.sh SOURCE PACKAGE: what a new user does with the JavaScript README, in an empty folder, and sees what it says;
# the package is that of this build.
set -euo pipefail
source=$1
readme=$source/bindings/javascript/README.md
. "$source/tests/readme/blocks.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir -p contdyn/build/bindings/javascript home
ln -s "$2" contdyn/build/bindings/javascript/contdyn
export HOME=$folder/home npm_config_update_notifier=false npm_config_offline=true

block "$readme" "<!-- file: rope.mjs -->" >rope.mjs
[ -s rope.mjs ] || { echo "no file rope.mjs in $readme" >&2; exit 1; }
if command -v npm >/dev/null; then
    bash -euo pipefail -c "$(block "$readme" "<!-- command: install -->")"
else
    mkdir node_modules
    ln -s "$2" node_modules/contdyn
fi
bash -euo pipefail -c "$(block "$readme" "<!-- command: run -->")" >printed
block "$readme" "<!-- output: run -->" >expected
[ -s expected ]
diff expected printed
