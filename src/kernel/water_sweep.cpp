// Sweeps of a water's lines, alternating: all of a step along an axis at once. A bundle is as wide as the widest
// register whatever the instruction set, so that its lines share nothing but the way to memory; lanes that no line
// fills are dry land.
#include "kernel/water_calm.hh"

namespace cd {
namespace CD_ISA {

namespace {

template <class T> struct Sweep : WaterBundles<T> {
    template <int N> bool bundle(size_t first) const {
        const WaterLines<T>& lines = this->lines;
        const size_t n = this->axis.cells;
        const Place p = this->template place_of<N>(first);
        size_t used;
        WaterLine<N> line = this->template open_line<N>(p, used);
        this->template fetch_state<N>(p, line, used);

        line.step();

        Lanes<N> probe{};
        settle_state<N, T>(n, line.after, line.velocity, probe);
        put<N>(p, n, line.after, lines.depth);
        put<N>(p, n + 1, line.velocity, lines.velocity);
        if (lines.held) put<N>(p, n, line.depth, lines.held);
        if (lines.moved) put<N>(p, n + 1, line.transfer, lines.moved);
        this->template put_tally<N>(p, line);
        return !probe.any_nan();
    }
};

// Lines that carry: like those of a sweep, but the velocities lie between them.
template <class T> struct Carry {
    const WaterCarried<T>& c;
    double* work;

    template <int N> bool bundle(size_t first) const {
        using L = Lanes<N>;
        const size_t m = c.nodes, lanes = c.lines - first < N ? c.lines - first : size_t(N);
        const auto panel = [&](size_t number) { return work + number * (m + 2) * N; };
        double *const u = panel(0), *const volume = panel(1), *const through = panel(2), *const x = panel(3),
                      *const pull = panel(4), *const rest = panel(5), *const other = panel(6), *const open = panel(7);
        const Place p{c.along, c.across, first, lanes};
        fetch<N>(p, m, c.velocity, u);
        const auto fetch_mean = [&](size_t count, const double* const* from, double* to) {
            fetch<N>(p, count, from[0], to);
            fetch<N>(p, count, from[1], other);
            for (size_t i = 0; i < count; ++i) (0.5 * (L::load(to + i * N) + L::load(other + i * N))).store(to + i * N);
        };
        fetch_mean(m, c.held, volume);
        fetch_mean(m + 1, c.moved, through);
        const bool closes = c.wall || c.mask[0];
        if (closes) fetch_openings<N>(p, open);
        const auto row = [&](size_t j) {
            const L v = L::load(volume + j * N);
            L left = positive(L::load(through + j * N)), right = positive(-L::load(through + (j + 1) * N));
            if (!c.ring && j == 0) left = L{};
            if (!c.ring && j + 1 == m) right = L{};
            RowLanes<N> r{v, left, right, left, right, v * L::load(u + j * N)};
            if (!closes) return r;
            const L is_open = L::load(open + j * N); // a closed face stays at rest, whatever passes
            left = is_open * left, right = is_open * right;
            return RowLanes<N>{select(is_open, v, L::splat(1)), left, right, left, right, is_open * r.load};
        };
        if (c.ring) solve_round<N>(m, row, x, rest, pull);
        else solve_rows<N>(0, m, row, L{}, L{}, x, pull);
        // Where there is no water a velocity stays: it was carried there for what comes.
        for (size_t j = 0; j < m; ++j) {
            const RowLanes<N> r = row(j);
            select(r.ground + (r.left + r.right), L::load(x + j * N), L::load(u + j * N)).store(x + j * N);
        }
        L probe{};
        settle<N, T>(m, x, probe);
        put<N>(p, m, x, c.velocity);
        return !probe.any_nan();
    }

    template <int N> void fetch_openings(const Place& p, double* open) const {
        const Place bytes{c.byte_along, c.byte_across, p.first, p.lanes};
        const auto blocks = [&](const uint8_t* array, uint8_t value, size_t at) { return array && array[at] == value; };
        for (size_t j = 0; j < c.nodes; ++j)
            for (size_t lane = 0; lane < N; ++lane) {
                const size_t at = bytes.at(j, lane < p.lanes ? lane : 0);
                const bool closed = blocks(c.mask[0], 0, at) || blocks(c.mask[1], 0, at) || blocks(c.wall, 1, at);
                open[j * N + lane] = closed ? 0 : 1;
            }
    }
};

} // namespace

// Whether the `count` lines from `line` on were calm, and have made their step.
template <int N, class T>
bool sweep_calm(const WaterAxis& axis, const WaterLines<T>& lines, double* work, size_t& line, size_t count) {
    if (!CalmLines<N, T>(axis, lines, line, count, work).step()) return false;
    line += count;
    return true;
}
// How many of the lines that are left go together, so that the last ones, too, are more than half of what fits.
inline size_t calm_lines(size_t left) {
    constexpr size_t most = kCalmLanes, half = most / 2;
    return left <= most ? left : left > most + 1 && left < most + half ? half : most;
}

template <class T>
bool sweep_water(const WaterAxis& axis, const WaterLines<T>& all, double* work, size_t first, size_t count) {
    const size_t end = (first + count) * kWaterPack < all.lines ? (first + count) * kWaterPack : all.lines;
    WaterLines<T> lines = all;
    lines.lines = end; // bundles end where the task does
    const Sweep<T> sweep{{axis, lines, work}};
    if (!may_be_calm(axis, lines)) return in_bundles(sweep, end, first, count);
    constexpr int half = kCalmLanes / 2;
    bool finite = true;
    for (size_t line = first * kWaterPack; line < end;) {
        const size_t left = end - line, together = calm_lines(left);
        if (together > half && sweep_calm<kCalmLanes>(axis, lines, work, line, together)) continue;
        if (left >= half && sweep_calm<half>(axis, lines, work, line, half)) continue;
        if (left <= 4 && sweep_calm<1>(axis, lines, work, line, 1)) continue; // few: one by one is faster
        if (all.lines == 1) return sweep.template bundle<1>(0);
        finite &= sweep.template bundle<int(kWaterLanes)>(line);
        line += kWaterLanes;
    }
    return finite;
}

template <class T> bool carry_across(const WaterCarried<T>& carried, double* work, size_t first, size_t count) {
    return in_bundles(Carry<T>{carried, work}, carried.lines, first, count);
}

#if CD_WITH_FLOAT32
template bool sweep_water(const WaterAxis&, const WaterLines<float>&, double*, size_t, size_t);
template bool carry_across(const WaterCarried<float>&, double*, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool sweep_water(const WaterAxis&, const WaterLines<double>&, double*, size_t, size_t);
template bool carry_across(const WaterCarried<double>&, double*, size_t, size_t);
#endif

} // namespace CD_ISA
} // namespace cd
