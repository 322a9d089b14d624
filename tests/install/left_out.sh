#!/usr/bin/env bash
# left_out.sh PART: builds contdyn without PART (CHAIN, ROPE, MEMBRANE, CLOTH, WATER, HULL, FLOAT32 or FLOAT64) and
# fails unless its code is gone and asking for what was left out is refused. Not optimised, which takes a third of the
# time.
. "$(dirname "$0")/common.sh"

part=$1
out=$WORK/without_$part
CONFIG=None configures "$out" -S "$SOURCE" -DCONTDYN_"$part"=OFF -DCONTDYN_OPTIMIZE=OFF -DCONTDYN_TESTS=OFF \
    -DCONTDYN_REPORT=OFF
builds "$out" --target contdyn
quietly "$CMAKE" --install "$out" --prefix "$out/installed" # whatever target was built

functions() { "$NM" -C --defined-only "$1" 2>/dev/null | grep -o "$2" | sort -u || true; }
dropped() { # fails unless the whole library has functions of this pattern and the one without the part has none
    [ -n "$(functions "$ARCHIVE" "$1")" ] || fail "the whole library has no $1: what is looked for?"
    functions "$out/src/libcontdyn.a" "$1" | { ! grep . ; } || fail "still there without $part"
}
returns_0() { # name: fails unless the program of that name, made from the standard input, does
    cat >"$WORK/$1.c"
    "$CC" "$WORK/$1.c" -I"$SOURCE/include" "$out/src/libcontdyn.a" -lm -o "$out/$1"
    "$out/$1" || fail "without $part: what is left is not as it should be"
}
case $part in
CHAIN | MEMBRANE | WATER)
    dropped "cd_${part,,}_[a-z_]*"
    functions "$out/src/libcontdyn.a" cd_version | grep -q . || fail "cd_version is gone too"
    exit 0
    ;;
ROPE)
    dropped 'RopeBundle<[0-9]*>'
    returns_0 rope <<'END'
#include <contdyn/contdyn.h>
int main(void) {
    cd_chain* chain = 0;
    if (cd_chain_create(1, 4, 2, CD_FLOAT64, 0, &chain)) return 1;
    if (cd_chain_set_rest_length(chain, 1) != CD_ERROR_UNSUPPORTED) return 2;
    if (cd_chain_set_rest_length(chain, 0)) return 3;
    return cd_chain_step(chain, 0.1, 2);
}
END
    exit 0
    ;;
CLOTH)
    dropped 'cloth_[a-z_]*'
    returns_0 cloth <<'END'
#include <contdyn/contdyn.h>
int main(void) {
    cd_membrane* membrane = 0;
    double along_u = -1, along_v = -1;
    if (cd_membrane_create(4, 4, 3, CD_FLOAT64, 0, &membrane)) return 1;
    if (cd_membrane_set_rest_length(membrane, 1, 1) != CD_ERROR_UNSUPPORTED) return 2;
    if (cd_membrane_set_rest_length(membrane, 0, 0)) return 3;
    if (cd_membrane_get_rest_length(membrane, &along_u, &along_v) || along_u != 0 || along_v != 0) return 4;
    if (cd_membrane_set_shear(membrane, 1) != CD_ERROR_UNSUPPORTED) return 5;
    if (cd_membrane_set_breaking_strain(membrane, 1) != CD_ERROR_UNSUPPORTED) return 6;
    return cd_membrane_step(membrane, 0.1, 2);
}
END
    exit 0
    ;;
HULL)
    dropped 'cd::[a-z]*_hulls(cd::Water[^)]*)'
    returns_0 hull <<'END'
#include <contdyn/contdyn.h>
int main(void) {
    cd_water* water = 0;
    size_t count = 9;
    if (cd_water_create(4, 4, 1, 1, CD_FLOAT64, 0, &water)) return 1;
    if (cd_water_set_hulls(water, 1, 1, 1) != CD_ERROR_UNSUPPORTED) return 2;
    if (cd_water_set_hulls(water, 0, 0, 0)) return 3;
    if (cd_water_get_hulls(water, &count, 0, 0) || count != 0) return 4;
    if (cd_water_remove_hull(water, 0) != CD_ERROR_RANGE) return 5;
    return cd_water_step(water, 0.1, 2);
}
END
    exit 0
    ;;
FLOAT32)
    dropped '[a-z_]*_numbers<float'
    other=FLOAT64
    ;;
FLOAT64)
    dropped 'Plain[LR][a-z]*<double' # what membranes and hulls keep for themselves is double
    other=FLOAT32
    ;;
esac
"$CC" "$here/precision.c" -I"$SOURCE/include" "$out/src/libcontdyn.a" -lm -o "$out/precision"
said=$("$out/precision")
echo "$said"
grep -qix "$part CD_ERROR_UNSUPPORTED" <<<"$said" || fail "the precision that was left out is not refused"
grep -qix "$other CD_OK" <<<"$said" || fail "the other precision does not work"
