#!/usr/bin/env bash
# pictures.sh PROGRAM PICTURE LEAST: the picture has the numbers that the program draws now, but for the last place, and
# LEAST of them or more. The program takes the file's name as its argument or from CONTDYN_PICTURE.
set -euo pipefail
now=$(mktemp)
trap 'rm -f "$now"' EXIT
CONTDYN_PICTURE=$now "$1" "$now" >/dev/null
numbers() { grep -oE -- '-?[0-9]+(\.[0-9]+)?' "$1"; }
paste -d ' ' <(numbers "$2") <(numbers "$now") | awk -v least="$3" '
    NF != 2           { print "the pictures have not as many numbers"; failed = 1; exit 1 }
    $1 - $2 > 1 || $2 - $1 > 1 { print "number " NR ": " $1 ", and now " $2; failed = 1; exit 1 }
    END               { if (NR < least && !failed) { print "the picture has only " NR " numbers"; exit 1 } }'
