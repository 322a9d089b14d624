// One step of water along N lines that are worked on side by side: model.md, section 5, steps 1 to 7, on panels: number
// i of lane k lies at i * N + k.
//
// Faces are numbered 0 to n, cells 0 to n - 1; face i lies between the cells i - 1 and i. `transfer` is what goes
// through a face in the step, as the depth [m] that it adds to the cell behind it and takes from the one before.
#pragma once

#include <initializer_list>

#include "kernel/water.hh"
#include "kernel/water_rows.hh"

namespace cd {
namespace CD_ISA {

template <int N> struct WaterLine {
    using L = Lanes<N>;

    const WaterAxis& axis;
    size_t n; // cells
    bool ring;

    // state; open and push are null where all is open and nothing pushes
    double *bed = nullptr, *depth = nullptr, *velocity = nullptr, *open = nullptr, *push = nullptr;
    // results and scratch
    double *face = nullptr, *share = nullptr, *stream = nullptr, *start_face = nullptr, *guess = nullptr,
           *gain = nullptr, *spring = nullptr;
    double *transfer = nullptr, *after = nullptr, *ground = nullptr, *x = nullptr, *pull = nullptr, *rest = nullptr;
    bool alone = false;       // whether the line's surface is solved for by itself
    bool streams = false;     // whether water runs further than a cell on any line, see look_ahead
    L long_step{};            // 1: waves cross so many cells in the step that depths change much meanwhile, else 0
    L even{};                 // > 0: depths in the line differ little
    L ahead{};                // > 0: faces look ahead
    L thins{};                // 1: the surface is solved for with cells running dry, else 0
    L ebbs{};                 // > 0: faces that run dry carry what the water beside them does, see follow_water
    L strained = L::splat(1); // > 0: water was held back in the line or may have been, or its step is very long
    L tally[kTallies] = {};

    static L at(const double* panel, size_t i) { return L::load(panel + i * N); }
    static void put(double* panel, size_t i, L value) { value.store(panel + i * N); }

    // Times a depth: the square of the number of cells that waves cross in the step there.
    double wave() const { return axis.gravity * axis.courant * axis.courant; }

    size_t left_of(size_t i) const { return i > 0 ? i - 1 : n - 1; }
    size_t right_of(size_t i) const { return i < n ? i : 0; }
    // > 0: depths beside a face differ by half at most.
    static L akin(L d_l, L d_r) { return 1.5 * smaller(d_l, d_r) - larger(d_l, d_r); }
    // Faces with a cell on both sides: a ring's first one is its last.
    size_t first_inside() const { return ring ? 0 : 1; }
    L opening(size_t i) const { return open ? at(open, i) : L::splat(1); }
    // What has been put at face 0 of a ring is at face n too.
    void close(double* panel) const {
        if (ring) put(panel, n, at(panel, 0));
    }
    // Nothing is moved round a ring of one cell: it would come in as it goes out, and only leave its rounding there.
    void close_transfers() const {
        if (ring && n == 1) put(transfer, 0, L{});
        close(transfer);
    }

    // ---- 1. to 3. how deep faces are; velocities where it is dry (water_faces.hh) ----

    struct FaceRange {
        L least, most;
    };
    // How deep the water outside an open side stands over the bed of the cell there.
    L outside(const WaterEnd& end, size_t cell) const { return positive(L::splat(end.level) - at(bed, cell)); }
    FaceRange measure_faces(const double* depths, double* out) const;
    void size_up(FaceRange depths);
    L end_depth(size_t i, const double* depths) const;
    L rushes_out(size_t i) const;
    L inside_end(size_t i) const { return at(velocity, i == 0 ? 1 : n - 1); }
    void look_ahead(const double* speeds);
    void rest_if_dry(size_t i) const;
    void carry_to_dry_faces(const double* depths, const double* cells, double* velocities) const;

    // ---- 5. and 6. the new surface, new velocities, and what they move (water_surface.hh) ----

    void guess_face(size_t i, L slope, double wave_gain, L drag) const;
    void guess_faces() const;
    void guess_end(size_t i, double wave_gain, L drag) const;
    // Of the step, before its surface is known.
    L mean_speed(size_t i) const { return axis.lambda * at(guess, i) + (1 - axis.lambda) * at(velocity, i); }
    // > 0: what a face gives has water, but where a cell may get what it gives within the step.
    L gives(size_t i) const { return larger(thins, select(at(guess, i), at(depth, left_of(i)), at(depth, i))); }
    void look_late();
    void solve_surface();
    // What a stream carries of the change of the cell that gives, or, where its share is below 0, of the mean of both.
    L streamed(size_t i) const {
        if (!streams) return L{};
        const L k = at(stream, i);
        const L x_l = at(x, i > 0 || ring ? left_of(i) : i), x_r = at(x, i < n ? i : i - 1);
        return k * select(-at(share, i), 0.5 * (x_l + x_r), select(k, x_l, x_r));
    }
    void move_faces() const;
    void hold_inflow() const;

    // ---- 7. no cell gives more than it has and gets (water_limit.hh) ----

    // What is left in a cell; exact where a transfer is all that is there.
    static L left_in(L d, L in, L out) {
        return ((d + (positive(in) + positive(-out))) - positive(out)) - positive(-in);
    }
    L left_in(size_t i) const { return left_in(at(depth, i), at(transfer, i), at(transfer, i + 1)); }
    // > 0: the solve has found that nothing stays in the cell, so that rounding shall leave nothing there either.
    L runs_dry(size_t i) const { return select(thins, L::splat(1) - at(ground, i), L{}); }
    void limit();
    L circulation() const;
    void add_to_transfers(L more) const;
    void limit_transfers();
    void fill_cells(L& least, L& deepest) const;
    void share_out(size_t i) const;
    void count_held_back();

    // ---- 4. momentum goes with the water; what velocity a face keeps (water_momentum.hh) ----

    void follow_water() const;
    void carry() const;
    void set_inflow_velocity(size_t i) const;
    void slow_held_back(size_t i) const;
    L no_faster_than_a_fall(size_t i, L w) const;
    void bound_speeds();
    void settle_face(size_t i) const;
    L slowed_by_newcomers(size_t i, L u) const;

    // ---- all of it ----

    // What came in and went out at the ends.
    void count_ends() {
        const L first = at(transfer, 0), last = at(transfer, n);
        tally[kIn] = positive(first) + positive(-last);
        tally[kOut] = positive(-first) + positive(last);
    }

    // Faces before anything moves.
    void look() {
        const FaceRange depths = measure_faces(depth, face);
        size_up(depths);
        const bool wet = !open && !any_positive(select(depths.least, L{}, L::splat(1)));
        if (axis.advected && !wet) carry_to_dry_faces(face, depth, velocity);
        for (size_t i = 0; i <= n; ++i)
            if (!axis.advected || (!ring && (i == 0 || i == n))) rest_if_dry(i);
        if (!axis.looks_late()) look_ahead(velocity);
    }

    // Of steps that work on both axes at once: what a line does before its surface is known, and what it does at last.
    void guess_all() {
        thins = L::splat(axis.thins ? 1 : 0);
        look();
        streams = false; // what they need is not symmetric
        guess_faces();
        if (axis.looks_late()) look_late();
        hold_inflow();
    }

    // What limits leave of velocities.
    void hold_back() {
        for (size_t i : {size_t(0), n}) set_inflow_velocity(i);
        if (!ring) count_ends();
        if (any_positive(strained)) {
            for (size_t i = first_inside(); i < n; ++i) slow_held_back(i);
            close(guess);
            bound_speeds();
        }
    }
    void settle_faces() const {
        for (size_t i = 0; i <= n; ++i) settle_face(i);
    }
    void keep_all() {
        hold_back();
        if (axis.advected) {
            follow_water();
            carry();
        }
        settle_faces();
    }

    // A sweep's whole step.
    void step() {
        alone = true;
        look();
        for (size_t i = 0; i <= n && axis.corrections > 1; ++i) put(start_face, i, at(face, i));
        for (size_t k = 0; k == 0 || k < axis.corrections; ++k) {
            if (k > 0) {
                measure_faces(after, face);
                for (size_t i = 0; i <= n; ++i) {
                    const L start = at(start_face, i);
                    put(face, i, select(ahead, start, 0.5 * (at(face, i) + start)));
                }
            }
            guess_faces();
            solve_surface();
            move_faces();
            tally[kHeldBack] = tally[kLimited] = L{}; // only the last correction's limits count
            limit();
        }
        keep_all();
    }
};

} // namespace CD_ISA
} // namespace cd

#include "kernel/water_faces.hh"
#include "kernel/water_limit.hh"
#include "kernel/water_momentum.hh"
#include "kernel/water_surface.hh"
