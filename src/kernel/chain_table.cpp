#include "kernel/table.hh"

namespace cd {
namespace CD_ISA {

const ChainKernels chain_kernels = {CD_SET,
                                    spring_sweep,
                                    CD_KERNEL(CD_WITH_BEND, rod_sweep),
                                    CD_KERNEL(CD_WITH_BEND, rod_step),
                                    CD_KERNEL(CD_WITH_BEND, advance),
                                    explicit_sweep,
                                    drift,
                                    segment_sweep,
                                    CD_KERNEL(CD_WITH_BEND, segment_rod_step),
                                    CD_KERNEL(CD_WITH_ROPE, rope_step)};

} // namespace CD_ISA
} // namespace cd
