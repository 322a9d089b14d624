#include "kernel/rod_sweep.hh"

namespace cd {

namespace {

template <class T> struct Sweep {
    const Lines<T>& lines;
    const RodCoefficients& c;
    const Stage<double>& stage;
    double *value, *slope;

    template <int N> Lanes<double, N> position(size_t i, size_t first) const {
        return Lanes<double, N>::load(lines.position + i * lines.pitch + first);
    }
    template <int N> Lanes<double, N> velocity(size_t i, size_t first) const {
        return Lanes<double, N>::load(lines.velocity + i * lines.pitch + first);
    }

    // The difference delta_{i+1} - delta_i at which spring i would be closed after the stage.
    template <int N> Lanes<double, N> spring_wish(size_t i, size_t first) const {
        const double rate = c.closing_rate ? c.closing_rate[i] : stage.closing_rate;
        return rate * (position<N>(i, first) - position<N>(i + 1, first)) +
               (velocity<N>(i, first) - velocity<N>(i + 1, first));
    }
    // The second difference of delta at which the line would be straight at node i after the stage.
    template <int N> Lanes<double, N> bend_wish(size_t i, size_t first) const {
        const auto turn = [](Lanes<double, N> a, Lanes<double, N> b, Lanes<double, N> d) { return (b - a) - (d - b); };
        return c.has_bend[i] *
               (stage.closing_rate *
                    turn(position<N>(i - 1, first), position<N>(i, first), position<N>(i + 1, first)) +
                turn(velocity<N>(i - 1, first), velocity<N>(i, first), velocity<N>(i + 1, first)));
    }

    template <int N> void forward(size_t first) const {
        using L = Lanes<double, N>;
        const L gravity = lane_gravity<N>(lines, stage.gravity, first);
        L u{}, d{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            const L own = outside<N>(lines, c.gains, i, at, gravity, position<N>(i, first), velocity<N>(i, first));
            if (i == 0) {
                u = own;
            } else {
                if (i > 1) d = d + bend_wish<N>(i - 1, first);
                const L stretch = spring_wish<N>(i - 1, first) - d;
                u = u + d + c.stretch_lift[i] * stretch;
                d = d + c.stretch[i] * stretch;
                const L pull = own - u;
                u = u + c.ground_lift[i] * pull;
                d = d + c.ground[i] * pull;
            }
            if (i % kSettleEvery == 0) {
                u = settled(u, Rest<double>::least);
                d = settled(d, Rest<double>::least);
            }
            u.store(value + at);
            d.store(slope + at);
        }
    }

    template <int N> void backward(size_t first) const {
        using L = Lanes<double, N>;
        L delta{}, d{};
        for (size_t i = lines.nodes; i-- > 0;) {
            const size_t at = i * lines.pitch + first;
            const L u_here = L::load(value + at), d_here = L::load(slope + at);
            if (i + 1 == lines.nodes) {
                delta = u_here;
                d = d_here;
            } else {
                delta = c.held[i] ? L{} : delta - d;
                d = i == 0 ? L{} : d_here + c.lean[i] * (delta - u_here) +
                                       c.bend[i] * (d - bend_wish<N>(i, first) - d_here);
            }
            if (i % kSettleEvery == 0) {
                delta = settled(delta, Rest<double>::least);
                d = settled(d, Rest<double>::least);
            }
            delta.store(value + at);
        }
    }

    template <int N> void bundle(size_t first) {
        forward<N>(first);
        backward<N>(first);
    }
};

} // namespace

template <class T>
void rod_sweep(const Lines<T>& lines, const RodCoefficients& c, const Stage<double>& stage, double* value,
               double* slope, size_t first, size_t count) {
    Sweep<T> bundles{lines, c, stage, value, slope};
    for_each_bundle<double>(first, count, bundles);
}

#if CD_WITH_FLOAT32
template void rod_sweep(const Lines<float>&, const RodCoefficients&, const Stage<double>&, double*, double*, size_t,
                        size_t);
#endif
#if CD_WITH_FLOAT64
template void rod_sweep(const Lines<double>&, const RodCoefficients&, const Stage<double>&, double*, double*, size_t,
                        size_t);
#endif

} // namespace cd
