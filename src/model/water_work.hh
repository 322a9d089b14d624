// What steps of a water work with: runs of its scratch memory, and the ways to its lines.
#pragma once

#include "base/parallel.hh"
#include "base/sum.hh"
#include "kernel/lines.hh"
#include "model/water.hh"
#include "solve/conjugate_gradients.hh"

namespace cd {

// Of steps that work on both axes at once.
struct WaterTogether {
    WaterPlanes planes[2]; // of an axis' faces
    double *load, *change; // of cells: what is left of the loads takes the shares too
    // of coupled steps
    double *ground, *spring[2], *stores; // stores: 1 of cells that hold water at the end of the step
    double noise = 0;                    // depth [m]: what the solve left undone
    SheetSystem system;
    Preconditioner preconditioner;
    GradientPlanes gradient;
};

struct WaterWork {
    bool together, coupled;
    bool thins = false;        // the surface of this step is solved for with cells running dry
    Grid grid;                 // of faces
    size_t tasks[2], per_task; // along each axis; numbers
    double *task, *tally;      // tasks lie per_task numbers apart; kTallies numbers per line
    double *held, *moved[2];   // planes, where velocities are carried across: depths before, and through faces
    WaterTogether both;
    double done = 0; // steps made in this call

    WaterWork(const Water& w, const WaterFeatures& f, Carver& coefficients, Carver& scratch);
};

inline size_t lines_of(const Water& w, Axis a) { return w.cells[other(a)]; }

template <class T> struct WaterStepper {
    Water& w;
    WaterWork& work;
    double dt;
    Convergence worst; // of all coupled solves
    bool finite = true;

    const WaterKernels<T>& kernels() const { return w.kernels->water_of(T()); }
    size_t stride(Axis a) const { return a == kX ? 1 : w.pitch; }
    size_t byte_stride(Axis a) const { return a == kX ? 1 : w.cells[kX] + 1; }

    // body(where to work, first pack, count) for all packs of lines, which says whether all came out finite.
    template <class Body> void in_tasks(Axis a, size_t lines, const Body& body) {
        const size_t packs = water_packs(lines), tasks = work.tasks[a] < packs ? work.tasks[a] : packs;
        auto task = [&](size_t t) {
            const size_t first = packs * t / tasks, end = packs * (t + 1) / tasks;
            if (!body(work.task + t * work.per_task, first, end - first))
                __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
        };
        parallel_for(w.parallel, tasks, task);
    }

    // The explicit step moves the water with the new velocities, which the old surface has pushed.
    double lambda() const {
        return w.method == CD_METHOD_IMPLICIT ? w.lambda : w.method == CD_METHOD_FORWARD_EULER ? 0 : 1;
    }

    // When sides count: counted as the clock does, however steps share calls.
    double time() const {
        const double here = work.done + lambda();
        if (w.clock.dt != dt) return w.clock.time() + here * dt;
        return w.clock.start + (double(w.clock.counted) + here) * dt;
    }

    WaterEnd end_of(Axis a, bool at_last) const {
        const WaterSide& side = w.side[side_of(a, at_last)];
        const double value = side_value(side, time());
        switch (side.kind) {
        case CD_BORDER_OPEN: return {End::kOpen, value, 0};
        case CD_BORDER_INFLOW: return {End::kInflow, 0, value * dt / w.size[a]};
        case CD_BORDER_PERIODIC: return {End::kRing, 0, 0};
        default: return {End::kWall, 0, 0};
        }
    }

    WaterAxis axis_of_step(Axis a) const {
        return {w.cells[a],
                dt / w.size[a],
                lambda(),
                w.method == CD_METHOD_IMPLICIT ? w.lambda : 0,
                w.gravity,
                dt * w.drag,
                dt * w.gravity * w.manning * w.manning,
                w.momentum == CD_MOMENTUM_ADVECTED,
                w.corrections,
                work.thins,
                {end_of(a, false), end_of(a, true)}};
    }

    WaterLines<T> lines_along(Axis a) const {
        WaterLines<T> lines{};
        lines.lines = lines_of(w, a);
        lines.along = stride(a), lines.across = stride(other(a));
        lines.byte_along = byte_stride(a), lines.byte_across = byte_stride(other(a));
        lines.depth = numbers<T>(w.depth), lines.bed = numbers<T>(w.bed), lines.velocity = numbers<T>(w.velocity[a]);
        lines.pressure = numbers<T>(w.pressure), lines.force = numbers<T>(w.force[a]);
        lines.force_share = dt, lines.pressure_share = dt / (w.density * w.size[a]);
        lines.mask = w.mask.data, lines.wall = w.wall[a].data;
        lines.tally = work.tally;
        return lines;
    }

    // What moves along `a` carries of the velocities across it, which lie on the faces between the lines.
    void carry(Axis a) {
        const size_t last = w.cells[other(a)] - 1, step = stride(other(a));
        if (last > 0) carry_faces(a, 1, last, 0);
        if (!periodic(w, other(a))) return;
        carry_faces(a, 0, 1, last);
        T* const v = numbers<T>(w.velocity[other(a)]); // the faces 0 and n are one
        for (size_t i = 0; i < w.cells[a]; ++i) v[i * stride(a) + (last + 1) * step] = v[i * stride(a)];
    }

    // The faces [first, first + count) between lines, and the line of cells before the first one.
    void carry_faces(Axis a, size_t first, size_t count, size_t before) {
        const Axis across = other(a);
        const size_t here = first * stride(across), there = before * stride(across);
        const size_t byte_here = first * byte_stride(across), byte_there = before * byte_stride(across);
        const uint8_t *const mask = w.mask.data, *const wall = w.wall[across].data;
        const WaterCarried<T> carried{w.cells[a],
                                      count,
                                      stride(a),
                                      stride(across),
                                      periodic(w, a),
                                      numbers<T>(w.velocity[across]) + here,
                                      {work.held + there, work.held + here},
                                      {work.moved[a] + there, work.moved[a] + here},
                                      {mask ? mask + byte_there : nullptr, mask ? mask + byte_here : nullptr},
                                      wall ? wall + byte_here : nullptr,
                                      byte_stride(a),
                                      byte_stride(across)};
        in_tasks(a, count, [&](double* place, size_t from, size_t packs) {
            return kernels().carry_across(carried, place, from, packs);
        });
    }

    // Adds up what `lines` lines have to tell. Solves are made line by line, and counted once.
    void count_up(size_t lines) {
        Sum sums[kSolves];
        double solves = 0;
        for (size_t k = 0; k < lines; ++k) {
            const double* const t = work.tally + k * kTallies;
            for (int which = 0; which < kSolves; ++which)
                if (t[which] != 0) sums[which].add(t[which]); // seldom
            solves = t[kSolves] > solves ? t[kSolves] : solves;
        }
        w.account.in += sums[kIn].value() * cell_area(w);
        w.account.out += sums[kOut].value() * cell_area(w);
        w.limited_volume += sums[kHeldBack].value() * cell_area(w);
        w.limited_cells += uint64_t(sums[kLimited].value());
        w.factorizations += uint64_t(solves);
    }

    void step_together(); // water_together.cpp
    // of its steps in which cells may run dry, water_downstream.cpp
    void hold_streams();
    bool settle_residual(const WaterCells& cells);
    void hand_on(const double* owed);
    void carry_at_once(const WaterCells& cells, Axis a);
};

} // namespace cd
