#!/usr/bin/env bash
# check_layers.sh SRC: fails if a file includes a layer above its own. Downwards: api, model, solve, kernel, base. Only
# model and api know the public headers of the objects; base.h is everybody's.
. "$(dirname "$0")/common.sh"

cd "$1"
includes=$(grep -rnE '^[[:space:]]*#[[:space:]]*include' --include='*.cpp' --include='*.hh' --include='*.h' . || true)
[ -n "$includes" ] || fail "$1 holds no sources"
awk '
    BEGIN {
        count = split("base kernel solve model api", layers, " ")
        for (i = 1; i <= count; ++i) height[layers[i]] = i
    }
    {
        split($0, place, ":")
        split(place[1], path, "/")
        included = $0
        sub(/^[^"<]*["<]/, "", included)
        sub(/[">].*$/, "", included)
        slash = index(included, "/")
        layer = slash ? substr(included, 1, slash - 1) : ""
        own = height[path[2]]
        if (!own) print $0 ": a file outside the five layers"
        else if (layer == "contdyn") { if (own < height["model"] && included != "contdyn/base.h") print }
        else if (height[layer] > own) print
        else if (!height[layer] && $0 ~ /include[[:space:]]*"/) print $0 ": write the layer"
    }' <<<"$includes" | fail_on_lines "upward include:"
