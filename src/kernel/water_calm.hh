// A bundle of calm lines of water: the step of WaterLine (water_line.hh), with the same bits, in two passes.
//
// Most water of most scenes is calm: wet from wall to wall, linear, with nothing that pushes or closes faces, no
// film above its neighbour, no stream of more than a cell; and in long steps no cell comes near to running dry. Then
// every part of the step asks for neighbours only: faces, guesses and the elimination go right in one loop; the
// surface, what it moves, what cells hold and what faces keep go left in another, and leave rounded. What would make a
// line other than calm is only kept as the extremes of the loops, and looked at between them. Results lie beside the
// state until then: a bundle that turns out not to be calm has lost nothing but time. What is asked for may be more
// than is needed, but nothing that another way would do differently goes unseen.
//
// What is left, with AVX-512 on a Zen 5, 256 squared in float32: about 10 cycles a cell and step at 3.1 instructions a
// cycle; two fifths of them on the way left, three tenths on the way right, a fifth to turn rows and put results back.
//
// Tried, and it did not pay: rounding in two chains, or one factor less that waits for the division (no time: it is
// operations that bind); panels of their own for what the way right finds out (8% slower than one record a place).
#pragma once

#include <type_traits>

#include "kernel/water_panels.hh"

namespace cd {
namespace CD_ISA {

// Lines side by side: two registers, since the loops wait for their own recurrences.
constexpr int kCalmLanes = kNative < 8 ? 8 : 16;

// Up to N lines, and more than half as many. Where they are fewer than N, the lanes are the first N/2 of them and the
// last N/2: some are worked on twice.
template <int N, class T> class CalmLines {
    using L = Lanes<N>;
    using Extreme = decltype(least_of(L{})); // of lines that lie in different registers, too

    // What the way right finds out for the way left: of a cell, and of the face before it.
    struct Found {
        double change[N], pull[N], face[N], guess[N];
    };
    static constexpr bool kHalves = lane_kind(N) == LaneKind::kPair; // else there are N lines

    // Numbers of the lanes, those of place i together at i * step, the second half of them `half` numbers on.
    struct Rows {
        const T* first;
        size_t step, half;

        L operator[](size_t i) const {
            const T* const here = first + i * step;
            if constexpr (kHalves) return {Lanes<N / 2>::load(here), Lanes<N / 2>::load(here + half)};
            else return L::load(here);
        }
    };

    const WaterAxis& axis;
    const WaterLines<T>& lines;
    Place place;
    size_t n;
    size_t second; // the line from which the second half is
    bool upright;  // neighbours across the lines lie side by side in memory
    double* free;  // to work with
    Found* const found = panel<Found>(1);
    T *const after = panel<T>(N), *const keeps = panel<T>(N); // depths and velocities at last

    template <class S> S* panel(size_t per_place) {
        S* const first = reinterpret_cast<S*>(free);
        free += ((n + 2) * per_place * sizeof(S) + sizeof(double) - 1) / sizeof(double);
        return first;
    }
    // f(lane, line, lanes) for those whose lines lie one after the other.
    template <class F> void each_run(const F& f) const {
        if (!kHalves || second == N / 2) return f(size_t(0), size_t(0), std::integral_constant<size_t, N>());
        constexpr std::integral_constant<size_t, (N + 1) / 2> half;
        f(size_t(0), size_t(0), half), f(half(), second, half);
    }
    // `count` numbers along each line.
    Rows rows(const T* from, size_t count) {
        from += place.at(0, 0);
        if (upright) return {from, place.along, second};
        T* const turned = panel<T>(N);
        each_run([&](size_t lane, size_t line, auto lanes) {
            turn(lanes, count, from + line * place.across, place.across, turned + lane, N);
        });
        return {turned, N, N / 2};
    }
    void put_back(const T* from, size_t count, T* to) const {
        to += place.at(0, 0);
        each_run([&](size_t lane, size_t line, auto lanes) {
            if (!upright) return turn(count, lanes, from + lane, N, to + line * place.across, place.across);
            for (size_t i = 0; i < count; ++i)
                memcpy(to + i * place.along + line, from + i * N + lane, lanes * sizeof(T));
        });
    }

    double wave() const { return axis.gravity * axis.courant * axis.courant; }

    const Rows bed = rows(lines.bed, n), depth = rows(lines.depth, n), velocity = rows(lines.velocity, n + 1);

    // Whether the step is long for all lines alike, and what part of a change of depth faces then count: half where
    // depths in the line differ little (see WaterLine::look_ahead). Where the first cells are shallow it is not asked
    // for: lines that get deep are not calm then.
    bool is_long(L& part) const {
        const L one = L::splat(1), first = depth[0];
        if (!any_positive(wave() * first - L::splat(kLongStep / 2))) return false;
        L least = L::splat(1e300), most{}, d = first;
        for (size_t i = 1; i < n; ++i) {
            const L d_r = depth[i], mean = 0.5 * (d + d_r);
            least = smaller(mean, least), most = larger(mean, most);
            d = d_r;
        }
        part = select(even_depths(least, most), L::splat(0.5), L{});
        return !any_positive(select(wave() * most - L::splat(kLongStep), L{}, one));
    }

    // Faces as they will be if the surface stays as it is, and the elimination (see solve_rows). shallowest: the least
    // depth of a cell, in long steps as its surface and its bed tell it. False: not calm.
    template <bool kLong> bool go_right(L part, Extreme& shallowest) const {
        const Rows bed = this->bed, depth = this->depth, velocity = this->velocity; // which nothing that is written is
        Found* const found = this->found;
        const size_t last = n - 1;
        const double courant = axis.courant, lambda = axis.lambda, wave_gain = axis.gravity * courant;
        const FrictionLanes<N> friction(L::splat(axis.drag));
        const L one = L::splat(1), gain = friction.push * L::splat(wave_gain * lambda);
        L b = bed[0], d = depth[0], l{}, to_l{}, from_l{}, y{}, own = one, inverse = one;
        L u_l{}, u = velocity[1];
        const auto stands = [](L b, L d) { return kLong ? (b + d) - b : d; };
        Extreme clearance = least_of(one), deepest{}, fastest{};
        shallowest = least_of(stands(b, d));
        // The face behind a cell: its spring, what it moves, and what it carries of changes.
        const auto eliminate = [&](size_t i, L spring, L through, L stream) {
            const L r = kLong ? spring + positive(-stream) : spring, to_r = kLong ? spring + positive(stream) : spring;
            const L behind = (to_l * own) * inverse;
            own = one + behind;
            inverse = one / ((one + to_r) + behind);
            y = ((from_l - through) + l * y) * inverse;
            y.store(found[i].change);
            (r * inverse).store(found[i].pull);
            l = to_r, to_l = r, from_l = through;
        };
        const auto wild = [&] {
            const Extreme unit = least_of(one), closed = larger(-clearance, select(shallowest, Extreme{}, unit));
            const Extreme too_long = kLong ? Extreme{} : wave() * deepest - kLongStep * unit;
            return any_positive(larger(closed, larger(too_long, fastest - unit)));
        };
        for (size_t i = 0; i < last; ++i) {
            const L b_r = bed[i + 1], d_r = depth[i + 1], u_r = velocity[i + 2];
            const L up = b_r - b, more = d_r - d, mean = 0.5 * (d + d_r), cells = courant * u;
            shallowest = smaller(least_of(stands(b_r, d_r)), shallowest), deepest = larger(largest_of(mean), deepest);
            clearance = smaller(least_of(smaller(d_r + up, d - up)), clearance);
            fastest = larger(largest_of(size_of(cells)), fastest);
            const L spread = (0.25 * courant) * (u_r - u_l);
            const L h = kLong ? mean : (mean - 0.5 * (cells * more)) * (one - spread);
            const L w = friction.keep * u - friction.push * (wave_gain * (up + more));
            h.store(found[i + 1].face);
            w.store(found[i + 1].guess);
            const L speed = lambda * w + (1 - lambda) * u, stream = courant * (part * speed);
            L spring = (courant * lambda) * (gain * h);
            if (kLong) {
                spring = spring - 0.5 * size_of(stream);
                clearance = smaller(least_of(spring), clearance);
            }
            eliminate(i, spring, courant * (h * speed), stream);
            b = b_r, d = d_r, u_l = u, u = u_r;
            if (i % 64 == 63 && wild()) return false;
        }
        eliminate(last, L{}, L{}, L{});
        return !wild();
    }

    // The surface, what it moves, and what is left of it in cells and on faces. False: not calm.
    template <bool kLong> bool go_left(L part, Extreme shallowest_before) const {
        const Rows depth = this->depth, velocity = this->velocity;
        const Found* const found = this->found;
        T *const after = this->after, *const keeps = this->keeps;
        const size_t n = this->n;
        const double courant = axis.courant, lambda = axis.lambda;
        const FrictionLanes<N> friction(L::splat(axis.drag));
        const L gain = friction.push * L::splat(axis.gravity * courant * lambda), none{};
        Rounding<N, T> rounding;
        Extreme fastest{}, deepest{}, shallowest = least_of(L::splat(1e300)), most_owed{};
        Extreme solved = shallowest, most_moved{}; // of long steps: the least the solve leaves, the most through a face
        L x = L::load(found[n - 1].change), out{}, back{}; // what goes through the face behind, and comes back
        const auto fill = [&](size_t i, L in, L back_in) { // see left_in
            const L left = ((depth[i] + (in + back)) - out) - back_in;
            deepest = larger(largest_of(left), deepest);
            L stored = left;
            if constexpr (sizeof(T) < sizeof(double)) {
                stored = rounding.deep(left, rounding.owed);
                most_owed = larger(largest_of(size_of(rounding.owed)), most_owed);
            }
            shallowest = smaller(least_of(stored), shallowest);
            stored.store(after + i * N);
            out = in, back = back_in;
            if (kLong) solved = smaller(least_of(depth[i] + x), solved);
        };
        for (size_t i = n - 1; i > 0; --i) {
            const L x_r = x, u = velocity[i], x_l = L::load(found[i - 1].change) + L::load(found[i - 1].pull) * x_r;
            const L guess = L::load(found[i].guess), w = guess - gain * (x_r - x_l), h = L::load(found[i].face);
            const L now = lambda * w, then = (1 - lambda) * u;
            L speed = now + then;
            if (kLong) speed = select(size_of(speed) - 0x1p-40 * (size_of(now) + size_of(then)), speed, none);
            L through = courant * (h * speed);
            if (kLong) {
                through = through + (courant * (part * (lambda * guess + then))) * (0.5 * (x_l + x_r));
                most_moved = larger(largest_of(size_of(through)), most_moved);
            }
            const L kept = settled(w, double(Limits<T>::least));
            fastest = larger(largest_of(size_of(kept)), fastest);
            kept.store(keeps + i * N);
            fill(i, positive(through), positive(-through));
            x = x_l;
        }
        fill(0, none, none);
        for (size_t i : {size_t(0), n}) none.store(keeps + i * N);
        if (x.any_nan()) return false; // as it would be if any number had been
        const Extreme least = larger(16 * most_owed, least_of(L::splat(double(Limits<T>::least))));
        const Extreme most = least_of(L::splat(kMost)), one = least_of(L::splat(1));
        Extreme strange = larger(least - shallowest, larger(deepest, fastest) - most);
        if (kLong) {
            // A cell drops out of the solve, or so much leaves it that the limiter's rounding counts; see bound_speeds.
            const Extreme dry = select(solved, Extreme{}, one), drained = 0x1p-30 * (deepest + most_moved) - shallowest;
            const Extreme falls = fastest * fastest - axis.gravity * shallowest_before;
            strange = larger(larger(strange, dry), larger(drained, falls));
        } else {
            strange = larger(strange, wave() * deepest - kVeryLongStep * one);
        }
        if (any_positive(strange)) return false;
        const Extreme rushing = fastest * fastest - (axis.gravity / 4) * shallowest;
        if (any_positive(smaller((1 + 0x1p-20) * wave() * deepest - one, rushing)) && rushes()) return false;
        if constexpr (sizeof(T) < sizeof(double)) rounding.shallowest = L::splat(least_in(shallowest));
        rounding.hand_back(n, after);
        return true;
    }

    // Whether water may rush anywhere so that newcomers slow it (see slowed_by_newcomers). Depths are rounded already.
    bool rushes() const {
        L any{};
        for (size_t i = 1; i < n; ++i) {
            const L u = L::load(keeps + i * N), d = larger(L::load(after + (i - 1) * N), L::load(after + i * N));
            any = larger(any, smaller(1.25 * wave() * d - L::splat(1), u * u - (axis.gravity / 4) * d));
        }
        return any_positive(any);
    }

    static constexpr double kMost = 0x1p100; // far from where anything overflows

public:
    // `count` lines from `first` on; work: as for sweep_water.
    CalmLines(const WaterAxis& a, const WaterLines<T>& all, size_t first, size_t count, double* work)
        : axis(a),
          lines(all),
          place{all.along, all.across, first, count},
          n(a.cells),
          second(count - N / 2),
          upright(N == 1 || all.across == 1),
          free(work) {}

    // Makes the step if all of the lines are calm, else leaves them as they are.
    bool step() const {
        L part{};
        Extreme shallowest;
        const bool calm = is_long(part) ? go_right<true>(part, shallowest) && go_left<true>(part, shallowest)
                                        : go_right<false>(part, shallowest) && go_left<false>(part, shallowest);
        if (!calm) return false;
        put_back(after, n, lines.depth);
        put_back(keeps, n + 1, lines.velocity);
        for (size_t k = place.first; k < place.first + place.lanes; ++k)
            for (size_t t = 0; t < kTallies; ++t) lines.tally[k * kTallies + t] = t == kSolves ? 1 : 0;
        return true;
    }
};

} // namespace CD_ISA
} // namespace cd
