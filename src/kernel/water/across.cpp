// What a sweep has moved along its lines carries the velocities of the other axis with it, too: see carry.hh.
#include "kernel/water/sweep.hh"

#include "kernel/water/carry.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Faces between two lines of cells, one after the other along them.
template <int N> struct AcrossCarriers {
    using L = Lanes<N>;
    size_t n;
    bool ring;
    Panel<N> velocity, volume, flux; // flux: between them
    Panel<N> opening;                // null: all are open
    Panel<N> results;

    CarrierLanes<N> at(size_t i) const {
        const L v = volume[i], u = velocity[i];
        if (!opening) return {v, v * u, u};
        const L open = opening[i];
        return {select(open, v, L::splat(kUnmoved)), open * (v * u), u};
    }
    CarrierLanes<N> outside(int) const { return {L::splat(kUnmoved), L{}, L{}}; }
    L through(size_t k) const { return flux[k]; }
    // In this direction water does not push itself, and slopes need not keep to steps that resolve waves.
    L sloped(size_t k, L through) const {
        if (!ring && (k == 0 || k == n)) return L{};
        L u[4];
        for (size_t j = 0; j < 4; ++j) { // carriers k - 2 to k + 1
            const size_t i = k + j;
            u[j] = velocity[ring ? (i + 2 * n - 2) % n : i < 2 ? 0 : i - 2 < n ? i - 2 : n - 1];
        }
        const L q = size_of(through), given = select(through, volume[k > 0 ? k - 1 : n - 1], volume[k < n ? k : 0]);
        return smaller(q, positive(given - q)) * half_slope(through, u);
    }
    // Where there is no water nothing moves.
    void set(size_t i, L u) const { results.put(i, u); }
};

struct Across {
    const WaterAcross& across;
    double* work;

    template <int N> bool bundle(size_t first) const {
        using L = Lanes<N>;
        const size_t n = across.cells;
        const Place p = place_of(across, first, N);
        Panels<N> panel{work, n};
        AcrossCarriers<N> faces{n, across.ring, panel(), panel(), panel(), {}, panel()};
        const Panel<N> pull = panel(), around = panel(), answers = panel(), water = panel();
        fetch(p, n, across.velocity, faces.velocity);
        // How deep both lines were before the sweep, in the mean, and are now.
        fetch_mean(p, n + 1, across.moved, faces.flux, pull);
        fetch_mean(p, n, across.depth, water, pull);
        for (size_t i = 0; i < n; ++i) faces.volume.put(i, positive(water[i] - (faces.flux[i] - faces.flux[i + 1])));
        if (across.wall || across.mask[0]) fetch_openings(p, faces.opening = panel());

        carry_line<N>(n, across.ring, faces, answers, pull, around);
        for (size_t i = 0; i < n; ++i) {
            const L passes = size_of(faces.flux[i]) + size_of(faces.flux[i + 1]); // 0: what is there stays, to the bit
            const L u = select(passes, faces.results[i], faces.velocity[i]);
            faces.results.put(i, select(water[i], u, L{}));
        }
        return !put(p, n, faces.results, across.velocity, across.velocity.range().least).any_nan();
    }

    template <int N>
    void fetch_mean(const Place& p, size_t count, const StateNumbers* from, Panel<N> to, Panel<N> scratch) const {
        fetch(p, count, from[0], to);
        fetch(p, count, from[1], scratch);
        for (size_t i = 0; i < count; ++i) to.put(i, 0.5 * (to[i] + scratch[i]));
    }
    template <int N> void fetch_openings(const Place& p, Panel<N> to) const {
        const Place bytes{across.byte_along, across.byte_across, p.line, p.lanes};
        for (size_t i = 0; i < across.cells; ++i)
            for (size_t lane = 0; lane < N; ++lane) {
                const size_t at = bytes.at(i, lane);
                const bool there = !across.mask[0] || (across.mask[0][at] != 0 && across.mask[1][at] != 0);
                to.first[i * N + lane] = there && !(across.wall && across.wall[at] != 0) ? 1 : 0;
            }
    }
};

} // namespace

bool carry_across(const WaterAcross& across, double* work, size_t first, size_t count) {
    return in_bundles(Across{across, work}, across.lines, first, count);
}

} // namespace CD_ISA
} // namespace cd
