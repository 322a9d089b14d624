#!/usr/bin/env bash
# check_file_length.sh MOST FOLDER...: fails if a file under the folders that people write has more than MOST
# lines.
. "$(dirname "$0")/common.sh"

most=$1
shift
files=$(find "$@" -type f ! -name "*.abi")
[ -n "$files" ] || fail "no file under $*"
find "$@" -type f ! -name "*.abi" -exec wc -l {} \; | awk -v most="$most" '$1 > most' | fail_on_lines "longer than $most lines:"
