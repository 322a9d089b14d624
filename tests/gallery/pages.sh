#!/usr/bin/env bash
# pages.sh GALLERY HEADERS GUIDE...: each guide has a page that shows its picture, leads to the program and
# to what that prints, and is led to from the README beside it; and what pages name is in the headers.
set -euo pipefail
gallery=$1 headers=$2
shift 2
failed=0
complain() { echo "$1" >&2; failed=1; }
for guide in "$@"; do
    page=$gallery/$guide.md
    [ -f "$page" ] || { complain "$guide has no page"; continue; }
    for link in "$guide.c" "$guide.txt" README.md; do
        grep -qF "]($link)" "$page" || complain "$guide.md does not lead to $link"
    done
    grep -qF "]($guide.svg)" "$page" || complain "$guide.md does not show its picture"
    grep -qF "]($guide.md)" "$gallery/README.md" || complain "README.md does not lead to $guide.md"
    for name in $(grep -ohE '\b(cd_[a-z0-9_]+|CD_[A-Z0-9_]+)\b' "$page" | sort -u); do
        grep -qw "$name" "$headers"/*.h || complain "$guide.md names $name, which is not in the headers"
    done
done
for link in $(grep -ohE '\]\([^):]+\)' "$gallery"/*.md | tr -d '])(' | sort -u); do
    [ -e "$gallery/$link" ] || complain "a page leads to $link, which is not there"
done
exit "$failed"
