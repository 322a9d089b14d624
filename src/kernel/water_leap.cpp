// Explicit steps of calm water, row by row in one pass: the same bits as from guess_water to keep_water
// (water_apart.cpp), for water between walls, wet all over, where no cell may run dry, no film hangs above its
// neighbour, and neither waves nor water cross more than a cell. What would make it other than calm is only kept as
// extremes, and the results lie beside the state until all of them are known.
#include <type_traits>
#include <utility>

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

// What a row of faces moves before it is known what leaves cells the other way: the cells that water crosses, and its
// depth.
struct Flow {
    double *cells, *depth;
};

template <class T> class Leap {
    const WaterAxis* const axis; // x and y
    const WaterGrid<T>& grid;
    double owed[kRowChains];                               // see fill_water
    const FrictionLanes<1> friction{Lanes<1>{axis->drag}}; // of both axes
    Seen<kNative> wide;
    Seen<1> single;

    // Rows of numbers. Of faces along x: new velocities, the flow in this row and in the next, what leaves their cells
    // with it, and what this row's faces move at last.
    double *pushed, *leaves, *leaves_next, *through;
    Flow along, along_next;
    // Of faces along y: new velocities before this row, behind it and behind the next, the flow before this row and
    // behind it, and what those before move at last.
    double *here, *behind, *beyond, *before;
    Flow across, across_next;

    size_t step(int a) const { return a == 0 ? 1 : grid.pitch; }

    // body(width, place, what is seen) for all places of [first, end), as many at once as a register holds.
    template <class Body> void each(size_t first, size_t end, const Body& body) {
        for (; first + kNative <= end; first += kNative) body(std::integral_constant<int, kNative>(), first, wide);
        for (; first < end; ++first) body(std::integral_constant<int, 1>(), first, single);
    }

    // The new velocity of a face between wet cells; it goes into the state, or not.
    template <int N> Lanes<N> push(int a, size_t at, bool keeps, Seen<N>& seen) const {
        using L = Lanes<N>;
        const size_t l = at - step(a);
        const L d_l = L::load(grid.depth + l), d_r = L::load(grid.depth + at), u = L::load(grid.velocity[a] + at);
        const L up = L::load(grid.bed + at) - L::load(grid.bed + l), more = d_r - d_l;
        const double courant = axis[a].courant;
        const L w = friction.keep.v * u - friction.push.v * ((axis[a].gravity * courant) * (up + more));
        seen.clearance = smaller(smaller(d_r + up, d_l - up), seen.clearance);
        seen.fastest = larger(courant * larger(size_of(u), size_of(w)), seen.fastest);
        if (keeps) settled_number<T>(w, seen.probe).store(grid.next_velocity[a] + at);
        return w;
    }
    // Its flow, see WaterLine::look_ahead. w: the new velocities of the face before, of itself and of the one behind.
    template <int N> void look_ahead(int a, size_t at, const Lanes<N> (&w)[3], const Flow& flow, size_t i) const {
        using L = Lanes<N>;
        const double courant = axis[a].courant;
        const L d_l = L::load(grid.depth + at - step(a)), d_r = L::load(grid.depth + at), cells = courant * w[1];
        const L later = 0.5 * (d_l + d_r) - 0.5 * (cells * (d_r - d_l));
        cells.store(flow.cells + i);
        (later * (L::splat(1) - (0.25 * courant) * (w[2] - w[0]))).store(flow.depth + i);
    }
    template <int N> static Lanes<N> all_of(const Flow& flow, size_t i) {
        return Lanes<N>::load(flow.cells + i) * Lanes<N>::load(flow.depth + i);
    }
    // What a face moves, see look_beside. leave: from both cells beside it, the other way.
    template <int N> static Lanes<N> moved(const Flow& flow, size_t i, Lanes<N> leave) {
        const Lanes<N> h = Lanes<N>::load(flow.depth + i), gone = larger(smaller(0.25 * leave, 0.5 * h), -h);
        return Lanes<N>::load(flow.cells + i) * (h - gone);
    }

    void flow_along(size_t row, bool keeps, const Flow& flow, double* leaves) {
        const size_t begin = row * grid.pitch, n = grid.columns;
        for (size_t wall : {size_t(0), n}) pushed[wall] = flow.cells[wall] = flow.depth[wall] = 0;
        each(1, n,
             [&](auto width, size_t i, auto& seen) { push<width()>(0, begin + i, keeps, seen).store(pushed + i); });
        each(1, n, [&](auto width, size_t i, auto&) {
            using L = Lanes<width()>;
            const double* const w = pushed + i;
            look_ahead<width()>(0, begin + i, {L::load(w - 1), L::load(w), L::load(w + 1)}, flow, i);
        });
        each(0, n, [&](auto width, size_t i, auto&) {
            (all_of<width()>(flow, i + 1) - all_of<width()>(flow, i)).store(leaves + i);
        });
    }
    // Faces along y before a row; walls move nothing.
    void push_across(size_t row, bool keeps, double* to) {
        if (row == 0 || row >= grid.rows) return void(memset(to, 0, grid.columns * sizeof(double)));
        const size_t begin = row * grid.pitch;
        each(0, grid.columns,
             [&](auto width, size_t i, auto& seen) { push<width()>(1, begin + i, keeps, seen).store(to + i); });
    }
    void flow_across(size_t row, const double* w_l, const double* w, const double* w_r, const Flow& flow) {
        if (row == 0 || row >= grid.rows) {
            for (double* numbers : {flow.cells, flow.depth}) memset(numbers, 0, grid.columns * sizeof(double));
            return;
        }
        each(0, grid.columns, [&](auto width, size_t i, auto&) {
            using L = Lanes<width()>;
            look_ahead<width()>(1, row * grid.pitch + i, {L::load(w_l + i), L::load(w + i), L::load(w_r + i)}, flow, i);
        });
    }

    void move_along() {
        const auto leave = [&](auto width, size_t i) {
            return all_of<width()>(across_next, i) - all_of<width()>(across, i);
        };
        for (size_t wall : {size_t(0), grid.columns}) through[wall] = 0;
        each(1, grid.columns, [&](auto width, size_t i, auto&) {
            moved<width()>(along, i, leave(width, i - 1) + leave(width, i)).store(through + i);
        });
    }
    // Cells, and the faces along y behind them.
    template <int N> void fill(size_t i, size_t row, Seen<N>& seen) {
        using L = Lanes<N>;
        const size_t at = row * grid.pitch + i;
        const L x = L::load(through + i), x_r = L::load(through + i + 1), y = L::load(before + i);
        const L y_r = moved<N>(across_next, i, L::load(leaves + i) + L::load(leaves_next + i));
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
    // work: 16 rows of faces
    Leap(const WaterAxis* a, const WaterGrid<T>& g, double* work) : axis(a), grid(g) {
        for (double** row : {&pushed, &leaves, &leaves_next, &through, &along.cells, &along.depth, &along_next.cells,
                             &along_next.depth, &here, &behind, &beyond, &before, &across.cells, &across.depth,
                             &across_next.cells, &across_next.depth}) {
            *row = work;
            work += grid.columns + 1;
        }
    }

    // The rows [first, end), and the faces along y behind them. False: the water is not calm.
    bool rows(size_t first, size_t end) {
        const size_t n = grid.columns;
        if (first == 0) memset(grid.next_velocity[1], 0, n * sizeof(T)), memset(leaves, 0, n * sizeof(double));
        push_across(first > 0 ? first - 1 : 0, false, beyond);
        push_across(first, false, here);
        push_across(first + 1, true, behind);
        flow_across(first, beyond, here, behind, across_next);
        if (first > 0) flow_along(first - 1, false, along_next, leaves);
        flow_along(first, true, along_next, leaves_next);
        each(0, n, [&](auto width, size_t i, auto&) { // of walls nothing, whatever leaves
            using L = Lanes<width()>;
            moved<width()>(across_next, i, L::load(leaves + i) + L::load(leaves_next + i)).store(before + i);
        });
        for (size_t row = first; row < end; ++row) {
            std::swap(along, along_next), std::swap(across, across_next), std::swap(leaves, leaves_next);
            push_across(row + 2, row + 2 <= end, beyond);
            flow_across(row + 1, here, behind, beyond, across_next);
            if (row + 1 < grid.rows) flow_along(row + 1, row + 1 < end, along_next, leaves_next);
            move_along();
            T *const u = grid.next_velocity[0] + row * grid.pitch, *const depth = grid.next_depth + row * grid.pitch;
            u[0] = u[n] = 0;
            memset(owed, 0, sizeof owed);
            each(0, n, [&](auto width, size_t i, auto& seen) { fill<width()>(i, row, seen); });
            if constexpr (sizeof(T) < sizeof(double)) depth[n - 1] = T(double(depth[n - 1]) + sum_of_chains(owed));
            if (row + 1 == grid.rows) memset(grid.next_velocity[1] + grid.rows * grid.pitch, 0, n * sizeof(T));
            if ((row % 32 == 31 || row + 1 == end) && !(calm(wide) && calm(single))) return false;
            double* const free = here;
            here = behind, behind = beyond, beyond = free;
        }
        return true;
    }
};

} // namespace

template <class T>
bool leap_water(const WaterAxis* axis, const WaterGrid<T>& grid, double* work, size_t first, size_t count) {
    return Leap<T>(axis, grid, work).rows(first, first + count);
}

#if CD_WITH_FLOAT32
template bool leap_water(const WaterAxis*, const WaterGrid<float>&, double*, size_t, size_t);
#endif
#if CD_WITH_FLOAT64
template bool leap_water(const WaterAxis*, const WaterGrid<double>&, double*, size_t, size_t);
#endif

} // namespace CD_ISA
} // namespace cd
