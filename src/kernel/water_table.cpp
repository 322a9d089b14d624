#include "kernel/table.hh"

namespace cd {
namespace CD_ISA {

const WaterKernels water_kernels = {CD_SET, sweep_water, CD_KERNEL(CD_WITH_ADVECTED, carry_across),
                                    CD_KERNEL(CD_WITH_DRAW, draw_water)};

} // namespace CD_ISA
} // namespace cd
