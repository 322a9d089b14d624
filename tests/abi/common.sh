# Read by every script here. Tools: $CC, $CXX, $NM, $READELF, $OBJDUMP, or the ones in the path.
set -euo pipefail
export LC_ALL=C

CC=${CC:-cc}
CXX=${CXX:-c++}
NM=${NM:-nm}
READELF=${READELF:-readelf}
OBJDUMP=${OBJDUMP:-objdump}

fail() {
    printf '%s: %s\n' "$(basename "$0" .sh)" "$*" >&2
    exit 1
}

# Fails with a title if standard input holds any line.
fail_on_lines() {
    local lines
    lines=$(cat)
    [ -z "$lines" ] || fail "$1"$'\n'"$lines"
}

# "name size flags object" of every section of the object files in an archive.
sections_of() {
    "$READELF" -SW "$1" | awk '
        /^File: /           { file = $2 }
        /^ *\[ *[0-9]+\] /  { sub(/^ *\[ *[0-9]+\] */, ""); if ($2 != "NULL") print $1, $5, $7, file }'
}
