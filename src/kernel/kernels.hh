// The kernels, compiled once per instruction set, as tables of functions: one for each kind of object, so that a
// program that makes only chains is linked with their kernels alone. All sets give the same bits.
#pragma once

#include "contdyn/base.h"
#include "kernel/advance.hh"
#include "kernel/cloth.hh"
#include "kernel/draw.hh"
#include "kernel/explicit_sweep.hh"
#include "kernel/rod_sweep.hh"
#include "kernel/rope_step.hh"
#include "kernel/segment_rod.hh"
#include "kernel/segment_sweep.hh"
#include "kernel/sheet.hh"
#include "kernel/spring_sweep.hh"
#include "kernel/water/sweep.hh"

namespace cd {

struct ChainKernels {
    cd_kernels set;
    decltype(&CD_ISA::spring_sweep) spring_sweep;
    decltype(&CD_ISA::rod_sweep) rod_sweep;
    decltype(&CD_ISA::rod_step) rod_step;
    decltype(&CD_ISA::advance) advance;
    decltype(&CD_ISA::explicit_sweep) explicit_sweep;
    decltype(&CD_ISA::drift) drift;
    decltype(&CD_ISA::segment_sweep) segment_sweep;
    decltype(&CD_ISA::segment_rod_step) segment_rod_step;
    decltype(&CD_ISA::rope_step) rope_step;
};

struct SheetKernels {
    decltype(&CD_ISA::gather) gather;
    decltype(&CD_ISA::push_separable) push_separable;
    decltype(&CD_ISA::push_general) push_general;
    decltype(&CD_ISA::move_nodes) move_nodes;
    decltype(&CD_ISA::sweep_down) sweep_down;
    decltype(&CD_ISA::sweep_up) sweep_up;
    decltype(&CD_ISA::look_beyond) look_beyond;
    decltype(&CD_ISA::step_rows) step_rows;
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
};

struct ClothKernels {
    decltype(&CD_ISA::cloth_residual) residual;
    decltype(&CD_ISA::cloth_smooth) smooth;
    decltype(&CD_ISA::cloth_unfold) unfold;
    decltype(&CD_ISA::cloth_gains) gains;
    decltype(&CD_ISA::cloth_apply) apply;
    decltype(&CD_ISA::cloth_bend) bend;
    decltype(&CD_ISA::cloth_blocks) blocks;
    decltype(&CD_ISA::cloth_factor) factor;
    decltype(&CD_ISA::cloth_solve) solve;
};

struct MembraneKernels {
    cd_kernels set;
    decltype(&CD_ISA::rod_sweep) rod_sweep;
    decltype(&CD_ISA::advance) advance;
    SheetKernels sheet;
    ClothKernels cloth;
    decltype(&CD_ISA::draw_sheet) draw;
};

struct WaterKernels {
    cd_kernels set;
    decltype(&CD_ISA::sweep_water) sweep;
    decltype(&CD_ISA::carry_across) carry_across;
    decltype(&CD_ISA::draw_water) draw;
};

// What the public function of that name tells, and the fastest of them.
uint32_t runnable_kernels();
cd_kernels fastest_kernels();

// A kind's table of that set; null for one that is not among the runnable ones.
template <class Table> const Table* kernels_of(cd_kernels set);
template <class Table> const Table& best_kernels() { return *kernels_of<Table>(fastest_kernels()); }

#if CD_WITH_AVX2
#define CD_OF_AVX2(table) &avx2::table
#else
#define CD_OF_AVX2(table) nullptr
#endif
#if CD_WITH_AVX512
#define CD_OF_AVX512(table) &avx512::table
#else
#define CD_OF_AVX512(table) nullptr
#endif

#define CD_TABLES(Table, table)                                                                \
    namespace plain {                                                                          \
    extern const Table table;                                                                  \
    }                                                                                          \
    namespace avx2 {                                                                           \
    extern const Table table;                                                                  \
    }                                                                                          \
    namespace avx512 {                                                                         \
    extern const Table table;                                                                  \
    }                                                                                          \
    template <> inline const Table* kernels_of<Table>(cd_kernels set) {                        \
        const Table* const tables[] = {&plain::table, CD_OF_AVX2(table), CD_OF_AVX512(table)}; \
        return (runnable_kernels() >> set & 1) != 0 ? tables[set] : nullptr;                   \
    }

CD_TABLES(ChainKernels, chain_kernels)
CD_TABLES(MembraneKernels, membrane_kernels)
CD_TABLES(WaterKernels, water_kernels)

#undef CD_OF_AVX2
#undef CD_OF_AVX512
#undef CD_TABLES

} // namespace cd
