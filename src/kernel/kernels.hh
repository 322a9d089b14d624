// The kernels, compiled once per instruction set, as tables of functions. All give the same bits.
#pragma once

#include "contdyn/base.h"
#include "kernel/advance.hh"
#include "kernel/cloth.hh"
#include "kernel/explicit_sweep.hh"
#include "kernel/rod_sweep.hh"
#include "kernel/rope_step.hh"
#include "kernel/segment_rod.hh"
#include "kernel/segment_sweep.hh"
#include "kernel/sheet.hh"
#include "kernel/spring_sweep.hh"
#include "kernel/water/sweep.hh"

namespace cd {

struct LineKernels {
    decltype(&CD_ISA::spring_sweep) spring_sweep;
    decltype(&CD_ISA::rod_sweep) rod_sweep;
    decltype(&CD_ISA::rod_step) rod_step;
    decltype(&CD_ISA::advance) advance;
    decltype(&CD_ISA::explicit_sweep) explicit_sweep;
    decltype(&CD_ISA::drift) drift;
    decltype(&CD_ISA::segment_sweep) segment_sweep;
    decltype(&CD_ISA::segment_rod_step) segment_rod_step;
};

// Of the state of a sheet; those on double planes begin stages between two others.
template <class T> struct SheetStateKernels {
    void (*gather)(const Grid&, const SheetGather&, const T*, const T*, size_t, size_t);
    void (*push_separable)(const Grid&, const SeparableSheet&, const SheetPush<T>&, const T*, double*, size_t, size_t);
    void (*push_general)(const Grid&, const GeneralSheet&, const SheetPush<T>&, const T*, const T*, double*, size_t,
                         size_t);
    bool (*move)(const Grid&, const SheetMove&, const T*, const T*, T*, T*, size_t, size_t);
    bool (*keep)(const Grid&, const SheetMove&, const T*, const T*, double*, double*, size_t, size_t);
    void (*gather_kept)(const Grid&, const SheetGather&, const double*, const double*, size_t, size_t);
    void (*push_separable_kept)(const Grid&, const SeparableSheet&, const SheetPush<T>&, const double*, double*, size_t,
                                size_t);
    void (*push_general_kept)(const Grid&, const GeneralSheet&, const SheetPush<T>&, const double*, const double*,
                              double*, size_t, size_t);
    bool (*move_kept)(const Grid&, const SheetMove&, const double*, const double*, T*, T*, size_t, size_t);
    void (*down)(const Grid&, const UniformStage<T>&, const T*, const T*, double*, double*, size_t, size_t);
    void (*down_kept)(const Grid&, const UniformStage<T>&, const double*, const double*, double*, double*, size_t,
                      size_t);
    bool (*up)(const Grid&, const SharedFilter&, bool, const SheetMove&, double*, double*, const T*, const T*, T*, T*,
               size_t, size_t);
    bool (*up_keep)(const Grid&, const SharedFilter&, bool, const SheetMove&, double*, double*, const T*, const T*,
                    double*, double*, size_t, size_t);
    bool (*up_kept)(const Grid&, const SharedFilter&, bool, const SheetMove&, double*, double*, const double*,
                    const double*, T*, T*, size_t, size_t);
    void (*look_beyond)(const Grid&, const UniformStage<T>&, const SheetMove&, T*, T*, double*, size_t, size_t);
    bool (*step_rows)(const Grid&, const UniformStage<T>&, const SheetMove&, T*, T*, double*, size_t, size_t);
};

struct SheetKernels {
    decltype(&CD_ISA::pull_separable) pull_separable;
    decltype(&CD_ISA::pull_general) pull_general;
    decltype(&CD_ISA::apply) apply;
    decltype(&CD_ISA::moments) moments;
    decltype(&CD_ISA::energies) energies;
    decltype(&CD_ISA::solve_lines) solve_lines;
    decltype(&CD_ISA::filter_lines) filter_lines;
    decltype(&CD_ISA::smooth_lines) smooth_lines;
    decltype(&CD_ISA::shift_down) shift_down;
    decltype(&CD_ISA::shift_up) shift_up;
    decltype(&CD_ISA::transpose) transpose;
    decltype(&CD_ISA::combine) combine;
    decltype(&CD_ISA::multiply) multiply;
    decltype(&CD_ISA::wrap) wrap;
    decltype(&CD_ISA::dot) dot;
    decltype(&CD_ISA::aggregate) aggregate;
    decltype(&CD_ISA::spread) spread;
    SheetStateKernels<float> float32; // null where the precision is left out
    SheetStateKernels<double> float64;

    const SheetStateKernels<float>& of(float) const { return float32; }
    const SheetStateKernels<double>& of(double) const { return float64; }
};

struct ClothKernels {
    decltype(&CD_ISA::cloth_residual) residual;
    decltype(&CD_ISA::cloth_unfold) unfold;
    decltype(&CD_ISA::cloth_apply) apply;
    decltype(&CD_ISA::cloth_bend) bend;
    decltype(&CD_ISA::cloth_blocks) blocks;
    decltype(&CD_ISA::cloth_factor) factor;
    decltype(&CD_ISA::cloth_solve) solve;
};

template <class T> struct WaterKernels {
    bool (*sweep)(const WaterSweep&, const WaterLines<T>&, double*, size_t, size_t);
    bool (*carry_across)(const WaterAcross<T>&, double*, size_t, size_t);
};

struct Kernels {
    cd_kernels set;
    LineKernels line;
    decltype(&CD_ISA::rope_step) rope_step;
    SheetKernels sheet;
    ClothKernels cloth;
    WaterKernels<float> water32;
    WaterKernels<double> water64;

    const WaterKernels<float>& water_of(float) const { return water32; }
    const WaterKernels<double>& water_of(double) const { return water64; }
};

// What the public function of that name tells.
uint32_t runnable_kernels();

// A table; null for one that is not among them.
const Kernels* kernels_of(cd_kernels set);

// The fastest of them.
const Kernels& best_kernels();

} // namespace cd
