#include "kernel/explicit_sweep.hh"

#include "kernel/line_lanes.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Everything is updated in place: what node i needs of the old state of its left neighbours (the tension of the spring
// and the moments of the bends there) is carried along.
template <class T> struct Sweep {
    const Lines<T>& lines;
    const ExplicitCoefficients& c;
    double dt;
    const double* gravity;
    Carrier carrier;
    bool finite = true;

    template <int N> Lanes<N> x(size_t i, size_t first) const {
        return Lanes<N>::load(lines.position + i * lines.pitch + first);
    }
    template <int N> Lanes<N> v(size_t i, size_t first) const {
        return Lanes<N>::load(lines.velocity + i * lines.pitch + first);
    }
    size_t after(size_t i) const { return i + 1 < lines.nodes ? i + 1 : 0; }

    template <int N> StateLanes<N> state(size_t i, size_t first) const { return {x<N>(i, first), v<N>(i, first)}; }

    // k_i (dx + damping dv): the force of spring i on its left node.
    template <int N> Lanes<N> tension(size_t i, const StateLanes<N>& left, const StateLanes<N>& right) const {
        return c.stiffness[i] * ((right.x - left.x) + c.damping * (right.v - left.v));
    }
    // b_j times the second difference at node j = i + 1; i: its left neighbour.
    template <int N> Lanes<N> moment(size_t i, size_t first) const {
        const size_t j = after(i), k = after(j);
        return c.bend[j] * (((x<N>(k, first) - x<N>(j, first)) - (x<N>(j, first) - x<N>(i, first))) +
                            c.damping * ((v<N>(k, first) - v<N>(j, first)) - (v<N>(j, first) - v<N>(i, first))));
    }

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        const size_t n = lines.nodes, z = n - 1;
        const L dv_gravity = lane_gravity<N>(lines, gravity, first);
        // what closes the ring is taken from the old state, before the first nodes move
        const L closing = c.ring ? tension<N>(z, state<N>(z, first), state<N>(0, first)) : L{};
        const L moment_last = c.ring && c.bend ? moment<N>(z - 1, first) : L{};
        const L moment_first = c.ring && c.bend ? moment<N>(z, first) : L{};
        L tension_left = closing, moment_left = moment_last, moment_here = moment_first, probe{};
        StateLanes<N> next = state<N>(0, first);
        for (size_t i = 0; i < n; ++i) {
            const size_t at = i * lines.pitch + first;
            const StateLanes<N> here = next;
            const L x_old = here.x, v_old = here.v;
            if (i < z) next = state<N>(i + 1, first);
            fetch_next_bundle<N>(lines, at);
            const L tension_right = i < z ? tension<N>(i, here, next) : closing;
            L force = tension_right - tension_left;
            tension_left = tension_right;
            if (c.bend) {
                const L moment_right = i + 2 < n ? moment<N>(i, first) : i + 1 < n ? moment_last : moment_first;
                force = force - (moment_left - moment_here - (moment_here - moment_right));
                moment_left = moment_here;
                moment_here = moment_right;
            }
            const L pushed = outside<N>(lines, c.gains, i, at, dv_gravity, x_old, v_old);
            const L v_new = v_old + (c.inertia[i] * force + pushed);
            store_settled(v_new, lines.velocity + at, probe);
            if (carrier == Carrier::kNothing) continue;
            store_settled(x_old + dt * (carrier == Carrier::kOldVelocity ? v_old : v_new), lines.position + at, probe);
        }
        finite &= !probe.any_nan();
    }
};

// The plain case of few lines with no gaps between nodes: springs, gravity, and a position that moves by the new
// velocity. Goes along the numbers of all lines, whose neighbours are `pitch` away. Rounds exactly as Sweep does. A
// bundle is stored only when the next one has read its old state. kUniform: springs are alike, and nodes but for the
// ends: one number each in place of a row, which in float32 is three times the state.
template <class T, bool kUniform> struct Along {
    const Lines<T> lines; // values, which stores to the state cannot be taken to change
    const ExplicitCoefficients c;
    double dt;
    const double* gravity;
    bool finite = true;

    static constexpr int kSide = 8, kMostLines = 4;
    double falls[kSide + kMostLines] = {}; // gravity of number m of the lines at [m % pitch]

    template <int N> struct Moved {
        size_t m;
        StateLanes<N> to;
    };
    template <int N> Lanes<N> of_row(const double* row, size_t m) const {
        if (kUniform) return Lanes<N>::splat(row[1]);
        return Lanes<N>::load(row + m); // of a single line
    }
    // Numbers m to m + N - 1, with springs on both sides of each; m is of `line`.
    template <int N> Moved<N> move(size_t m, size_t line, Lanes<N> x_left) const {
        using L = Lanes<N>;
        const size_t p = lines.pitch;
        const L x = L::load(lines.position + m), v = L::load(lines.velocity + m);
        const L right =
            (kUniform ? L::splat(c.stiffness[0]) : L::load(c.stiffness + m)) * (L::load(lines.position + m + p) - x);
        const L left = (kUniform ? L::splat(c.stiffness[0]) : L::load(c.stiffness + m - 1)) * (x - x_left);
        return finish<N>(m, line, x, v, right - left, of_row<N>(c.inertia, m), of_row<N>(c.gains.gravity, m));
    }
    template <int N> Moved<N> finish(size_t m, size_t line, Lanes<N> x, Lanes<N> v, Lanes<N> force, Lanes<N> inertia,
                                     Lanes<N> gain) const {
        const Lanes<N> v_new = v + (inertia * force + gain * Lanes<N>::load(falls + line));
        return {m, {x + dt * v_new, v_new}};
    }
    template <int N> void store(const Moved<N>& moved, Lanes<N>& probe) const {
        store_settled(moved.to.v, lines.velocity + moved.m, probe);
        store_settled(moved.to.x, lines.position + moved.m, probe);
    }

    void run() {
        using One = Lanes<1>;
        const T* const x = lines.position;
        const size_t p = lines.pitch, last = (lines.nodes - 1) * p;
        for (size_t m = 0; m < kSide + kMostLines; ++m) falls[m] = gravity[m % p % lines.components];
        One probe{}, left[kMostLines];
        Lanes<kSide> probes{};
        Moved<1> first[kMostLines];
        for (size_t l = 0; l < p; ++l) {
            left[l] = One::load(x + l);
            const One pull = One{c.stiffness[0]} * (One::load(x + p + l) - left[l]);
            first[l] = finish<1>(l, l, left[l], One::load(lines.velocity + l), pull - One{}, One{c.inertia[0]},
                                 One{c.gains.gravity[0]});
        }
        size_t m = p, line = 0; // m % p
        if (m + kSide <= last) {
            Moved<kSide> held = move<kSide>(m, line, Lanes<kSide>::load(x + m - p));
            for (size_t l = 0; l < p; ++l) store(first[l], probe);
            const size_t turn = kSide % p;
            for (m += kSide, line = turn; m + kSide <= last; m += kSide) {
                const Moved<kSide> next = move<kSide>(m, line, Lanes<kSide>::load(x + m - p));
                store(held, probes);
                held = next;
                line += turn;
                if (line >= p) line -= p;
            }
            for (size_t l = 0; l < p; ++l) left[(line + l) % p] = One::load(x + m + l - p);
            store(held, probes);
        } else {
            for (size_t l = 0; l < p; ++l) store(first[l], probe);
        }
        for (; m < last; ++m, line = (line + 1) % p) {
            const One here = One::load(x + m);
            store(move<1>(m, line, left[line]), probe);
            left[line] = here;
        }
        const size_t z = lines.nodes - 1;
        for (; m < last + p; ++m, line = (line + 1) % p) {
            const One here = One::load(x + m), pull = One{c.stiffness[z - 1]} * (here - left[line]);
            const One inertia{c.inertia[z]}, gain{c.gains.gravity[z]};
            store(finish<1>(m, line, here, One::load(lines.velocity + m), One{} - pull, inertia, gain), probe);
        }
        finite = !probe.any_nan() && !probes.any_nan();
    }
};

template <bool kUniform, class T>
bool along(const Lines<T>& lines, const ExplicitCoefficients& c, double dt, const double* gravity) {
    Along<T, kUniform> numbers{lines, c, dt, gravity};
    numbers.run();
    return numbers.finite;
}

template <class T> struct Drift {
    const Lines<T>& lines;
    double dt;

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        L probe{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            store_settled(L::load(lines.position + at) + dt * L::load(lines.velocity + at), lines.position + at, probe);
        }
    }
};

} // namespace

template <class T> bool explicit_sweep(const Lines<T>& lines, const ExplicitCoefficients& c, double dt,
                                       const double* gravity, Carrier carrier, size_t first, size_t count) {
    const bool plain = !c.bend && !c.ring && c.damping == 0 && !c.gains.force && !c.gains.drag && !c.gains.attach;
    if (plain && carrier == Carrier::kNewVelocity && lines.nodes > 1 && count == lines.pitch && count <= 4) {
        if (c.uniform) return along<true>(lines, c, dt, gravity);
        if (count == 1) return along<false>(lines, c, dt, gravity);
    }
    Sweep<T> bundles{lines, c, dt, gravity, carrier};
    for_each_bundle<kLinesAtOnce>(first, count, bundles);
    return bundles.finite;
}

template <class T> void drift(const Lines<T>& lines, double dt, size_t first, size_t count) {
    Drift<T> bundles{lines, dt};
    for_each_bundle(first, count, bundles);
}

#if CD_WITH_FLOAT32
template bool explicit_sweep(const Lines<float>&, const ExplicitCoefficients&, double, const double*, Carrier, size_t,
                             size_t);
template void drift(const Lines<float>&, double, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool explicit_sweep(const Lines<double>&, const ExplicitCoefficients&, double, const double*, Carrier, size_t,
                             size_t);
template void drift(const Lines<double>&, double, size_t, size_t);
#endif

} // namespace CD_ISA
} // namespace cd
