// One explicit step of a bundle of lines: v += dt M^-1 F(x, v), and x by the old velocity or the new.
#pragma once

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

// What the position moves by.
enum class Carrier { kOldVelocity, kNewVelocity, kNothing };

struct ExplicitCoefficients {
    const double* stiffness; // [N/m] of each spring, 0 where welded; of a ring as many as nodes
    const double* bend;      // [N/m] of each node, 0 where there is none; null: no bend
    const double* inertia;   // dt / mass [s/kg]; 0 where held
    NodeGains gains;         // of what changes v directly
    double damping;          // [s]
    bool ring;
    bool uniform = false; // springs are alike, and inertia and gravity's gain of all nodes but the ends
};

namespace CD_ISA {

// gravity: dt g per component. False if a number left the finite range.
bool explicit_sweep(const Lines& lines, const ExplicitCoefficients& c, double dt, const double* gravity,
                    Carrier carrier, size_t first, size_t count);

// x += dt v. False if a number left the finite range.
bool drift(const Lines& lines, double dt, size_t first, size_t count);

} // namespace CD_ISA
} // namespace cd
