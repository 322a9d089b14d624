#!/usr/bin/env bash
# check_start_up.sh FILE: fails if the library holds code to run when it is loaded or unloaded. An archive's objects may
# hold none at all; a shared library has one entry each way from the compiler's start-up files, and no more.
. "$(dirname "$0")/common.sh"

sections=$(sections_of "$1")
grep -q '^\.text' <<<"$sections" || fail "$1 holds no code"
case $1 in
*.a) kinds='preinit_array|init_array|fini_array|ctors|dtors|init|fini' most='0+' ;;
*) kinds='preinit_array|init_array|fini_array|ctors|dtors' most='0*[048]' ;;
esac
awk -v kinds="^[.]($kinds)([.]|\$)" -v most="^$most\$" '$1 ~ kinds && $2 !~ most' <<<"$sections" |
    fail_on_lines "runs at load or unload (section, size, flags, object):"
