#!/usr/bin/env bash
# left_out.sh PARTS: builds contdyn without these, joined by +: one of CHAIN, MEMBRANE, WATER, or some of ROPE, CLOTH,
# HULL, BEND, CONTACT, COUPLED, ADVECTED, DRAW, SLEEP, SAVE, FLOAT32, FLOAT64. Fails unless it compiles without a
# warning, their code is gone, cd_build_info names what is left, and every scene of the bindings gives the same bits as
# with the whole library, or ends with CD_ERROR_UNSUPPORTED where it asks for what was left out, as does loading states
# that need it, and as do the packages of other languages where an object is left out. Not optimised, and without the
# widest kernels, which are the same text again: that takes less time.
. "$(dirname "$0")/common.sh"

parts=$1
out="$WORK/without, ä $parts" # where a comma, a space and a letter beyond ASCII must do no harm
IFS=+ read -r -a all <<<"$parts"
options=()
for part in "${all[@]}"; do options+=("-DCONTDYN_$part=OFF"); done
CONFIG=None configures "$out" -S "$SOURCE" "${options[@]}" -DCONTDYN_OPTIMIZE=OFF -DCONTDYN_AVX512=OFF \
    -DCONTDYN_WERROR=ON -DCONTDYN_TESTS=OFF -DCONTDYN_REPORT=OFF
builds "$out" --target contdyn
quietly "$CMAKE" --install "$out" --prefix "$out/installed" # whatever target was built

functions() { "$NM" -C --defined-only "$1" 2>/dev/null | grep -o "$2" | sort -u || true; }
dropped() { # fails unless the whole library has functions of this pattern and the one without the parts has none
    [ -n "$(functions "$ARCHIVE" "$1")" ] || fail "the whole library has no $1: what is looked for?"
    functions "$out/src/libcontdyn.a" "$1" | { ! grep . ; } || fail "still there without $parts"
}
languages_tell() { # fails unless the packages of languages load the library, and say that it makes no such object
    local class=${1^} folder
    local made="$class(2, 2, 1)" left_out="cd_$1_create: this build of the library leaves it out"
    [ "$1" != water ] || made="$class(2, 2, 1, 1)"
    folder=$(mktemp -d)
    export CONTDYN_LIBRARY="$out/src/libcontdyn.so" LD_LIBRARY_PATH="$out/src"
    if command -v luajit >/dev/null; then
        LUA_PATH="$SOURCE/bindings/lua/?.lua;$SOURCE/bindings/lua/?/init.lua" \
            luajit -e "print(pcall(function() return require('contdyn').$made end))" >"$folder/lua" 2>&1 || true
    fi
    if command -v python3 >/dev/null; then
        PYTHONPATH="$SOURCE/bindings/python" \
            python3 -B -c "import contdyn; contdyn.$made" >"$folder/python" 2>&1 || true
    fi
    if command -v mcs >/dev/null && command -v mono >/dev/null; then
        echo "class Left { static void Main() { using (new Contdyn.$made) { } } }" >"$folder/left.cs"
        mcs -unsafe -out:"$folder/left.exe" "$folder/left.cs" "$SOURCE"/bindings/csharp/src/*.cs
        mono "$folder/left.exe" >"$folder/csharp" 2>&1 || true
        rm "$folder"/left.*
    fi
    for said in "$folder"/*; do
        grep -q "$left_out" "$said" || fail "$(basename "$said") says: $(cat "$said")"
    done
    rm -r "$folder"
}
gone=""
for part in "${all[@]}"; do
    case $part in
    CHAIN) gone+=" chain rope" ;;
    MEMBRANE) gone+=" membrane cloth coupled" ;;
    WATER) gone+=" water hulls advected" ;;
    HULL) gone+=" hulls" ;;
    *) gone+=" ${part,,}" ;;
    esac
done
[[ $gone != *rope* || $gone != *cloth* ]] || gone+=" contact" # which only these two have
echo '#include <contdyn/base.h>
int puts(const char*);
int main(void) { return puts(cd_build_info()) < 0; }' >"$out/info.c"
"$CC" -std=c11 "$out/info.c" -I"$SOURCE/include" "$out/src/libcontdyn.a" -lm -o "$out/info"
told=$("$out/info" | tr -d ,)
for word in chain rope membrane cloth water hulls bend contact coupled advected draw sleep save float32 float64; do
    expected=yes
    [[ " $gone " != *" $word "* ]] || expected=no
    found=no
    [[ " $told " != *" $word "* ]] || found=yes
    [ "$found" = "$expected" ] || fail "cd_build_info says: $told, is $word there? expected: $expected"
done
for part in "${all[@]}"; do
    case $part in
    CHAIN | MEMBRANE | WATER)
        dropped "cd_${part,,}_[a-z_]*"
        functions "$out/src/libcontdyn.a" cd_version | grep -q . || fail "cd_version is gone too"
        languages_tell "${part,,}"
        exit 0
        ;;
    ROPE) dropped 'RopeBundle<[0-9]*>' ;;
    CLOTH) dropped 'cloth_[a-z_]*' ;;
    HULL) dropped 'cd::[a-z]*_hulls(cd::Water[^)]*)' ;;
    BEND) dropped '[a-z0-9]*::\(rod_[a-z]*\|segment_rod_step\)(' ;;
    CONTACT) dropped 'cd::\(find_contacts\|take_pushes\|add_contacts\|settle_contacts\)(' ;;
    COUPLED) dropped 'cd::\(solve_coupled\|Multigrid::[a-z]*\|ShiftedLines::[a-z]*\)(' ;;
    ADVECTED) dropped '[a-z0-9]*::carry_across(' ;;
    DRAW) dropped 'cd::\(write_vertices\|write_indices\|index_count\)(' ;;
    SLEEP) dropped 'cd::\(choose_awake\|survey_awake\|mark_changed\)(' ;;
    SAVE) dropped 'cd::\(load_object<[^(]*\|save\|load\)(' ;;
    FLOAT32) dropped '[a-z_]*_numbers<float' ;;
    FLOAT64) dropped 'Plain[LR][a-z]*<double' ;; # what membranes and hulls keep for themselves is double
    *) fail "what is $part?" ;;
    esac
done
# States of the whole library load, but for those that need what was left out.
if [[ +$parts+ != *+SAVE+* && +$parts+ != *+FLOAT64+* ]]; then
    "$CC" -std=c11 "$here/saved.c" -I"$SOURCE/include" "$ARCHIVE" -lm -o "$out/writes"
    "$CC" -std=c11 "$here/saved.c" -I"$SOURCE/include" "$out/src/libcontdyn.a" -lm -o "$out/loads"
    mkdir "$out/states"
    "$out/writes" write "$out/states"
    while read -r part status; do
        expected=CD_OK
        case +$parts+ in
        *"+$part+"*) expected=CD_ERROR_UNSUPPORTED ;;
        *+ROPE+* | *+CLOTH+*) [ "$part" != CONTACT ] || continue ;; # one of the two has none
        esac
        [ "$status" = "$expected" ] || fail "a saved state that needs $part gives $status, not $expected"
    done < <("$out/loads" load "$out/states")
    expected="the rest length is 0"
    [[ +$parts+ != *+CONTACT+* ]] || expected="colliders are left out of this build"
    "$out/loads" touch . | grep -q "$expected" || fail "colliders are not refused with: $expected"
fi
"$CC" -std=c11 "$SOURCE/tests/bindings/conformance.c" -I"$SOURCE/bindings/conformance" -I"$SOURCE/include" \
    "$out/src/libcontdyn.a" -lm -o "$out/conformance"
"$out/conformance" --left-out "$SOURCE/bindings/conformance/scenes.txt" || fail "what is left is not as it should be"
