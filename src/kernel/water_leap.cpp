// Explicit steps of calm water, cell by cell in one pass: the same bits as from guess_water to keep_water
// (water_apart.cpp), for water between walls, wet all over, where no cell may run dry, no film hangs above its
// neighbour, and neither waves nor water cross more than a cell. What would make it other than calm is only kept as
// extremes, and the results lie beside the state until all of them are known.
#include "kernel/lines.hh"
#include "kernel/water_panels.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Of what N lanes have seen, see Leap::calm.
template <int N> struct Seen {
    using L = Lanes<N>;
    L shallowest = L::splat(1e300), clearance = L::splat(1), deepest{}, fastest{}, most_owed{}, overdrawn{}, probe{};
};

template <class T> class Leap {
    const WaterAxis* const axis; // x and y
    const WaterGrid<T>& grid;
    double *const through, *const before; // of a row's faces along x, and of those along y before it: as depths
    double owed[kRowChains];              // see fill_water
    const FrictionLanes<1> friction{Lanes<1>{axis->drag}}; // of both axes

    // What a face between wet cells will move, as a depth; its new velocity goes to `next`, if anywhere.
    template <int N>
    Lanes<N> move(const WaterAxis& a, const T* velocity, T* next, size_t at, size_t step, Seen<N>& seen) const {
        using L = Lanes<N>;
        const L b_l = L::load(grid.bed + at - step), b_r = L::load(grid.bed + at);
        const L d_l = L::load(grid.depth + at - step), d_r = L::load(grid.depth + at), u = L::load(velocity + at);
        const L up = b_r - b_l, more = d_r - d_l, mean = 0.5 * (d_l + d_r), cells = a.courant * u;
        const L h = mean - 0.5 * (cells * more);
        const L w = friction.keep.v * u - friction.push.v * ((a.gravity * a.courant) * (up + more));
        seen.clearance = smaller(smaller(d_r + up, d_l - up), seen.clearance);
        seen.fastest = larger(larger(size_of(cells), a.courant * size_of(w)), seen.fastest);
        if (next) settled_number<T>(w, seen.probe).store(next + at);
        return a.courant * (h * (a.lambda * w + (1 - a.lambda) * u));
    }

    template <int N> void along_x(size_t begin, size_t i, Seen<N>& seen) const {
        move<N>(axis[0], grid.velocity[0], grid.next_velocity[0], begin + i, 1, seen).store(through + i);
    }

    // The faces behind cells along y, and the cells.
    template <int N> void fill(size_t i, size_t row, Seen<N>& seen) {
        using L = Lanes<N>;
        const size_t at = row * grid.pitch + i;
        const L x = L::load(through + i), x_r = L::load(through + i + 1), y = L::load(before + i);
        L y_r{};
        if (row + 1 < grid.rows)
            y_r = move<N>(axis[1], grid.velocity[1], grid.next_velocity[1], at + grid.pitch, grid.pitch, seen);
        y_r.store(before + i);
        const L in = ((positive(x) + positive(-x_r)) + positive(y)) + positive(-y_r);
        const L out = ((positive(-x) + positive(x_r)) + positive(-y)) + positive(y_r);
        const L was = L::load(grid.depth + at), now = (was + in) - out;
        L stored = now;
        if constexpr (sizeof(T) < sizeof(double)) {
            double* const chain = owed + i % kRowChains;
            L left = L::load(chain);
            stored = Rounding<N, T>::deep(now, left);
            left.store(chain);
            seen.most_owed = larger(size_of(left), seen.most_owed);
        }
        stored.store(grid.next_depth + at);
        seen.overdrawn = larger(out - was, seen.overdrawn);
        seen.shallowest = smaller(smaller(was, stored), seen.shallowest);
        seen.deepest = larger(larger(was, now), seen.deepest);
    }

    template <int N> bool calm(const Seen<N>& s) const {
        using L = Lanes<N>;
        const L one = L::splat(1), least = larger(4.0 * kRowChains * s.most_owed, L::splat(double(Limits<T>::least)));
        L wild = larger(larger(-s.clearance, s.overdrawn), larger(least - s.shallowest, s.fastest - one));
        wild = larger(wild, s.deepest - L::splat(kDeepest));
        for (const WaterAxis* a : {axis, axis + 1})
            wild = larger(wild, ((1 + 0x1p-20) * a->gravity * a->courant * a->courant) * s.deepest - one);
        return !any_positive(wild) && !s.probe.any_nan();
    }

    static constexpr double kDeepest = 0x1p100; // far from where anything overflows

public:
    // work: two rows of faces
    Leap(const WaterAxis* a, const WaterGrid<T>& g, double* first, double* second)
        : axis(a), grid(g), through(first), before(second) {}

    // The rows [first, end). False: the water is not calm.
    bool rows(size_t first, size_t end) {
        constexpr size_t kWide = kNative;
        const size_t n = grid.columns;
        Seen<kNative> wide;
        Seen<1> single;
        for (size_t i = 0; i < n && first == 0; ++i) before[i] = 0, grid.next_velocity[1][i] = 0;
        for (size_t i = 0; i < n && first > 0; ++i) // which the row before keeps
            move<1>(axis[1], grid.velocity[1], nullptr, first * grid.pitch + i, grid.pitch, single).store(before + i);
        for (size_t row = first; row < end; ++row) {
            T *const u = grid.next_velocity[0] + row * grid.pitch, *const depth = grid.next_depth + row * grid.pitch;
            const size_t begin = row * grid.pitch;
            for (size_t wall : {size_t(0), n}) through[wall] = 0, u[wall] = 0;
            size_t i = 1;
            for (; i + kWide <= n; i += kWide) along_x<kNative>(begin, i, wide);
            for (; i < n; ++i) along_x<1>(begin, i, single);
            memset(owed, 0, sizeof owed);
            for (i = 0; i + kWide <= n; i += kWide) fill<kNative>(i, row, wide);
            for (; i < n; ++i) fill<1>(i, row, single);
            if constexpr (sizeof(T) < sizeof(double)) depth[n - 1] = T(double(depth[n - 1]) + sum_of_chains(owed));
            if (row + 1 == grid.rows) memset(grid.next_velocity[1] + begin + grid.pitch, 0, n * sizeof(T));
            if ((row % 32 == 31 || row + 1 == end) && !(calm(wide) && calm(single))) return false;
        }
        return true;
    }
};

} // namespace

template <class T> bool leap_water(const WaterAxis* axis, const WaterGrid<T>& grid, double* through, double* before,
                                   size_t first, size_t count) {
    return Leap<T>(axis, grid, through, before).rows(first, first + count);
}

#if CD_WITH_FLOAT32
template bool leap_water(const WaterAxis*, const WaterGrid<float>&, double*, double*, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool leap_water(const WaterAxis*, const WaterGrid<double>&, double*, double*, size_t, size_t);
#endif

} // namespace CD_ISA
} // namespace cd
