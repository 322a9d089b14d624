#include "kernel/explicit_sweep.hh"

#include "kernel/line_lanes.hh"
#include "kernel/plain_lines.hh"

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

// The plain case of a single line: springs, gravity, and a position that moves by the new velocity. Goes along its
// nodes, and rounds exactly as Sweep does. A bundle is stored only when the next one has read its old state.
template <class T> struct Along {
    const Lines<T> lines; // values, which stores to the state cannot be taken to change
    const ExplicitCoefficients c;
    double dt, gravity;
    bool finite = true;

    static constexpr int kSide = 8;

    template <int N> struct Moved {
        size_t i;
        StateLanes<N> to;
    };
    // Nodes i to i + N - 1, with springs on both sides of each.
    template <int N> Moved<N> move(size_t i, Lanes<N> x_left) const {
        using L = Lanes<N>;
        const L x = L::load(lines.position + i);
        const L right = L::load(c.stiffness + i) * (L::load(lines.position + i + 1) - x);
        const L left = L::load(c.stiffness + i - 1) * (x - x_left);
        return finish<N>(i, x, right - left);
    }
    template <int N> Moved<N> finish(size_t i, Lanes<N> x, Lanes<N> force) const {
        using L = Lanes<N>;
        const L pushed = L::load(c.inertia + i) * force + L::load(c.gains.gravity + i) * L::splat(gravity);
        const L v_new = L::load(lines.velocity + i) + pushed;
        return {i, {x + dt * v_new, v_new}};
    }
    template <int N> void store(const Moved<N>& moved, Lanes<N>& probe) const {
        store_settled(moved.to.v, lines.velocity + moved.i, probe);
        store_settled(moved.to.x, lines.position + moved.i, probe);
    }

    void run() {
        using One = Lanes<1>;
        const T* const x = lines.position;
        const size_t last = lines.nodes - 1;
        One probe{}, left = One::load(x);
        Lanes<kSide> probes{};
        const Moved<1> first = finish<1>(0, left, One{c.stiffness[0]} * (One::load(x + 1) - left) - One{});
        size_t i = 1;
        if (i + kSide <= last) {
            Moved<kSide> held = move<kSide>(i, Lanes<kSide>::load(x));
            store(first, probe);
            for (i += kSide; i + kSide <= last; i += kSide) {
                const Moved<kSide> next = move<kSide>(i, Lanes<kSide>::load(x + i - 1));
                store(held, probes);
                held = next;
            }
            left = One::load(x + i - 1);
            store(held, probes);
        } else {
            store(first, probe);
        }
        for (; i < last; ++i) {
            const One here = One::load(x + i);
            store(move<1>(i, left), probe);
            left = here;
        }
        const One here = One::load(x + last);
        store(finish<1>(last, here, One{} - One{c.stiffness[last - 1]} * (here - left)), probe);
        finite = !probe.any_nan() && !probes.any_nan();
    }
};

template <class T> struct Drift {
    const Lines<T>& lines;
    double dt;
    bool finite = true;

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        L probe{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            store_settled(L::load(lines.position + at) + dt * L::load(lines.velocity + at), lines.position + at, probe);
        }
        finite &= !probe.any_nan();
    }
};

} // namespace

template <class T> bool explicit_sweep(const Lines<T>& lines, const ExplicitCoefficients& c, double dt,
                                       const double* gravity, Carrier carrier, size_t first, size_t count) {
    const bool plain = !c.bend && !c.ring && c.damping == 0 && !c.gains.force && !c.gains.drag && !c.gains.attach;
    if (plain && carrier == Carrier::kNewVelocity && lines.nodes > 1) {
        if (PlainLines<T>::takes(lines, c, dt, gravity)) return PlainLines<T>(lines, c, dt, gravity).step(first, count);
        if (lines.pitch == 1) {
            Along<T> nodes{lines, c, dt, gravity[0]};
            nodes.run();
            return nodes.finite;
        }
    }
    Sweep<T> bundles{lines, c, dt, gravity, carrier};
    for_each_bundle<kLinesAtOnce>(first, count, bundles);
    return bundles.finite;
}

template <class T> bool drift(const Lines<T>& lines, double dt, size_t first, size_t count) {
    Drift<T> bundles{lines, dt};
    for_each_bundle(first, count, bundles);
    return bundles.finite;
}

#if CD_WITH_FLOAT32
template bool explicit_sweep(const Lines<float>&, const ExplicitCoefficients&, double, const double*, Carrier, size_t,
                             size_t);
template bool drift(const Lines<float>&, double, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool explicit_sweep(const Lines<double>&, const ExplicitCoefficients&, double, const double*, Carrier, size_t,
                             size_t);
template bool drift(const Lines<double>&, double, size_t, size_t);
#endif

} // namespace CD_ISA
} // namespace cd
