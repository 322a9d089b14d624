// This file and the sweeps are compiled once per instruction set.
#include "kernel/kernels.hh"

#define CD_TEXT_(a) #a
#define CD_TEXT(a) CD_TEXT_(a)

namespace cd {
namespace CD_ISA {

extern const Kernels kernels;
const Kernels kernels = {
    CD_TEXT(CD_ISA),
#if CD_WITH_FLOAT32
    {spring_sweep<float>, rod_sweep<float>, advance<float>, explicit_sweep<float>, drift<float>},
#else
    {},
#endif
#if CD_WITH_FLOAT64
    {spring_sweep<double>, rod_sweep<double>, advance<double>, explicit_sweep<double>, drift<double>},
#else
    {},
#endif
};

} // namespace CD_ISA
} // namespace cd
