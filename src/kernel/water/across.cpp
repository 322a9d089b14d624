// What a sweep has moved along its lines carries the velocities of the other axis with it, too: see momentum.hh.
#include "kernel/water/momentum.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Faces between two lines of cells, one after the other along them.
struct AcrossCarriers {
    Neighbours places;
    Panel velocity, water, volume, flux; // water: what there is after the sweep, volume before it; flux: between faces
    Panel opening, beside;               // of faces that carry and of those between them; null: all are open

    FaceVolume at(size_t i) const {
        const L v = positive(water[i] - (flux[i] - flux[i + 1])), u = velocity[i];
        volume.put(i, v);
        if (!opening) return {v, v * u, u};
        const L open = opening[i];
        return {select(open, v, L::splat(kUnmoved)), open * (v * u), u};
    }
    FaceVolume outside(int) const { return {L::splat(kUnmoved), L{}, L{}}; }
    L through(size_t k) const { return flux[k]; }
    // In this direction water does not push itself: slopes are of second order at uneven depths, too.
    L sloped(size_t k, L through) const {
        if (!places.ring && (k == 0 || k == places.count)) return L{};
        const size_t l = places.before(k), r = k < places.count ? k : 0;
        const L q = size_of(through), given = select(through, volume[l], volume[r]);
        const L part = smaller(q, positive(given - q)) * half_slope(through, velocity, places, l, r);
        return beside ? select(through, beside[l], beside[r + 1]) * part : part; // what is behind a wall tells nothing
    }
    // Where there is no water nothing moves; where none has passed, what is there stays, to the bit.
    void set(size_t i, L u) const {
        const L passes = size_of(flux[i]) + size_of(flux[i + 1]);
        velocity.put(i, select(water[i], select(passes, u, velocity[i]), L{}));
    }
};

struct Across {
    const WaterSweep& sweep;
    const WaterLines& lines;
    double* work;

    bool bundle(size_t line, size_t lanes) const {
        if (line > 0) return carry(line - 1, line, lanes);
        const bool finite = !lines.seam || carry(lines.lines - 1, 0, 1);
        return (lanes == 1 || carry(0, 1, lanes - 1)) && finite;
    }

    // The faces before the lines [line, line + lanes), with the lines from `before` on on their other side.
    bool carry(size_t before, size_t line, size_t lanes) const {
        const size_t n = sweep.cells;
        const Place p = place_of(sweep, lines.numbers, line, lanes),
                    p_before = place_of(sweep, lines.numbers, before, lanes);
        double* free = work;
        const auto panel = [&] { return take_panel(free, n); };
        AcrossCarriers faces{{n, sweep.ring()}, panel(), panel(), panel(), panel(), {}, {}};
        const Panel pull = panel(), around = panel(), answers = panel();
        const auto fetch_mean = [&](size_t count, const StateNumbers& from, Panel to) {
            fetch(p_before, count, from, to);
            fetch(p, count, from, pull);
            for (size_t i = 0; i < count; ++i) to.put(i, 0.5 * (to[i] + pull[i]));
        };
        const Reach speeds = fetch(p, n, lines.velocity, faces.velocity);
        if (!any_positive(larger(speeds.largest, -speeds.least))) return true; // nothing to carry
        // In the mean of both lines.
        fetch_mean(n + 1, lines.moved, faces.flux);
        fetch_mean(n, lines.depth, faces.water);
        const Place b = place_of(sweep, lines.bytes, line, lanes),
                    b_before = place_of(sweep, lines.bytes, before, lanes);
        if (lines.mask || lines.wall_between) {
            faces.opening = panel();
            for (size_t lane = 0; lane < kLines; ++lane)
                for (size_t i = 0; i < n; ++i) {
                    const size_t at = b.at(i, lane);
                    const bool open = lines.there(b_before.at(i, lane)) && lines.there(at) && !lines.walled_between(at);
                    faces.opening.first[i * kLines + lane] = open ? 1 : 0;
                }
        }
        if (lines.has_closed_faces()) { // closed is what both lines have closed
            fetch_openings(b, lines, faces.places, faces.beside = panel());
            fetch_openings(b_before, lines, faces.places, pull);
            for (size_t i = 0; i <= n; ++i) faces.beside.put(i, larger(faces.beside[i], pull[i]));
        }

        carry_line(n, sweep.ring(), faces, answers, pull, around);
        return !put(p, n, faces.velocity, lines.velocity, lines.velocity.range().least).any_nan();
    }
};

} // namespace

bool carry_across(const WaterSweep& sweep, const WaterLines& lines, double* work, size_t first, size_t count) {
    return in_bundles(Across{sweep, lines, work}, lines.lines, first, count);
}

} // namespace CD_ISA
} // namespace cd
