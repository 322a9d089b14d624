// This file and the sweeps are compiled once per instruction set.
#include "kernel/kernels.hh"

#ifndef CD_SET
#define CD_SET CD_KERNELS_PLAIN // what CD_ISA is in the public header
#endif

namespace cd {
namespace CD_ISA {

#if CD_WITH_MEMBRANE
template <class T> constexpr SheetStateKernels<T> state_kernels() {
    return {gather<T>,
            push_separable<T, T>,
            push_general<T, T>,
            move_nodes<T, T>,
            move_nodes<T, double>,
            gather<double>,
            push_separable<double, T>,
            push_general<double, T>,
            move_nodes<double, T>,
            sweep_down<T, T>,
            sweep_down<double, T>,
            sweep_up<T, T>,
            sweep_up<T, double>,
            sweep_up<double, T>,
            look_beyond<T>,
            step_rows<T>};
}
#endif

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
    {pull_separable, pull_general, apply, moments, energies, solve_lines, filter_lines, smooth_lines, shift_down,
     shift_up, transpose, combine, multiply, wrap, dot, aggregate, spread,
#if CD_WITH_FLOAT32
     state_kernels<float>(),
#else
     {},
#endif
#if CD_WITH_FLOAT64
     state_kernels<double>()
#else
     {}
#endif
    },
#else
    {},
#endif
#if CD_WITH_CLOTH
    {cloth_residual, cloth_unfold, cloth_apply, cloth_bend, cloth_blocks, cloth_factor, cloth_solve},
#else
    {},
#endif
#if CD_WITH_WATER && CD_WITH_FLOAT32
    {sweep_water<float>, carry_across<float>},
#else
    {},
#endif
#if CD_WITH_WATER && CD_WITH_FLOAT64
    {sweep_water<double>, carry_across<double>},
#else
    {},
#endif
};

} // namespace CD_ISA
} // namespace cd
