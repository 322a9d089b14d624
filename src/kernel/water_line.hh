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
    double *face = nullptr, *start_face = nullptr, *guess = nullptr, *gain = nullptr, *spring = nullptr;
    double *transfer = nullptr, *after = nullptr, *ground = nullptr, *x = nullptr, *pull = nullptr, *rest = nullptr;
    L strained = L::splat(1); // > 0: water was held back in the line or may have been, or its step is very long
    L tally[kTallies] = {};

    static L at(const double* panel, size_t i) { return L::load(panel + i * N); }
    static void put(double* panel, size_t i, L value) { value.store(panel + i * N); }

    size_t left_of(size_t i) const { return i > 0 ? i - 1 : n - 1; }
    size_t right_of(size_t i) const { return i < n ? i : 0; }
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

    // ---- 1. how deep faces are ----

    // The mean of two wet cells, else the gate; of a film no more than lets it run dry in the step.
    void measure_faces(const double* depths, double* out) const {
        const double share = axis.gravity * axis.courant * axis.courant * axis.lambda;
        L films{};
        const auto faces = [&](size_t i) {
            const size_t l = left_of(i);
            return between_cells<N>(at(bed, l), at(bed, i), at(depths, l), at(depths, i));
        };
        for (size_t i = first_inside(); i < n; ++i) {
            const FaceLanes<N> f = faces(i);
            put(out, i, opening(i) * f.mean);
            films = larger(films, select(f.film, share * f.drop * f.mean - f.gate, L{}));
        }
        const bool has_films = any_positive(films);
        for (size_t i = first_inside(); i < n && has_films; ++i) {
            const FaceLanes<N> f = faces(i);
            const L most = f.gate * larger(L::splat(1), L::splat(1) / (share * f.drop));
            put(out, i, opening(i) * select(f.film, smaller(f.mean, most), f.mean));
        }
        for (size_t i : {size_t(0), n})
            if (!ring) put(out, i, end_depth(i, depths));
        close(out);
    }

    // Of a face on a side: the mean of the cell and of a column outside that stands on the cell's bed.
    L end_depth(size_t i, const double* depths) const {
        const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
        if (end.kind != End::kOpen) return L{};
        const size_t cell = i == 0 ? 0 : n - 1;
        return opening(i) * (0.5 * (at(depths, cell) + outside(end, cell)));
    }
    L outside(const WaterEnd& end, size_t cell) const { return positive(L::splat(end.level) - at(bed, cell)); }

    // ---- 2. and 3. faces in the middle of the step; velocities where it is dry ----

    // Between wet cells, a face is as deep in the middle of the step as the water that comes to it by then (Lax and
    // Wendroff 1960), no more than a cell's way; and where momentum is advected, as what spreads or closes up makes it.
    void look_ahead() const {
        for (size_t i = first_inside(); i < n; ++i) {
            const size_t l = left_of(i), far_l = ring ? l : i - 1;
            const L d_l = at(depth, l), d_r = at(depth, i), h = at(face, i), mean = 0.5 * (d_l + d_r);
            L ahead = h - 0.5 * (within(axis.courant * at(velocity, i), -1, 1) * (d_r - d_l));
            if (axis.advected) {
                const L spread = (0.25 * axis.courant) * (at(velocity, i + 1) - at(velocity, far_l));
                ahead = ahead * within(L::splat(1) - spread, 0.5, 2);
            }
            const L is_mean = select(size_of(h - mean), L{}, smaller(d_l, d_r));
            put(face, i, select(is_mean, ahead, h));
        }
        close(face);
    }

    void rest_dry_faces() const {
        for (size_t i = 0; i <= n; ++i) put(velocity, i, select(at(face, i), at(velocity, i), L{}));
    }

    // A dry face takes the velocity of the nearest wet one that may come as far in the step, at least of a neighbour;
    // of two as near, the mean. Uses x and pull for what comes from the left, its distance at first.
    void carry_to_dry_faces() const {
        const L far = L::splat(kFar);
        const double courant = axis.corrections > 0 ? axis.courant : 0; // else a neighbour only
        const size_t begin = first_inside(), turns = ring ? 2 : 1;
        NearestLanes<N> left{L{}, far}, right{L{}, far};
        for (size_t turn = 0; turn < turns; ++turn)
            for (size_t i = begin; i < n; ++i) {
                left.pass(at(face, i), at(velocity, i), opening(i));
                put(x, i, left.value);
                put(pull, i, left.reach(courant));
            }
        for (size_t turn = 0; turn < turns; ++turn)
            for (size_t i = n; i-- > begin;) {
                const L wet = at(face, i), here = at(velocity, i);
                right.pass(wet, here, opening(i));
                if (turn + 1 < turns) continue;
                const L from_left = at(pull, i), from_right = right.reach(courant), v = at(x, i);
                L dry = select(from_right - from_left, v,
                               select(from_left - from_right, right.value, 0.5 * (v + right.value)));
                dry = select(far - smaller(from_left, from_right), dry, L{});
                put(velocity, i, opening(i) * select(wet, here, dry));
            }
        if (!ring)
            for (size_t i : {size_t(0), n}) put(velocity, i, select(at(face, i), at(velocity, i), L{}));
        close(velocity);
    }

    // ---- 5. the new surface ----

    // What the slope of the present surface, forces and friction make of a face's velocity, what a unit of slope of the
    // change will add, and what follows for the system. slope: of the surface, times g dt / distance.
    void guess_face(size_t i, L slope, double wave_gain, L drag) const {
        const L u = at(velocity, i), h = at(face, i), pushed = push ? at(push, i) - slope : -slope;
        L gain = L::splat(wave_gain * axis.lambda);
        L w = u + pushed;
        if (axis.manning > 0) drag = drag + manning_drag(h, size_of(w), axis.manning);
        if (axis.rubs() || i == 0 || i == n) {
            const FrictionLanes<N> friction(drag);
            w = friction.keep * u + friction.push * pushed;
            gain = friction.push * gain;
        }
        put(guess, i, w);
        put(this->gain, i, gain);
        put(spring, i, (axis.courant * axis.lambda) * (gain * h));
        put(transfer, i, axis.courant * (h * (axis.lambda * w + (1 - axis.lambda) * u)));
    }

    void guess_faces() const {
        const double wave_gain = axis.gravity * axis.courant;
        const L drag = L::splat(axis.drag);
        for (size_t i = first_inside(); i < n; ++i) {
            const size_t l = left_of(i);
            const L slope = wave_gain * ((at(bed, i) - at(bed, l)) + (at(depth, i) - at(depth, l)));
            guess_face(i, slope, wave_gain, drag);
            if (axis.corrections > 0) continue; // a cell may get what it gives within the step
            const L giver = select(at(guess, i), at(depth, l), at(depth, i));
            for (double* panel : {gain, spring, transfer}) put(panel, i, select(giver, at(panel, i), L{}));
        }
        for (double* panel : {guess, gain, spring}) close(panel);
        close_transfers();
        for (size_t i : {size_t(0), n})
            if (!ring) guess_end(i, wave_gain, drag);
    }

    // On an open side the surface half a cell further stands at the level outside plus what a wave that leaves with the
    // face's velocity u carries, u sqrt(depth / g): a drag on it, and a spring to the outside.
    void guess_end(size_t i, double wave_gain, L drag) const {
        const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
        const size_t cell = i == 0 ? 0 : n - 1;
        for (double* panel : {guess, gain, spring, transfer}) put(panel, i, L{});
        if (end.kind == End::kOpen) {
            const L rise = at(depth, cell) - outside(end, cell), h = at(face, i);
            const L slope = (2 * wave_gain) * (i == 0 ? rise : -rise);
            guess_face(i, slope, 2 * wave_gain, drag + (2 * axis.courant) * root(axis.gravity * h));
        } else if (end.kind == End::kInflow) {
            const L in = end.discharge * opening(i);
            put(transfer, i, i == 0 ? in : -in);
        }
    }

    // x = the change of the surface, from the guesses. In large steps only cells that stay wet store water.
    void solve_surface() {
        const auto row_with = [&](size_t i, L ground) {
            RowLanes<N> r{ground, at(spring, i), at(spring, i + 1), at(transfer, i) - at(transfer, i + 1)};
            if (!ring && i == 0) r.ground = r.ground + r.left, r.left = L{};
            if (!ring && i + 1 == n) r.ground = r.ground + r.right, r.right = L{};
            return r;
        };
        const auto row = [&](size_t i) { return row_with(i, L::splat(1)); };
        const auto storing_row = [&](size_t i) {
            const L stores = at(ground, i);
            RowLanes<N> r = row_with(i, stores);
            r.load = r.load + (L::splat(1) - stores) * at(depth, i);
            return r;
        };
        const auto solve = [&](const auto& rows) {
            tally[kSolves] = tally[kSolves] + L::splat(1);
            if (ring) solve_round<N>(n, rows, x, rest, pull);
            else solve_rows<N>(0, n, rows, L{}, L{}, x, pull);
        };
        if (axis.corrections == 0) return solve(row);
        // Newton's method on a convex, piecewise linear system: from "all store" on, cells only ever drop out, but for
        // what rounding took out by mistake. It ends after 2 passes mostly, and n + 1 at the most.
        for (size_t i = 0; i < n; ++i) put(ground, i, L::splat(1));
        bool changed = true;
        for (size_t pass = 0; changed; ++pass) {
            solve(storing_row);
            L changes{};
            for (size_t i = 0; i < n; ++i) {
                const L stores = at(ground, i), stored = at(depth, i) + at(x, i);
                const L all = at(depth, i) + (at(face, i) + at(face, i + 1));
                const L least = select(stores, L{}, pass < 8 ? 0x1p-20 * all : L::splat(1e300));
                const L now = select(stored - least, L::splat(1), L{});
                changes = changes + size_of(stores - now);
                put(ground, i, now);
            }
            changed = any_positive(changes);
        }
    }

    // ---- 6. new velocities, and what they move ----

    void move_faces() const {
        const double lambda = axis.lambda, courant = axis.courant;
        const auto finish = [&](size_t i, L rise) {
            const L w = at(guess, i) - at(gain, i) * rise;
            put(guess, i, w);
            put(transfer, i, courant * (at(face, i) * (lambda * w + (1 - lambda) * at(velocity, i))));
        };
        for (size_t i = first_inside(); i < n; ++i) finish(i, at(x, i) - at(x, left_of(i)));
        if (!ring && axis.end[0].kind == End::kOpen) finish(0, at(x, 0));
        if (!ring && axis.end[1].kind == End::kOpen) finish(n, -at(x, n - 1));
        close(guess);
        close_transfers();
        hold_inflow();
    }

    // The water outside an open side comes in no faster than its waves run, though a surface that has been solved for
    // may have sunk below the bed and call for more.
    void hold_inflow() const {
        for (size_t i : {size_t(0), n}) {
            const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
            if (end.kind != End::kOpen) continue;
            const L depth_outside = outside(end, i == 0 ? 0 : n - 1), t = at(transfer, i), in = i == 0 ? t : -t;
            const L most = axis.courant * (depth_outside * root(axis.gravity * depth_outside)), over = in - most;
            put(transfer, i, select(over, i == 0 ? most : -most, t));
            put(guess, i, select(over, at(guess, i) * (most / in), at(guess, i)));
        }
    }

    // ---- 7. no cell gives more than it has and gets ----

    // What is left in a cell; exact where a transfer is all that is there.
    static L left_in(L d, L in, L out) {
        return ((d + (positive(in) + positive(-out))) - positive(out)) - positive(-in);
    }
    L left_in(size_t i) const { return left_in(at(depth, i), at(transfer, i), at(transfer, i + 1)); }

    // A cell with two outflows shares out what it has; then along each direction, downstream, a cell passes on at most
    // what it has and gets. Downstream cells see what upstream ones could really give, so one pass each way is enough.
    void limit() {
        L least, deepest;
        fill_cells(least, deepest);
        const double wave = axis.gravity * axis.courant * axis.courant;
        strained = axis.corrections > 0 ? L::splat(1) : larger(-least, wave * deepest - L::splat(1e4));
        if (axis.corrections == 0 && !any_positive(-least)) return;
        for (size_t i = 0; i <= n; ++i) put(rest, i, at(transfer, i));
        if (ring) settle_seam();
        const auto shares = [&](size_t i) { return !ring || (i > 0 && i + 1 < n); };
        for (size_t i = 0; i < n; ++i) {
            const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
            const L all = d + positive(in), on = select(runs_dry(i), select(out, all, out), smaller(out, all));
            if (shares(i)) share_out(i);
            if (!ring || i + 1 < n) put(transfer, i + 1, select(-in, at(transfer, i + 1), on));
        }
        for (size_t i = n; i-- > 0;) {
            const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
            const L all = out - d, on = select(runs_dry(i), select(-in, all, in), larger(in, all));
            if (!ring || i > 0) put(transfer, i, select(out, in, on));
        }
        count_held_back();
        fill_cells(least, deepest);
    }
    // after = what is left in the cells; and the least and the most of it.
    void fill_cells(L& least, L& deepest) const {
        least = L::splat(1), deepest = L{};
        for (size_t i = 0; i < n; ++i) {
            const L left = left_in(i);
            put(after, i, left);
            least = smaller(left, least), deepest = larger(left, deepest);
        }
    }

    // Where a ring closes, the cell that gives counts on what it has alone.
    void settle_seam() const {
        share_out(0);
        share_out(n - 1);
        const L back = larger(at(transfer, 0), -at(depth, 0)), on = smaller(at(transfer, n), at(depth, n - 1));
        const L seam = select(on, on, smaller(back, L{}));
        for (size_t i : {size_t(0), n}) put(transfer, i, seam);
    }

    // > 0: large steps have found that nothing stays in the cell, so that rounding shall leave nothing there either.
    L runs_dry(size_t i) const { return axis.corrections > 0 ? L::splat(1) - at(ground, i) : L{}; }

    // Of a cell with two outflows that are more than it has.
    void share_out(size_t i) const {
        const L in = at(transfer, i), out = at(transfer, i + 1), d = at(depth, i);
        const L both = smaller(-in, out), over = select(both, larger(-((d - out) + in), runs_dry(i)), L{});
        const L right = smaller(d * (out / (out - in)), d);
        put(transfer, i, select(over, -(d - right), in));
        put(transfer, i + 1, select(over, right, out));
    }

    // Rounding is not worth a mention.
    void count_held_back() {
        for (size_t i = 0; i < n; ++i) {
            const L wanted = left_in(at(depth, i), at(rest, i), at(rest, i + 1));
            const L lacking = -wanted, noise = 0x1p-40 * (at(face, i) + (at(face, i + 1) + at(depth, i)));
            tally[kLimited] = tally[kLimited] + select(lacking - noise, L::splat(1), L{});
        }
        for (size_t i = ring ? 1 : 0; i <= n; ++i) {
            const L held = size_of(at(rest, i) - at(transfer, i)), noise = 0x1p-40 * at(face, i);
            tally[kHeldBack] = tally[kHeldBack] + select(held - noise, held, L{});
        }
    }

    // ---- 4. momentum goes with the water ----

    // Velocities are carried upwind with the transfers of the step: exactly as much momentum comes in at a face as goes
    // out at the one before. Where the step shows a wave's course, what the surface at its end pushes acts after that,
    // the rest before: so the push of the surface is in balance with what is carried, and shocks run at their right
    // speed. Elsewhere, on thin and rushing water, it all acts before, which is the more stable. A dry face is not
    // pushed: the slope of dry land is no slope of water, and none of it may be carried to where there is some.
    void carry() const {
        const double wave = axis.gravity * axis.courant * axis.courant;
        const size_t begin = first_inside();
        const auto through = [&](size_t cell) { return 0.5 * (at(transfer, cell) + at(transfer, cell + 1)); };
        for (size_t i = begin; i < n; ++i) {
            const size_t l = left_of(i);
            const L u = at(velocity, i), w = at(guess, i), d_l = at(depth, l), d_r = at(depth, i);
            const L calm = axis.gravity * smaller(d_l, d_r) - w * w;
            const size_t far_l = ring ? left_of(i) : i - 1, far_r = i + 1;
            const L closing = axis.courant * (at(velocity, far_l) - at(velocity, far_r)) - L::splat(0.02);
            const L passing = positive(through(l)) + positive(-through(i)), volume = 0.5 * (d_l + d_r);
            const L short_step = smaller(L::splat(1) - wave * larger(d_l, d_r), volume - passing);
            const L resolved = select(short_step, larger(calm, closing), L{});
            const L wet = at(face, i), later = select(smaller(wet, resolved), axis.push_after * (w - u), L{});
            put(gain, i, later);
            put(guess, i, select(wet, w - later, u));
        }
        const auto row = [&](size_t i) {
            const size_t l = left_of(i);
            const L volume = 0.5 * (at(depth, l) + at(depth, i)), is_open = opening(i);
            return RowLanes<N>{select(is_open, volume, L::splat(1)), is_open * positive(through(l)),
                               is_open * positive(-through(i)), is_open * (volume * at(guess, i))};
        };
        if (ring) solve_round<N>(n, row, x, rest, pull);
        else solve_rows<N>(1, n, row, at(guess, 0), at(guess, n), x, pull);
        for (size_t i = begin; i < n; ++i) put(guess, i, opening(i) * (at(x, i) + at(gain, i)));
        close(guess);
    }

    // ---- all of it ----

    // The velocity with which an inflow comes in, for what carries it on: as if the side were as deep as the cell, or
    // as deep as water at the speed of its own waves.
    void set_inflow_velocity(size_t i) const {
        const WaterEnd& end = axis.end[i == 0 ? 0 : 1];
        if (ring || end.kind != End::kInflow) return;
        const L q = (1 / axis.courant) * at(transfer, i);
        const L critical = critical_depth(q, axis.gravity);
        const L h = larger(at(depth, i == 0 ? 0 : n - 1), critical);
        put(guess, i, select(h, q / h, L{}));
    }

    void look() {
        measure_faces(depth, face);
        if (axis.advected) carry_to_dry_faces();
        else rest_dry_faces();
        if (axis.corrections == 0) look_ahead();
    }
    void guess_all() {
        look();
        guess_faces();
        hold_inflow();
    }
    void keep_all() {
        for (size_t i : {size_t(0), n}) set_inflow_velocity(i);
        if (!ring) count_ends();
        if (any_positive(strained)) {
            for (size_t i = first_inside(); i < n; ++i) slow_held_back(i);
            close(guess);
            bound_speeds();
        }
        if (axis.advected) carry();
        for (size_t i = 0; i <= n; ++i) settle_face(i);
    }

    // A face through which less went than its velocity would have moved is as slow as what went. Not so where momentum
    // is advected in short steps: there what waits at a shore goes on as fast.
    void slow_held_back(size_t i) const {
        const L w = at(guess, i), went = at(transfer, i);
        const L wanted = axis.courant * (at(face, i) * (axis.lambda * w + (1 - axis.lambda) * at(velocity, i)));
        const L held_back = (1 - 0x1p-40) * size_of(wanted) - size_of(went);
        const double wave = axis.gravity * axis.courant * axis.courant;
        L slows = L::splat(1);
        if (axis.advected && axis.corrections == 0) slows = wave * larger(at(depth, left_of(i)), at(depth, i)) - slows;
        put(guess, i, select(smaller(smaller(held_back, slows), strained), w * positive(went / wanted), w));
    }

    // Where a step is too long for waves or water to stay in a cell's reach, water gets no faster than by a fall from
    // the highest head of its line, surface and speed, beside what pushes it: what the surface solved for may call for
    // more has no water behind it.
    void bound_speeds() {
        if (!(axis.gravity > 0)) return;
        const double wave = axis.gravity * axis.courant * axis.courant, fall = 2 * axis.gravity;
        L head = L::splat(-1e300), over{};
        for (size_t i = 0; i < n; ++i) {
            const L before = at(velocity, i), behind = at(velocity, i + 1), d = at(depth, i);
            const L speed = (1 / fall) * larger(before * before, behind * behind);
            head = select(d, larger(head, (at(bed, i) + d) + speed), head);
        }
        for (const WaterEnd& end : axis.end)
            if (end.kind == End::kOpen) head = larger(head, L::splat(end.level));
        const auto excess = [&](size_t i) { // of the speed's square; none where the step is short
            const size_t l = left_of(i);
            const L fastest = fall * positive(head - smaller(at(bed, l), at(bed, i))), w = at(guess, i);
            const L deepest = larger(larger(at(depth, l), at(depth, i)), larger(at(after, l), at(after, i)));
            const L cells = larger(wave * deepest, axis.courant * size_of(w));
            return select(smaller(cells - L::splat(1), strained), w * w - fastest, L{});
        };
        for (size_t i = first_inside(); i < n; ++i) over = larger(over, excess(i));
        if (!any_positive(over)) return;
        for (size_t i = first_inside(); i < n; ++i) {
            const L w = at(guess, i), too_much = excess(i), most = root(positive(w * w - too_much));
            const L bound = smaller(size_of(w), most + (push ? size_of(at(push, i)) : L{}));
            const L slowed = select(too_much, select(w, bound, -bound), w);
            const L moved = size_of(at(transfer, i)) - 0x1p-20 * (at(depth, i) + at(depth, left_of(i)));
            const L counts = smaller(moved, size_of(w) - size_of(slowed));
            tally[kLimited] = tally[kLimited] + select(counts, L::splat(1), L{});
            put(guess, i, slowed);
        }
        close(guess);
    }

    void step() {
        look();
        for (size_t i = 0; i <= n && axis.corrections > 1; ++i) put(start_face, i, at(face, i));
        for (size_t k = 0; k == 0 || k < axis.corrections; ++k) {
            if (k > 0) {
                measure_faces(after, face);
                for (size_t i = 0; i <= n; ++i) put(face, i, 0.5 * (at(face, i) + at(start_face, i)));
            }
            guess_faces();
            solve_surface();
            move_faces();
            tally[kHeldBack] = tally[kLimited] = L{}; // only the last correction's limits count
            limit();
        }
        keep_all();
    }

    void count_ends() {
        const L first = at(transfer, 0), last = at(transfer, n);
        tally[kIn] = positive(first) + positive(-last);
        tally[kOut] = positive(-first) + positive(last);
    }

    // The velocity that a face keeps: none where the cells on both sides are dry, nor, of linear momentum, where the
    // face was.
    void settle_face(size_t i) const {
        const bool inside = ring || (i > 0 && i < n);
        L water{}, u = at(guess, i);
        if (i > 0 || ring) water = larger(water, at(after, left_of(i)));
        if (i < n || ring) water = larger(water, at(after, right_of(i)));
        if (!axis.advected) u = select(at(face, i) + size_of(at(transfer, i)), u, at(velocity, i));
        if (!axis.advected && inside) u = slowed_by_newcomers(i, u);
        put(velocity, i, select(water, u, L{}));
    }

    // Linear momentum lets water that comes to a face take on the velocity there, which makes energy out of nothing.
    // Waves do not show it; but where a step is too long for the waves and water rushes, at more than a third of what
    // waves carry, it would feed on itself. There newcomers are at rest.
    L slowed_by_newcomers(size_t i, L u) const {
        const size_t l = left_of(i), r = right_of(i);
        const L was = at(depth, l) + at(depth, r), is = at(after, l) + at(after, r);
        const L waves = axis.gravity * larger(at(after, l), at(after, r));
        const L too_long = (axis.courant * axis.courant) * waves - L::splat(1), rushes = u * u - (1.0 / 3) * waves;
        return select(smaller(smaller(too_long, rushes), is - was), u * (was / is), u);
    }
};

} // namespace CD_ISA
} // namespace cd
