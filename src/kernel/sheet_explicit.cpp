// An explicit step of a uniform sheet in one pass over memory.
#include <initializer_list>

#include "kernel/plain_step.hh"
#include "kernel/sheet_rows.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Pointers to where a row starts.
struct ExplicitMove {
    Separable acting;
    StateNumbers x, v;
    double move, follow;
    Lanes<kWidest>& probe;

    template <int N, bool kInside = false> void bundle(size_t u) {
        using L = Lanes<N>;
        const L from = load_lanes<N>(v, u), change = acting.acts<N, kInside>(u);
        store_settled(from + change, v, u, probe);
        store_settled(load_lanes<N>(x, u) + move * (from + follow * change), x, u, probe);
    }
};

// A sheet on which nothing but springs and gravity acts (plain_step.hh). Springs along a line are alike, and only its
// ends are held or weigh less than the rest: `rate` is that of the springs that a node has on its line, and where one
// is missing the node itself stands for the neighbour.
struct PlainLine {
    const double *before, *after, *gain;

    PlainLine(const SeparableSheet& sheet, int direction)
        : before(sheet.before[direction]), after(sheet.after[direction]), gain(sheet.gain[direction]) {}
    double rate(size_t i) const { return after[i] > 0 ? after[i] : before[i]; }
    template <class T> bool in_range(size_t nodes) const {
        bool all = true;
        for (size_t i = 0; i < nodes; i += i == 0 && nodes > 2 ? nodes - 2 : 1)
            all = all && in_plain_range<T>(rate(i)) && (gain[i] == 0 || gain[i] == 1);
        return all;
    }
};

// dt times stiffness over mass of a node's springs along and across its row, and dt g.
template <class T> struct PlainRates {
    Rate<T> along, across;
    T gravity;
};

// A row on its way; all pointers to where it starts.
template <class T> struct PlainRow {
    T *x, *v, *pull; // pull: how far the row above lies from this one, and then this one from the row below
    const T* below;
    size_t columns;
    T dt;
    bool fetches;
    PlainProbe<T>& probe;
    size_t done = 0;
    T left = 0; // how far the next node lies from the one before it

    template <class V>
    void move(const PlainRates<T>& c, size_t u, V here, V along, V across, T* to_x, T* to_v, V& seen) const {
        move_plainly(c.along.head * along + c.across.head * across, c.along.tail * along + c.across.tail * across,
                     c.gravity, dt, here, get<V>(v + u), to_x, to_v, seen);
    }
    // A node at the end of a row, which stays where it is.
    void end(const PlainRates<T>& c, size_t u, T left, T right, T* to_x, T* to_v) const {
        T seen = 0;
        move(c, u, x[u], right - left, (below[u] - x[u]) - pull[u], to_x, to_v, seen);
        probe.add(seen);
    }
    // As many whole bundles as are left before `end`.
    template <class V> void bundles(const PlainRates<T>& c, size_t end) {
        constexpr size_t n = size_t(kCountOf<V, T>);
        V last = left - V{};
        V seen{};
        for (; done + n <= end; done += n) {
            if (n > 1 && fetches) {
                __builtin_prefetch(below + done + kAhead / sizeof(T));
                __builtin_prefetch(v + done + kAhead / sizeof(T));
            }
            const V here = get<V>(x + done), over = get<V>(pull + done), under = get<V>(below + done) - here;
            const V right = get<V>(x + done + 1) - here;
            move(c, done, here, right - before<T>(last, right), under - over, x + done, v + done, seen);
            put(under, pull + done);
            last = right;
        }
        left = last_of<T>(last);
        probe.add(seen);
    }
};

template <class T> struct PlainRows {
    const Grid& grid;
    const UniformStage& stage;
    PlainLine along, across;
    PlainTime<T> time;
    T *x, *v;
    T *pull, *beyond; // rows: see PlainRow; the old state below the last one
    size_t first, end;
    bool fetches;
    PlainProbe<T> probe{};

    PlainRows(const Grid& grid_, const UniformStage& stage_, double dt, T* x_, T* v_, double* looked, size_t first_,
              size_t count)
        : grid(grid_),
          stage(stage_),
          along(stage.sheet, 0),
          across(stage.sheet, 1),
          time(dt),
          x(x_),
          v(v_),
          pull(reinterpret_cast<T*>(looked)),
          beyond(reinterpret_cast<T*>(looked + grid.pitch)),
          first(first_),
          end(first_ + count),
          fetches(leaves_cache(grid)) {}

    static bool takes(const Grid& grid, const UniformStage& stage, const SheetMove& move) {
        return stage.constant && stage.share == 0 && move.follow == 1 && in_plain_range<T>(move.move) &&
               in_plain_range<T>(__builtin_fabs(stage.push.gravity)) &&
               PlainLine(stage.sheet, 0).in_range<T>(grid.columns) && PlainLine(stage.sheet, 1).in_range<T>(grid.rows);
    }

    void look_beyond() const {
        const size_t over = across.before[first] > 0 ? grid.above(first) : first;
        const size_t under = across.after[end - 1] > 0 ? grid.below(end - 1) : end - 1;
        for (size_t u = 0; u < grid.columns; ++u) pull[u] = x[first * grid.pitch + u] - x[over * grid.pitch + u];
        memcpy(beyond, x + under * grid.pitch, grid.columns * sizeof(T));
    }
    PlainRates<T> rates(size_t u, size_t row) const {
        const double gain = along.gain[u] * across.gain[row] * time.exact;
        return {Rate<T>(gain * along.rate(u)), Rate<T>(gain * across.rate(row)), T(gain * stage.push.gravity)};
    }
    // The ends of a row may weigh less, be held or be joined: they are found first and put down last.
    void step(size_t r) {
        const size_t z = grid.columns - 1;
        T *const at = x + r * grid.pitch, *const speed = v + r * grid.pitch;
        const T first_x = at[0], last_x = at[z];
        T new_x[2], new_v[2];
        PlainRow<T> row{at, speed, pull, r + 1 < end ? at + grid.pitch : beyond, grid.columns, time.dt, fetches, probe};
        row.end(rates(0, r), 0, along.before[0] > 0 ? first_x - last_x : 0, at[z > 0] - first_x, &new_x[0], &new_v[0]);
        row.end(rates(z, r), z, last_x - at[z - (z > 0)], along.after[z] > 0 ? first_x - last_x : 0, &new_x[1],
                &new_v[1]);
        const PlainRates<T> inside = rates(z > 1, r);
        const size_t aligned = size_t(-uintptr_t(at)) % sizeof(Wide<T>) / sizeof(T); // the first node that is
        for (const size_t end : {aligned < z ? aligned : z, z + 1}) {
            if (end > z) row.template bundles<Wide<T>>(inside, end);
            if (sizeof(Wide<T>) > sizeof(Narrow<T>)) row.template bundles<Narrow<T>>(inside, end);
        }
        row.template bundles<T>(inside, z + 1);
        at[0] = new_x[0], speed[0] = new_v[0];
        at[z] = new_x[1], speed[z] = new_v[1];
    }
};

} // namespace

// f of the rows, if they are ones that take plain steps; whether they are.
template <class F> static bool as_plain_rows(const Grid& grid, const UniformStage& stage, const SheetMove& move,
                                             const StateNumbers& x, const StateNumbers& v, double* looked, size_t first,
                                             size_t count, F f) {
    return x.stored_state([&](auto* position) {
        using T = std::remove_pointer_t<decltype(position)>;
        if (!PlainRows<T>::takes(grid, stage, move)) return false;
        f(PlainRows<T>(grid, stage, move.move, position, static_cast<T*>(v.data), looked, first, count));
        return true;
    });
}

void look_beyond(const Grid& grid, const UniformStage& stage, const SheetMove& move, const StateNumbers& x,
                 const StateNumbers& v, double* looked, size_t first, size_t count) {
    const auto look = [](const auto& rows) { rows.look_beyond(); };
    if (!as_plain_rows(grid, stage, move, x, v, looked, first, count, look))
        StageRows{grid, stage, x, v, looked, first, first + count}.look_beyond();
}

bool step_rows(const Grid& grid, const UniformStage& stage, const SheetMove& move, const StateNumbers& x,
               const StateNumbers& v, double* looked, size_t first, size_t count) {
    bool finite = true;
    const auto step_plainly = [&](auto rows) {
        for (size_t r = first; r < rows.end; ++r) rows.step(r);
        finite = rows.probe.finite();
    };
    if (as_plain_rows(grid, stage, move, x, v, looked, first, count, step_plainly)) return finite;
    const StageRows rows{grid, stage, x, v, looked, first, first + count};
    Lanes<kWidest> probe{};
    rows.look(first, rows.at(first));
    for (size_t r = first; r < rows.end; ++r) {
        if (r + 1 < rows.end) rows.look(r + 1, rows.at(r + 1));
        const size_t row = r * grid.pitch;
        ExplicitMove step{rows.acting(r, rows.pushes()), x.from(row), v.from(row), move.move, move.follow, probe};
        along_springs(grid.columns, step);
    }
    return !probe.any_nan();
}

} // namespace CD_ISA
} // namespace cd
