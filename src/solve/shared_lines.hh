// Lines of a sheet that all have the same masses, springs and bends: one factorization, exact to the last digits.
#pragma once

#include "contdyn/base.h"
#include "kernel/kernels.hh"
#include "solve/planes.hh"
#include "solve/ring_closure.hh"
#include "solve/rod_line.hh"
#include "solve/spring_line.hh"

namespace cd {

struct SharedLines {
    size_t nodes;
    bool is_rod, ring;
    double *none, *carry, *pull; // none: zeros
    RodRows rod;
    double* response[4]; // the last one is scratch
    unsigned char* pin;
    RingClosure* closure; // among the coefficients too: it is made with them

    SharedLines(size_t nodes, bool bend, bool ring, Carver& carve);

    // System: double ground(i), spring(i), bend(i), of a ring as many springs as nodes; constraints: 3 with bend, else
    // 1.
    template <class System> void factor(const System& system, bool bend) {
        if (!is_rod) {
            factor_spring_line(nodes, system, carry, pull);
            pull[nodes - 1] = 0; // and beyond, for sweeps that take whole tiles
            for (size_t i = nodes; i % 8 != 0; ++i) carry[i] = pull[i] = 0;
            return;
        }
        factor_rod_line(nodes, system, rod);
        for (size_t i = 0; i < nodes; ++i)
            pin[i] = system.ground(i) - system.ground(i) == 0 ? CD_NODE_FREE : CD_NODE_PINNED;
        if (!ring) return;
        *closure = {};
        const double stiffness[3] = {system.spring(nodes - 1), system.bend(nodes - 1), system.bend(0)};
        factor_ring(nodes, system, rod, bend ? 3 : 1, stiffness, response, response[3], *closure);
    }

    // plane: in, what each node would do alone; out, the answer. Lines run down the columns of grid. slope: scratch of
    // a rod's, a plane.
    void solve(const MembraneKernels& kernels, const cd_parallel& parallel, const Grid& grid, double* plane,
               double* slope) const;
};

} // namespace cd
