#include "kernel/explicit_sweep.hh"

#include <type_traits>

#include "kernel/line_lanes.hh"
#include "kernel/plain_lines.hh"

namespace cd {
namespace CD_NARROWER {
decltype(CD_ISA::explicit_sweep) explicit_sweep;
decltype(CD_ISA::drift) drift;
} // namespace CD_NARROWER
namespace CD_ISA {

namespace {

// Everything is updated in place: what node i needs of the old state of its left neighbours (the tension of the spring
// and the moments of the bends there) is carried along.
struct Sweep {
    const Lines& lines;
    const ExplicitCoefficients& c;
    double dt;
    const double* gravity;
    Carrier carrier;
    bool finite = true;

    template <int N> StateLanes<N> state(size_t i, size_t first) const {
        return load_state<N>(lines, i * lines.pitch + first);
    }

    // k_i (dx + damping dv): the force of spring i on its left node.
    template <int N> Lanes<N> tension(size_t i, const StateLanes<N>& left, const StateLanes<N>& right) const {
        return c.stiffness[i] * ((right.x - left.x) + c.damping * (right.v - left.v));
    }
    // b_j times the second difference at node j.
    template <int N>
    Lanes<N> moment(size_t j, const StateLanes<N>& left, const StateLanes<N>& here, const StateLanes<N>& right) const {
        return c.bend[j] *
               (((right.x - here.x) - (here.x - left.x)) + c.damping * ((right.v - here.v) - (here.v - left.v)));
    }

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        const size_t n = lines.nodes, z = n - 1;
        const L dv_gravity = lane_gravity<N>(lines, gravity, first);
        // what closes the ring is taken from the old state, before the first nodes move
        StateLanes<N> next = state<N>(0, first), later = state<N>(n > 1 ? 1 : 0, first);
        L closing{}, moment_last{}, moment_first{};
        if (c.ring) {
            const StateLanes<N> last = state<N>(z, first);
            closing = tension<N>(z, last, next);
            if (c.bend) moment_last = moment<N>(z, state<N>(z - 1, first), last, next);
            if (c.bend) moment_first = moment<N>(0, last, next, later);
        }
        L tension_left = closing, moment_left = moment_last, moment_here = moment_first, probe{};
        for (size_t i = 0; i < n; ++i) {
            const size_t at = i * lines.pitch + first;
            const StateLanes<N> here = next;
            const L x_old = here.x, v_old = here.v;
            next = later;
            if (i + 2 < n) later = state<N>(i + 2, first);
            fetch_next_bundle<N>(lines, at);
            const L tension_right = i < z ? tension<N>(i, here, next) : closing;
            L force = tension_right - tension_left;
            tension_left = tension_right;
            if (c.bend) {
                const L moment_right = i + 2 < n   ? moment<N>(i + 1, here, next, later)
                                       : i + 1 < n ? moment_last
                                                   : moment_first;
                force = force - (moment_left - moment_here - (moment_here - moment_right));
                moment_left = moment_here;
                moment_here = moment_right;
            }
            const L pushed = outside<N>(lines, c.gains, i, at, dv_gravity, x_old, v_old);
            const L v_new = v_old + (c.inertia[i] * force + pushed);
            store_settled(v_new, lines.velocity, at, probe);
            if (carrier == Carrier::kNothing) continue;
            store_settled(x_old + dt * (carrier == Carrier::kOldVelocity ? v_old : v_new), lines.position, at, probe);
        }
        finite &= !probe.any_nan();
    }
};

// The plain case of a single line: springs, gravity, and a position that moves by the new velocity. Goes along its
// nodes, and rounds exactly as Sweep does. A bundle is stored only when the next one has read its old state.
struct Along {
    const Lines lines; // values, which stores to the state cannot be taken to change
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
        const L x = load_lanes<N>(lines.position, i);
        const L right = L::load(c.stiffness + i) * (load_lanes<N>(lines.position, i + 1) - x);
        const L left = L::load(c.stiffness + i - 1) * (x - x_left);
        return finish<N>(i, x, right - left);
    }
    template <int N> Moved<N> finish(size_t i, Lanes<N> x, Lanes<N> force) const {
        using L = Lanes<N>;
        const L pushed = L::load(c.inertia + i) * force + L::load(c.gains.gravity + i) * L::splat(gravity);
        const L v_new = load_lanes<N>(lines.velocity, i) + pushed;
        return {i, {x + dt * v_new, v_new}};
    }
    template <int N> void store(const Moved<N>& moved, Lanes<N>& probe) const {
        store_state(moved.to, lines, moved.i, probe);
    }

    void run() {
        using One = Lanes<1>;
        const StateNumbers& x = lines.position;
        const size_t last = lines.nodes - 1;
        One probe{}, left = {x[0]};
        Lanes<kSide> probes{};
        const Moved<1> first = finish<1>(0, left, One{c.stiffness[0]} * (One{x[1]} - left) - One{});
        Moved<kSide> held{};
        size_t i = 1;
        for (; i + kSide <= last; i += kSide) {
            const Moved<kSide> next = move<kSide>(i, load_lanes<kSide>(x, i - 1));
            if (i > 1) store(held, probes);
            else store(first, probe);
            held = next;
        }
        if (i > 1) left = {x[i - 1]}, store(held, probes);
        else store(first, probe);
        for (; i < last; ++i) {
            const One here{x[i]};
            store(move<1>(i, left), probe);
            left = here;
        }
        const One here{x[last]};
        store(finish<1>(last, here, One{} - One{c.stiffness[last - 1]} * (here - left)), probe);
        finite = !probe.any_nan() && !probes.any_nan();
    }
};

struct Drift {
    const Lines& lines;
    double dt;
    bool finite = true;

    template <int N> void bundle(size_t first) {
        using L = Lanes<N>;
        L probe{};
        for (size_t i = 0; i < lines.nodes; ++i) {
            const size_t at = i * lines.pitch + first;
            const StateLanes<N> here = load_state<N>(lines, at);
            store_settled(here.x + dt * here.v, lines.position, at, probe);
        }
        finite &= !probe.any_nan();
    }
};

} // namespace

bool explicit_sweep(const Lines& lines, const ExplicitCoefficients& c, double dt, const double* gravity,
                    Carrier carrier, size_t first, size_t count) {
    const bool plain = !c.bend && !c.ring && c.damping == 0 && !c.gains.force && !c.gains.drag && !c.gains.attach;
    if (plain && carrier == Carrier::kNewVelocity && lines.nodes > 1) {
        bool finite = false;
        const bool made = lines.position.stored_state([&](auto* position) {
            using Plain = PlainLines<std::remove_pointer_t<decltype(position)>>;
            if (!Plain::takes(lines, c, dt, gravity)) return false;
            finite = Plain(lines, c, dt, gravity).step(first, count);
            return true;
        });
        if (made) return finite;
        if (lines.pitch == 1) {
            Along nodes{lines, c, dt, gravity[0]};
            nodes.run();
            return nodes.finite;
        }
    }
    Sweep bundles{lines, c, dt, gravity, carrier};
    for_each_bundle<kLinesAtOnce>(first, count, bundles, [&](size_t line, size_t left) {
        return CD_NARROWER::explicit_sweep(lines, c, dt, gravity, carrier, line, left);
    });
    return bundles.finite;
}

bool drift(const Lines& lines, double dt, size_t first, size_t count) {
    Drift bundles{lines, dt};
    for_each_bundle(first, count, bundles,
                    [&](size_t line, size_t left) { return CD_NARROWER::drift(lines, dt, line, left); });
    return bundles.finite;
}

} // namespace CD_ISA
} // namespace cd
