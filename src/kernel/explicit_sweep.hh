// One explicit step of a bundle of lines: v += dt M^-1 F(x, v), and x by the old velocity or the new.
#pragma once

#include "kernel/lines.hh"

namespace cd {

// What the position moves by.
enum class Carrier { kOldVelocity, kNewVelocity, kNothing };

template <class T> struct ExplicitCoefficients {
    const T* stiffness;         // [N/m] of each spring, 0 where welded; of a ring as many as nodes
    const T* bend;              // [N/m] of each node, 0 where there is none; null: no bend
    const T* inertia;           // dt / mass [s/kg]; 0 where held
    NodeGains<T> gains;         // of what changes v directly
    T damping;                  // [s]
    bool ring;
};

// gravity: dt g per component. False if a number left the finite range.
template <class T>
bool explicit_sweep(const Lines<T>& lines, const ExplicitCoefficients<T>& c, T dt, const T* gravity, Carrier carrier,
                    size_t first, size_t count);

// x += dt v.
template <class T> void drift(const Lines<T>& lines, T dt, size_t first, size_t count);

} // namespace cd
