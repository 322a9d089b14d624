#!/usr/bin/env bash
# Fails unless what cannot be built as it is asked for is refused with a reason.
. "$(dirname "$0")/common.sh"

refuses() { # refuses NAME REASON ARGUMENT...
    local name=$1 reason=$2 said
    shift 2
    said=$(configures "$WORK/refused_$name" -S "$SOURCE" "$@") && fail "$name: it is configured"
    tr '\n' ' ' <<<"$said" | tr -s ' ' | grep -q "$reason" || fail "$name: refused without the reason: $said"
}

refuses without_precision "both OFF: at least one precision" -DCONTDYN_FLOAT32=OFF -DCONTDYN_FLOAT64=OFF
refuses without_cmocka "cmocka was not found .* -DCONTDYN_TESTS=OFF builds none" -DCMOCKA_LIBRARY=
