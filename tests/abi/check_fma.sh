#!/usr/bin/env bash
# check_fma.sh FILE: fails if the machine code holds a fused multiply-add. It rounds once where multiply and add round
# twice, so the result would not be the same on a machine without it.
. "$(dirname "$0")/common.sh"

# x86, AArch64 and RISC-V; 32-bit ARM; POWER
fused='[bv]?4?fn?c?m(ad|sub|sb|acc|sac|l[as])|vfn?m[as]\.|(x[sv]|v)n?m(add|sub)[afm]'
code=$("$OBJDUMP" -d --no-show-raw-insn "$1")
instruction='^ *[0-9a-f]+:[[:space:]]+'
grep -qE "${instruction}[a-z]" <<<"$code" || fail "$1 holds no code"
{ grep -E "$instruction($fused)" <<<"$code" || true; } | head -n 20 | fail_on_lines "fused multiply-add in $1:"
