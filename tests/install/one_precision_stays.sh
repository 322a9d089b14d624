#!/usr/bin/env bash
# Fails unless configuring without float32 and without float64 is refused with a reason.
. "$(dirname "$0")/common.sh"

said=$(configures "$WORK/without_both" -S "$SOURCE" -DCONTDYN_FLOAT32=OFF -DCONTDYN_FLOAT64=OFF) &&
    fail "a library without any precision is configured"
grep -q "both OFF: at least one precision" <<<"$said" || fail "refused without the reason: $said"
