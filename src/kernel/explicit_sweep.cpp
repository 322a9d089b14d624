#include "kernel/explicit_sweep.hh"

namespace cd {

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

    // k_i (dx + damping dv): the force of spring i on its left node.
    template <int N> Lanes<N> tension(size_t i, size_t first) const {
        const size_t j = after(i);
        return c.stiffness[i] *
               ((x<N>(j, first) - x<N>(i, first)) + c.damping * (v<N>(j, first) - v<N>(i, first)));
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
        const L closing = c.ring ? tension<N>(z, first) : L{};
        const L moment_last = c.ring && c.bend ? moment<N>(z - 1, first) : L{};
        const L moment_first = c.ring && c.bend ? moment<N>(z, first) : L{};
        L tension_left = closing, moment_left = moment_last, moment_here = moment_first, probe{};
        for (size_t i = 0; i < n; ++i) {
            const size_t at = i * lines.pitch + first;
            const L x_old = x<N>(i, first), v_old = v<N>(i, first);
            const L tension_right = i < z ? tension<N>(i, first) : closing;
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

template <class T>
bool explicit_sweep(const Lines<T>& lines, const ExplicitCoefficients& c, double dt, const double* gravity,
                    Carrier carrier, size_t first, size_t count) {
    Sweep<T> bundles{lines, c, dt, gravity, carrier};
    for_each_bundle(first, count, bundles);
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

} // namespace cd
