// One step of water along N lines that are worked on side by side, on panels.
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
//   6. carry       advected momentum goes with the fluxes, half of it with old velocities, half with new    carry.hh
//
// c = dt / cell. Explicit steps are the same but for the changes of the surface in 3: with theta = 1/2 half a push, the
// fluxes, and the other half (velocity Verlet).
#pragma once

#include "kernel/water/face.hh"
#include "kernel/water/panels.hh"
#include "kernel/water/side.hh"

namespace cd {
namespace CD_ISA {

// A line makes its step in 1, 2, 4, ... parts, of which each moves its water by at most so many cells, as far as that
// takes no more than the most.
constexpr double kPartRun = 0.5;
constexpr int kMostParts = 64;
// In a part in which waves cross more than a cell, a long one, velocities are pushed before they are carried, and no
// face gains more energy than its water loses by falling. What resolves waves, the acceleration of a stream along its
// line in its fluxes and the slope of velocities within cells, counts in full up to this square of cells, and fades out
// to none at 1.
constexpr double kResolved = 0.8;

// What kind of step lines make, from how many parts they make it in and how deep they are.
template <int N> struct StepKind {
    Lanes<N> courant, share; // dt / cell of a part [s/m]; its share of dt
    Lanes<N> is_long;        // > 0: yes
    Lanes<N> resolves;       // 0 to 1
    bool any_long;           // of the lanes

    static Lanes<N> parts_of(const WaterSweep& sweep, Lanes<N> fastest) {
        return each_lane(fastest, [&](double speed) {
            const double parts = speed * sweep.courant / kPartRun;
            int m = 1;
            while (m < parts && m < kMostParts) m *= 2;
            return double(m);
        });
    }

    // of a part; goes_on: > 0 in lines that make it
    StepKind(const WaterSweep& sweep, Lanes<N> parts, Lanes<N> goes_on, Lanes<N> deepest) {
        using L = Lanes<N>;
        share = select(goes_on, L::splat(1) / parts, L{});
        courant = sweep.courant * share;
        const L square = (sweep.gravity * deepest) * (courant * courant);
        resolves = within((1 / (1 - kResolved)) * (L::splat(1) - square), 0, 1);
        is_long = sweep.implicit ? square - L::splat(1) : L{};
        any_long = any_positive(is_long);
    }
    // Lines in which squeezed > 0 are bound in their energy as in a long step.
    void bind(Lanes<N> squeezed) {
        is_long = larger(is_long, squeezed);
        any_long = any_positive(is_long);
    }
};

// The equation of a flux q: q = flux + left x_l - right x_r, x the changes of the cells beside it. And what becomes of
// the face's velocity: base - push (rise after).
template <int N> struct FaceLanes { Lanes<N> flux, left, right, base, push; };

// The passes along a line work on copies of it: of those the compiler knows that no panel lies over them, and their
// members stay in registers.
template <int N> struct WaterLine {
    using L = Lanes<N>;
    using Cell = CellLanes<N>;

    WaterSweep sweep;
    size_t n;
    bool ring;

    Panel<N> bed{}, depth{}, velocity{};
    Panel<N> acceleration{}, opening{}; // of faces, opening 1 or 0; null: nothing pushes, all are open
    Panel<N> load{}, stiff{};           // of cells: hulls press with a head of load + stiff depth; null: there are none
    Panel<N> flux{}, after{}, speed{};  // results: of cells `after`, of faces flux and velocity
    Panel<N> pull{}, push{}, spare[2] = {};

    FaceLanes<N> side[2] = {}; // the faces at the ends
    L side_depth[2] = {};      // of what crosses them
    L held_back{}, limited{};  // see WaterTally
    // Of the energy bound (velocity.hh): > 0 in lines it counts for; the share of what faces gain that others take;
    // the share of the square of velocities that is kept.
    L rough{}, bounds{}, taken{}, keeps{};
    L limits{}; // > 0 in lines that the limiter counts for, of whose fluxes `pull` holds the parts that it has left

    size_t first_face() const { return ring ? 0 : 1; }
    size_t left(size_t face) const { return face > 0 ? face - 1 : n - 1; }
    Cell cell(size_t i) const { return {bed[i], depth[i]}; }
    Cell cell_after(size_t i) const { return {bed[i], after[i]}; }
    bool pressed() const { return CD_WITH_HULL && load; }
    // How far the surface rises across face i, and the head that hulls press with (model.md, 52).
    L full_rise_at(size_t i, Cell l, Cell r) const {
        const L rise = full_rise(l, r);
        if (!pressed()) return rise;
        return rise + ((load[i] - load[left(i)]) + (stiff[i] * r.depth - stiff[left(i)] * l.depth));
    }
    // As far as it pushes water.
    L rise_at(size_t i, Cell l, Cell r) const { return rise_between(l, r, full_rise_at(i, l, r)); }
    // > 0 where a hull presses so hard that it may press the cell dry.
    L squeezed_in(size_t i) const { return load[i] + (stiff[i] - L::splat(2)) * depth[i]; }
    // The depth in which waves run as fast as in a cell.
    L waves_in(size_t i) const { return pressed() ? depth[i] + stiff[i] * depth[i] : depth[i]; }
    L open(size_t face) const { return opening ? opening[face] : L::splat(1); }
    L gravity_run(const StepKind<N>& kind) const { return sweep.gravity * kind.courant; } // g c
    // Of inner faces. Where nothing acts on it, it is the same for all.
    bool keeps_push() const { return sweep.rubs() || opening; }
    L push_of(size_t i, const StepKind<N>& kind) const {
        return keeps_push() ? push[i] : sweep.theta * gravity_run(kind);
    }

    // surface.hh
    FaceLanes<N> inner_face(size_t i, const StepKind<N>& kind, L stream);
    FaceLanes<N> end_face(size_t i, const StepKind<N>& kind);
    void solve_surface(StepKind<N> kind);
    void close_ring(const FaceLanes<N>& first);
    L fill();

    // limiter.hh
    void limit(L need); // lines in which need > 0

    // velocity.hh
    void follow_water(L moves); // lines in which moves > 0
    L lift(size_t i) const;
    L more_lift(size_t i) const;
    L fall(size_t i) const;
    L moving_depth(size_t i) const;
    L bounded(size_t i, L w) const;
    void balance(const StepKind<N>& kind);
    void set_velocities(StepKind<N> kind);
    void end_velocities(const StepKind<N>& kind);

    // carry.hh
    void carry(const StepKind<N>& kind);

    void step(const StepKind<N>& kind) {
        rough = bounds = limits = L{};
        solve_surface(kind);
        const L least = fill();
        if (any_positive(-least)) limit(-least);
        if (kind.any_long) balance(kind);
        end_velocities(kind);
        if (sweep.advected()) carry(kind);
        else set_velocities(kind);
    }
};

} // namespace CD_ISA
} // namespace cd
