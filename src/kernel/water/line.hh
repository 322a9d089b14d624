// One step of water along lines that are worked on side by side, on panels.
//
// Cells are numbered 0 to n - 1, faces 0 to n; face i lies between the cells i - 1 and i, in a ring face n is face 0.
// The state is a depth per cell and a velocity per face (an Arakawa C grid); a flux is what goes through a face in the
// step, as the depth [m] that it adds to the cell behind the face and takes from the one before.
//
//   0. dry faces   take the velocity of the open faces beside them                                         velocity.hh
//   1. push        w = keep u + push (force dt - g c rise): friction and the slope of the present surface   face.hh
//   2. depth       D of every face, between its giver's and the mean of both                                face.hh
//   3. surface     fluxes q = c D (theta w + (1 - theta) u) + what the changes of depth add to them         surface.hh
//   4. limit       where a depth would come out negative: fluxes of first order, and as much more as fits   limiter.hh
//   5. velocity    keep u + push (force dt - g c [(1 - theta) rise before + theta rise after])              velocity.hh
//   6. carry       advected momentum goes with the fluxes, half of it with old velocities, half with new    momentum.hh
//
// c = dt / cell. Explicit steps are the same but for the changes of the surface in 3: with theta = 1/2 half a push, the
// fluxes, and the other half (velocity Verlet).
#pragma once

#include "kernel/water/face.hh"
#include "kernel/water/panels.hh"
#include "kernel/water/side.hh"

namespace cd {
namespace CD_ISA {

// The equation of a flux q: q = flux + left x_l - right x_r, x the changes of the cells beside it.
struct Face {
    L flux, left, right;
};

// The passes along a line work on copies of it: of those the compiler knows that no panel lies over them, and their
// members stay in registers.
struct WaterLine {
    WaterSweep sweep;
    size_t n;
    bool ring;

    L courant{}, share{};  // dt / cell of the part of the step that is made [s/m]; its share of dt
    L full_push{};         // what a rise of the surface after the step takes off a velocity where nothing acts on it
    L is_long{};           // > 0: in it waves cross more than a cell
    bool any_long = false; // of the lanes

    Panel bed{}, depth{}, velocity{};
    Panel acceleration{}, opening{}; // of faces, opening 1 or 0; null: nothing pushes, all are open
    Panel across{};                  // of cells, velocity of the other axis; null: friction does not ask for it
    Panel load{}, stiff{};           // of cells: hulls press with a head of load + stiff depth; null: there are none
    Panel flux{}, after{}, speed{};  // results: of cells `after`, of faces flux and velocity
    Panel push{};                    // the part of a push that friction leaves, 0 at closed faces; null: all of it
    Panel pushed{};                  // scratch of carry(), where there is friction
    Panel even{};                    // of cells: depths that slopes move with (momentum.hh)
    Panel pull{}, spare[2] = {};     // scratch

    Face side[2] = {};      // the faces at the ends; of a ring face 0
    L side_depth[2] = {};   // of what crosses them
    L tally[kTallies] = {}; // by WaterTally
    L rough{}, bounds{};    // > 0 in lines that are not smooth, and for which the energy bound counts (velocity.hh)
    L limits{}; // > 0 in lines that the limiter counts for, of whose fluxes `pull` holds the parts that it has left

    size_t first_face() const { return ring ? 0 : 1; }
    Neighbours cells() const { return {n, ring}; }
    Neighbours faces() const { return {ring ? n : n + 1, ring}; }
    // The cells beside a face; beside one at an end the only one twice.
    size_t left(size_t face) const { return cells().before(face); }
    size_t right(size_t face) const { return face < n ? face : ring ? 0 : n - 1; }
    Beside beside(size_t face, const Panel& depths) const {
        return {{bed[left(face)], depths[left(face)]}, {bed[face], depths[face]}};
    }
    Beside beside(size_t face) const { return beside(face, depth); }
    Beside beside_after(size_t face) const { return beside(face, after); }
    bool pressed() const { return CD_WITH_HULL && load; }
    // How far the surface rises across face i, and the head that hulls press with (model.md, 52).
    L full_rise(size_t i, const Beside& c) const {
        const L rise = (c.r.bed - c.l.bed) + (c.r.depth - c.l.depth);
        if (!pressed()) return rise;
        return rise + ((load[i] - load[left(i)]) + (stiff[i] * c.r.depth - stiff[left(i)] * c.l.depth));
    }
    // As far as it pushes water: a dry bed pushes nothing, water pushes onto it.
    L pushing_rise(size_t i, const Beside& c) const {
        const L rise = full_rise(i, c);
        return select(select(rise, c.r.depth, c.l.depth), rise, L{});
    }
    L open(size_t face) const { return opening ? opening[face] : L::splat(1); }
    // Where friction takes all of a velocity, what moves and pushes water there is by the end of the step, as friction is.
    L theta_of(L part) const {
        const L theta = L::splat(sweep.theta);
        return sweep.implicit ? larger(theta, L::splat(1) - part) : theta;
    }
    // What a rise of the surface before the step takes off the velocity of an inner face, and one after it.
    L early_push(size_t i) const {
        const L all = sweep.gravity * courant;
        return push ? (L::splat(1) - theta_of(push[i])) * (all * push[i]) : (1 - sweep.theta) * all;
    }
    L late_push(size_t i) const { return push ? theta_of(push[i]) * ((sweep.gravity * courant) * push[i]) : full_push; }
    // Cells after the fluxes.
    void fill_again() {
        for (size_t i = 0; i < n; ++i) after.put(i, larger(L{}, depth[i] + (flux[i] - flux[i + 1])));
    }

    // surface.hh
    Face inner_face(size_t i, L stream);
    L inflow_depth(const WaterEnd& end, L cell) const;
    Face end_face(int e); // at the beginning or the end
    void solve_surface();
    void close_ring();
    L fill();

    // limiter.hh
    void limit(L need); // lines in which need > 0

    // velocity.hh
    void follow_water(L moves, Panel depths, Panel u, Panel out) const; // lines in which moves > 0
    L lift(size_t face) const;
    L more_lift(size_t face) const;
    L gained(size_t face) const;
    L bounded_depth(size_t face) const;
    L depth_before(size_t face) const;
    L depth_after(size_t face) const;
    L bounded(size_t i, L w) const;
    void balance();
    void set_velocities();
    void keep_energy();
    void end_velocities();

    // momentum.hh
    L even_depth(size_t cell) const;
    L sloped(size_t cell, L through) const;
    void carry();

    void step() {
        rough = bounds = limits = L{};
        solve_surface();
        const L least = fill();
        if (any_positive(-least)) limit(-least);
        if (any_long) balance();
        if (!ring) end_velocities();
        if (sweep.advected()) carry();
        else set_velocities();
        if (ring) speed.put(n, speed[0]);
    }
};

} // namespace CD_ISA
} // namespace cd
