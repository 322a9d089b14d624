// The kernels, compiled once per instruction set, as tables of functions. All give the same bits.
#pragma once

#include "kernel/advance.hh"
#include "kernel/explicit_sweep.hh"
#include "kernel/rod_sweep.hh"
#include "kernel/spring_sweep.hh"

namespace cd {

template <class T> struct LineKernels {
    bool (*spring_sweep)(const Lines<T>&, const SpringCoefficients&, const Stage&, const Start&, double*, bool, size_t,
                         size_t);
    void (*rod_sweep)(const Lines<T>&, const RodCoefficients&, const Stage&, const Start&, double*, double*, size_t,
                      size_t);
    bool (*advance)(const Lines<T>&, const Stage&, const Start&, const RingClosure&, double*, bool, size_t, size_t);
    bool (*explicit_sweep)(const Lines<T>&, const ExplicitCoefficients&, double, const double*, Carrier, size_t,
                           size_t);
    void (*drift)(const Lines<T>&, double, size_t, size_t);
};

struct Kernels {
    const char* name;           // of the instruction set
    LineKernels<float> float32; // null where the precision is left out
    LineKernels<double> float64;

    const LineKernels<float>& of(float) const { return float32; }
    const LineKernels<double>& of(double) const { return float64; }
};

// The kernels this processor can run, in out, at most kKernelSets; the fastest last. Returns how many.
constexpr size_t kKernelSets = 3;
size_t runnable_kernels(const Kernels** out);

// The fastest of them.
const Kernels& best_kernels();

} // namespace cd
