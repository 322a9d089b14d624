#!/usr/bin/env bash
# check_needed.sh LIBRARY: fails if the shared library needs anything but libc and libm. On AArch64 the loader may be
# needed too: there it holds the stack protector's guard, which some compilers use unasked.
. "$(dirname "$0")/common.sh"

dynamic=$("$READELF" -dW "$1")
grep -q 'SONAME\|NEEDED' <<<"$dynamic" || fail "$1 is no shared library"
sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' <<<"$dynamic" |
    { grep -vE '^(libc|libm|ld-linux-aarch64|libc\.musl-[a-z0-9_]*)\.so(\.[0-9]+)?$' || true; } |
    fail_on_lines "$1 needs more than libc and libm:"
