#!/usr/bin/env bash
# check_apart.sh ARCHIVE PREFIX KIND...: fails unless a program that calls all public functions of one kind of object,
# PREFIX_KIND_*, linked with the archive, holds nothing that belongs to another kind: no name with that kind in it.
. "$(dirname "$0")/common.sh"

archive=$1 prefix=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for kind in "$@"; do
    functions=$("$NM" --defined-only "$archive" 2>/dev/null |
        sed -n "s/^.* T \(${prefix}_${kind}_[a-z0-9_]*\)$/\1/p" | sort -u)
    [ -n "$functions" ] || fail "$archive has no function of a $kind"
    {
        printf 'int %s();\n' $functions # their types do not matter to the linker
        printf 'void* const called[] = {\n'
        printf '    (void*)%s,\n' $functions
        printf '};\nint main(void) { return called[0] == 0; }\n'
    } >"$work/$kind.c"
    "$CC" -w -std=c99 "$work/$kind.c" "$archive" -lm -o "$work/$kind"
    for other in "$@"; do
        [ "$other" = "$kind" ] || "$NM" -C --defined-only "$work/$kind" | { grep -i "$other" || true; } |
            fail_on_lines "a program with a $kind alone has of a $other:"
    done
    echo "$kind: $(stat -c %s "$work/$kind") bytes"
done
