#!/usr/bin/env bash
# check_globals.sh ARCHIVE ALLOWED: fails if an object file has a variable that can be written, other than the
# thread-local ones in the file ALLOWED: a line each, the C++ name and its size in bytes.
. "$(dirname "$0")/common.sh"

sections=$(sections_of "$1")
grep -q '^\.text' <<<"$sections" || fail "$1 holds no object files"
awk '$3 ~ /W/ && $3 ~ /A/ && $3 !~ /T/ && $1 !~ /^\.data\.rel\.ro/ && $2 !~ /^0+$/' <<<"$sections" |
    fail_on_lines "can be written (section, size, flags, object):"
"$NM" --format=posix "$1" | awk '$2 == "C"' | fail_on_lines "common, and can be written:"
"$READELF" -sW "$1" | awk '$4 == "TLS" && $7 != "UND" { print $8, $3 }' | c++filt | sort -u |
    { grep -vxFf "$2" || true; } | fail_on_lines "thread-local, but not in $2:"
