#!/usr/bin/env bash
# Installs the components one by one, fails unless each has its files, and takes them away by the target uninstall.
. "$(dirname "$0")/common.sh"

out=$WORK/components
rm -rf "$out"
place=$out/place

installs() { # installs COMPONENT PATTERN...: fails unless it adds files of each pattern, and no others
    local before after
    before=$(cd "$out" && find . ! -type d | sort)
    quietly "$CMAKE" --install "$BUILD" --config "$CONFIG" --prefix "$place" --component "contdyn_$1"
    after=$(cd "$out" && find . ! -type d | sort)
    local added=$(comm -13 <(cat <<<"$before") <(cat <<<"$after"))
    shift
    for pattern; do
        grep -q -- "$pattern" <<<"$added" || fail "no $pattern in: $added"
        added=$(grep -v -- "$pattern" <<<"$added" || true)
    done
    [ -z "$added" ] || fail "other files than expected: $added"
}
mkdir -p "$out"
installs runtime "/libcontdyn\.so\.$ABI_VERSION$" "/libcontdyn\.so\.$VERSION$"
installs cpp '/contdyn/contdyn\.hpp$'
installs development '/contdyn/[a-z]*\.h$' '/libcontdyn\.so$' '/libcontdyn\.a$' '/pkgconfig/contdyn\.pc$' '/cmake/contdyn/'
touch "$place/include/theirs.h"

quietly "$CMAKE" --build "$BUILD" --target uninstall
left=$(cd "$place" && find . ! -type d)
[ "$left" = ./include/theirs.h ] || fail "left behind, or taken away too many: $left"
[ ! -e "$place/include/contdyn" ] || fail "an empty folder is left behind"
! "$CMAKE" --build "$BUILD" --target uninstall >/dev/null 2>&1 || fail "uninstall says nothing of what is not installed"
