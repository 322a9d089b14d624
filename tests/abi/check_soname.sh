#!/usr/bin/env bash
# check_soname.sh LIBRARY VERSION: fails if the SONAME is not libcontdyn.so.MAJOR, or libcontdyn.so.0.MINOR before 1.0,
# if the file or the two links are not named after it and the version, or if the library asks for an executable stack
# or relocated text.
. "$(dirname "$0")/common.sh"

folder=$(dirname "$1")
case $2 in
0.*) soname=libcontdyn.so.${2%.*} ;;
*) soname=libcontdyn.so.${2%%.*} ;;
esac
file=libcontdyn.so.$2
dynamic=$("$READELF" -dW "$1")

found=$(sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p' <<<"$dynamic")
[ "$found" = "$soname" ] || fail "SONAME is '$found', not $soname"
[ -f "$folder/$file" ] && [ ! -L "$folder/$file" ] || fail "no file $file beside $1"
[ "$(readlink -f "$folder/$soname")" = "$(readlink -f "$folder/$file")" ] || fail "$soname does not lead to $file"
[ "$(readlink -f "$folder/libcontdyn.so")" = "$(readlink -f "$folder/$file")" ] ||
    fail "libcontdyn.so does not lead to $file"
! grep -q TEXTREL <<<"$dynamic" || fail "$1 has relocations in its text"
"$READELF" -lW "$1" | { grep 'GNU_STACK.*E' || true; } | fail_on_lines "$1 asks for an executable stack:"
