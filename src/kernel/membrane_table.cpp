#include "kernel/table.hh"

namespace cd {
namespace CD_ISA {

const MembraneKernels membrane_kernels = {
    CD_SET,
    CD_KERNEL(CD_WITH_BEND, rod_sweep),
    CD_KERNEL(CD_WITH_BEND, advance),
    {gather,
     push_separable,
     push_general,
     move_nodes,
     sweep_down,
     sweep_up,
     look_beyond,
     step_rows,
     pull_separable,
     pull_general,
     apply,
     CD_KERNEL(CD_WITH_BEND, moments),
     energies,
     solve_lines,
     filter_lines,
     CD_KERNEL(CD_WITH_COUPLED, smooth_lines),
     CD_KERNEL(CD_WITH_COUPLED, shift_down),
     CD_KERNEL(CD_WITH_COUPLED, shift_up),
     transpose,
     combine,
     multiply,
     wrap,
     dot,
     CD_KERNEL(CD_WITH_COUPLED, aggregate),
     CD_KERNEL(CD_WITH_COUPLED, spread)},
#if CD_WITH_CLOTH
    {cloth_residual, cloth_smooth, cloth_unfold, cloth_gains, cloth_apply, CD_KERNEL(CD_WITH_BEND, cloth_bend),
     cloth_blocks, cloth_factor, cloth_solve},
#else
    {},
#endif
    CD_KERNEL(CD_WITH_DRAW, draw_sheet),
};

} // namespace CD_ISA
} // namespace cd
