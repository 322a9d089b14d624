// This file and the sweeps are compiled once per instruction set.
#include "kernel/kernels.hh"

#ifndef CD_SET
#define CD_SET CD_KERNELS_PLAIN // what CD_ISA is in the public header
#endif

namespace cd {
namespace CD_ISA {

extern const Kernels kernels;
const Kernels kernels = {
    CD_SET,
#if CD_WITH_CHAIN
    {spring_sweep, rod_sweep, rod_step, advance, explicit_sweep, drift, segment_sweep, segment_rod_step},
#elif CD_WITH_MEMBRANE
    {nullptr, rod_sweep, nullptr, advance, nullptr, nullptr, nullptr, nullptr},
#else
    {},
#endif
#if CD_WITH_ROPE
    rope_step,
#else
    nullptr,
#endif
#if CD_WITH_MEMBRANE
    {gather,         push_separable, push_general, move_nodes, sweep_down, sweep_up,    look_beyond,  step_rows,
     pull_separable, pull_general,   apply,        moments,    energies,   solve_lines, filter_lines, smooth_lines,
     shift_down,     shift_up,       transpose,    combine,    multiply,   wrap,        dot,          aggregate,
     spread},
#else
    {},
#endif
#if CD_WITH_CLOTH
    {cloth_residual, cloth_unfold, cloth_apply, cloth_bend, cloth_blocks, cloth_factor, cloth_solve},
#else
    {},
#endif
#if CD_WITH_WATER
    {sweep_water, carry_across},
#else
    {},
#endif
};

} // namespace CD_ISA
} // namespace cd
