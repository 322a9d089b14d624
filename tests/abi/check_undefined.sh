#!/usr/bin/env bash
# check_undefined.sh FILE: fails if a shared library or an archive calls into the run time of C++ or of atomics, calls
# what aborts, exits or prints, or calls what rounds differently from one libm to the next.
. "$(dirname "$0")/common.sh"

case $1 in
*.a) undefined=$("$NM" --undefined-only --format=posix "$1") ;;
*) undefined=$("$NM" -D --undefined-only --format=posix "$1") ;;
esac
undefined=$(awk 'NF > 1 { sub(/@.*/, "", $1); print $1, $2 }' <<<"$undefined" | sort -u)
[ -n "$undefined" ] || fail "$1 refers to nothing outside: not even to libc"

# crtbeginS.o, the compiler's own part of every shared library, refers to __cxa_finalize weakly.
run_time='^(_Zn|_Zd|_ZSt|_ZNSt|_ZNKSt|_ZTVN10__cxxabiv1|__cxa_|__gxx_|__gcc_personality|_Unwind_|'
run_time+='__aarch64_(cas|swp|ld))'
grep -v '^__cxa_finalize w$' <<<"$undefined" | { grep -E "$run_time" || true; } |
    fail_on_lines "$1 needs the compiler's run time:"

loud='^(abort|_?_?exit|_Exit|quick_exit|raise|__assert_fail|puts|putchar|putc|fput[cs]|fwrite|perror|std(out|err)|'
loud+='(__)?v?f?d?printf(_chk)?) '
{ grep -E "$loud" <<<"$undefined" || true; } | fail_on_lines "$1 aborts, exits or prints:"

inexact='^(a?(sin|cos|tan)h?|atan2|sincos|exp(2|10|m1)?|log(2|10|1p)?|pow|cbrt|hypot|erfc?|[lt]gamma|fma)[fl]? '
{ grep -E "$inexact" <<<"$undefined" || true; } | fail_on_lines "$1 gives other numbers with another libm:"
