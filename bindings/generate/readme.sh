#!/usr/bin/env bash
# readme.sh SOURCE BUILD LANGUAGE: what a new user does with bindings/LANGUAGE/README.md in an empty folder: writes its
# files, runs its commands in their order, and sees what it says. The library is the one in BUILD, in the place where
# the command `library` would build it.
set -euo pipefail
source=$1
build=$2
readme=$source/bindings/$3/README.md
. "$source/tests/readme/blocks.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir contdyn
for entry in "$source"/*; do
    case ${entry##*/} in build*) ;; *) ln -s "$entry" contdyn/ ;; esac
done
rm contdyn/bindings && mkdir contdyn/bindings && cp -r "$source/bindings/$3" contdyn/bindings/
ln -s "$build" contdyn/build
unset CONTDYN_LIBRARY LD_LIBRARY_PATH LUA_PATH MONO_PATH

marks=$(grep -o '<!-- \(file\|command\|output\): [^ ]* -->' "$readme")
[ -n "$marks" ]
compared=0
exports=
while read -r _ kind name _; do
    text=$(block "$readme" "<!-- $kind $name -->")
    case $kind in
        file:) printf '%s\n' "$text" >"$name" ;;
        command:)
            [ "$name" = library ] && continue
            exports=$exports$(grep '^export' <<<"$text" || true)$'\n' # they hold for later commands
            printf '%s%s\n' "$exports" "$text" >now
            bash -euo pipefail now >printed </dev/null || { cat printed; echo "the command '$name' fails" >&2; exit 1; }
            ;;
        output:)
            [ -n "$text" ] || { echo "no output $name in $readme" >&2; exit 1; }
            tail -n "$(wc -l <<<"$text")" printed | diff <(printf '%s\n' "$text") - ||
                { echo "the command '$name' prints something else" >&2; exit 1; }
            compared=$((compared + 1))
            ;;
    esac
done <<<"$marks"
[ "$compared" -gt 0 ]
