// Both axes of a water at once, for explicit and for coupled steps: what a sweep does (water_line.hh), taken apart into
// what comes before the surface is known and what comes after, with planes of numbers in between.
#include "kernel/water_panels.hh"

namespace cd {
namespace CD_ISA {

namespace {

// Faces, and what they will move if the surface stays as it is.
template <class T> struct Guess : WaterBundles<T> {
    const WaterPlanes& planes;

    template <int N> bool bundle(size_t first) const {
        const size_t faces = this->axis.cells + 1;
        const Place p = this->template place_of<N>(first);
        size_t used;
        WaterLine<N> line = this->template open_line<N>(p, used);
        this->template fetch_state<N>(p, line, used);
        line.guess_all();
        put<N>(p, faces, line.velocity, planes.velocity);
        put<N>(p, faces, line.face, planes.face);
        put<N>(p, faces, line.guess, planes.guess);
        put<N>(p, faces, line.transfer, planes.transfer);
        if (planes.gain) put<N>(p, faces, line.gain, planes.gain);
        if (planes.spring) put<N>(p, faces, line.spring, planes.spring);
        return true;
    }
};

// The faces' velocities and what they move, after the surface has changed by planes.change.
template <class T> struct Finish : WaterBundles<T> {
    const WaterPlanes& planes;

    template <int N> bool bundle(size_t first) const {
        const size_t n = this->axis.cells;
        const Place p = this->template place_of<N>(first);
        size_t used;
        WaterLine<N> line = this->template open_line<N>(p, used);
        line.thins = Lanes<N>::splat(this->axis.thins ? 1 : 0);
        fetch<N>(p, n + 1, planes.velocity, line.velocity);
        fetch<N>(p, n + 1, planes.face, line.face);
        fetch<N>(p, n + 1, planes.guess, line.guess);
        fetch<N>(p, n + 1, planes.transfer, line.transfer);
        fetch<N>(p, n + 1, planes.gain, line.gain);
        fetch<N>(p, n, planes.change, line.x);
        fetch<N>(p, n, this->lines.bed, line.bed);
        line.move_faces();
        put<N>(p, n + 1, line.guess, planes.guess);
        put<N>(p, n + 1, line.transfer, planes.transfer);
        return true;
    }
};

// What faces keep of their velocities, after depths have changed; in two parts where momentum is carried between them.
template <class T, bool carried> struct Keep : WaterBundles<T> {
    const WaterPlanes& planes;

    template <int N> bool bundle(size_t first) const {
        const WaterLines<T>& lines = this->lines;
        const size_t n = this->axis.cells;
        const Place p = this->template place_of<N>(first);
        size_t used;
        WaterLine<N> line = this->template open_line<N>(p, used);
        line.thins = Lanes<N>::splat(this->axis.thins ? 1 : 0);
        fetch<N>(p, n + 1, planes.velocity, line.velocity);
        fetch<N>(p, n + 1, planes.face, line.face);
        fetch<N>(p, n + 1, planes.guess, line.guess);
        fetch<N>(p, n + 1, planes.transfer, line.transfer);
        fetch<N>(p, n, planes.held, line.depth);
        fetch<N>(p, n, lines.bed, line.bed);
        fetch<N>(p, n, lines.depth, line.after);
        if (carried) {
            line.settle_faces();
        } else if (this->axis.carried_at_once()) {
            line.hold_back();
            this->template put_tally<N>(p, line);
            put<N>(p, n + 1, line.guess, planes.guess);
            return true;
        } else {
            line.keep_all();
        }
        Lanes<N> probe{};
        settle<N, T>(n + 1, line.velocity, probe);
        put<N>(p, n + 1, line.velocity, lines.velocity);
        if (!carried) this->template put_tally<N>(p, line);
        return !probe.any_nan();
    }
};

} // namespace

template <class T> void guess_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                    double* work, size_t first, size_t count) {
    in_bundles(Guess<T>{{axis, lines, work}, planes}, lines.lines, first, count);
}
template <class T> void finish_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                     double* work, size_t first, size_t count) {
    in_bundles(Finish<T>{{axis, lines, work}, planes}, lines.lines, first, count);
}
template <class T> bool keep_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                   double* work, size_t first, size_t count) {
    return in_bundles(Keep<T, false>{{axis, lines, work}, planes}, lines.lines, first, count);
}
template <class T> bool settle_water(const WaterAxis& axis, const WaterLines<T>& lines, const WaterPlanes& planes,
                                     double* work, size_t first, size_t count) {
    return in_bundles(Keep<T, true>{{axis, lines, work}, planes}, lines.lines, first, count);
}

// ---- cells, row by row ----------------------------------------------------------------------------------------------

void gather_loads(const WaterCells& w, double* load, size_t first, size_t count) {
    for (size_t j = first; j < first + count; ++j) {
        const double *const x = w.transfer[0] + j * w.pitch, *const y = w.transfer[1] + j * w.pitch;
        for (size_t i = 0; i < w.columns; ++i) load[j * w.pitch + i] = (x[i] - x[i + 1]) + (y[i] - y[i + w.pitch]);
    }
}

template <class T>
void share_water(const WaterCells& w, const T* depth, double* share, double* tally, size_t first, size_t count) {
    const auto out_of = [](double before, double behind) {
        return (before < 0 ? -before : 0) + (behind > 0 ? behind : 0);
    };
    for (size_t j = first; j < first + count; ++j) {
        const double *const x = w.transfer[0] + j * w.pitch, *const y = w.transfer[1] + j * w.pitch;
        double cells = 0, held_back = 0;
        for (size_t i = 0; i < w.columns; ++i) {
            const double d = double(depth[j * w.pitch + i]);
            const double out = out_of(x[i], x[i + 1]) + out_of(y[i], y[i + w.pitch]);
            const bool over = out > d;
            // Four rounded parts of what is there must not come to more.
            share[j * w.pitch + i] = over ? (1 - 0x1p-50) * (d / out) : 1;
            if (over && out - d > 0x1p-40 * out) cells += 1, held_back += out - d;
        }
        tally[j * kTallies + kLimited] = cells;
        tally[j * kTallies + kHeldBack] = held_back;
    }
}

void limit_water(const WaterCells& w, const double* share, size_t first, size_t count) {
    for (size_t j = first; j < first + count; ++j) {
        double *const x = w.transfer[0] + j * w.pitch, *const y = w.transfer[1] + j * w.pitch;
        const double* const here = share + j * w.pitch;
        for (size_t i = 0; i <= w.columns && j < w.rows; ++i) {
            const bool forward = x[i] > 0;
            if (i == 0 && forward) x[i] *= w.ring[0] ? here[w.columns - 1] : 1;
            else if (i == w.columns && !forward) x[i] *= w.ring[0] ? here[0] : 1;
            else x[i] *= forward ? here[i - 1] : here[i];
        }
        for (size_t i = 0; i < w.columns; ++i) {
            const bool forward = y[i] > 0;
            if (j == 0 && forward) y[i] *= w.ring[1] ? share[(w.rows - 1) * w.pitch + i] : 1;
            else if (j == w.rows && !forward) y[i] *= w.ring[1] ? share[i] : 1;
            else y[i] *= forward ? here[i - w.pitch] : here[i];
        }
    }
}

template <class T> void balance_water(const WaterBeside<T>& b, size_t first, size_t count) {
    const WaterCells& w = b.cells;
    for (int axis = 0; axis < 2; ++axis) {
        const WaterPlanes& planes = b.planes[axis];
        const size_t step = axis == 0 ? 1 : w.pitch;
        const auto moved = [&](size_t at) {
            return b.late ? planes.transfer[at] : (b.courant[axis] * planes.velocity[at]) * planes.face[at];
        };
        for (size_t j = first; j < first + count; ++j)
            for (size_t at = j * w.pitch; at < j * w.pitch + w.columns; ++at)
                b.leaves[axis][at] = moved(at + step) - moved(at);
    }
}

// At most half of a face goes, and it at most doubles. Not where a face is closed, nor where the surface on one side
// lies below the bed of the other.
template <class T> void look_beside(const WaterBeside<T>& b, size_t first, size_t count) {
    const WaterCells& w = b.cells;
    for (int axis = 0; axis < 2; ++axis) {
        const WaterPlanes& planes = b.planes[axis];
        const double *const leaves = b.leaves[1 - axis], courant = b.courant[axis];
        const auto look = [&](size_t at, size_t l, size_t r) {
            const double d_l = double(b.depth[l]), d_r = double(b.depth[r]), up = double(b.bed[r]) - double(b.bed[l]);
            double &h = planes.face[at], &transfer = planes.transfer[at], gone = 0.25 * (leaves[l] + leaves[r]);
            if (!(h > 0 && d_l > 0 && d_r > 0 && d_r + up > 0 && d_l - up > 0)) return;
            gone = gone > 0.5 * h ? 0.5 * h : gone < -h ? -h : gone;
            const double is = h - gone;
            if (!b.late) transfer *= is / h;
            else if (transfer != 0) transfer = (courant * planes.guess[at]) * is;
            if (planes.spring) planes.spring[at] *= is / h;
            h = is;
        };
        const size_t step = axis == 0 ? 1 : w.pitch, round = (w.rows - 1) * w.pitch; // from the first row to the last
        for (size_t j = first; j < first + count; ++j) {
            const size_t begin = j * w.pitch, end = begin + w.columns;
            if (axis == 0 || j > 0)
                for (size_t at = begin + (axis == 0); at < end; ++at) look(at, at - step, at);
            if (!w.ring[axis] || (axis == 1 && j > 0)) continue;
            // The first faces are the last ones, too.
            for (size_t at = begin; at < (axis == 0 ? begin + 1 : end); ++at) {
                const size_t before = axis == 0 ? end - 1 : at + round;
                look(at, before, at);
                for (double* plane : {planes.face, planes.transfer, planes.spring})
                    if (plane) plane[before + step] = plane[at];
            }
        }
    }
}

// Rounded once or twice only, whatever cancels (Knuth's sum of two, exact with what it loses).
static double exact_sum(std::initializer_list<double> terms) {
    double total = 0, lost = 0;
    for (double term : terms) {
        const double next = total + term, added = next - total;
        lost += (total - (next - added)) + (term - added);
        total = next;
    }
    return total + lost;
}

// What rounding takes from a cell another one of its row gets, kRowChains further; what is left of all the chains, the
// last, or the last that can take it where cells pass on what they get, and what none of them can take is kept in
// owed_by. Every row has its own, so that it does not matter which rows lie beside it.
template <class T>
bool fill_water(const WaterCells& w, T* depth, double* held, double* owed_by, size_t first, size_t count) {
    double probe = 0; // NaN once a depth is too large
    const auto split = [](double a, double& in, double& out) { (a > 0 ? in : out) += a > 0 ? a : -a; };
    const auto put = [&](T& d, double now, double& owed) {
        d = stored_depth<T>(now, owed);
        probe += 0.0 * double(d);
    };
    for (size_t j = first; j < first + count; ++j) {
        const double *const x = w.transfer[0] + j * w.pitch, *const y = w.transfer[1] + j * w.pitch;
        T* const row = depth + j * w.pitch;
        double owed[kRowChains] = {};
        for (size_t i = 0; i < w.columns; ++i) {
            double in = 0, out = 0;
            split(x[i], in, out), split(-x[i + 1], in, out), split(y[i], in, out), split(-y[i + w.pitch], in, out);
            const double was = double(row[i]);
            double now = (was + in) - out, &own = owed[i % kRowChains];
            if (w.passes) {
                now = exact_sum({was, x[i], -x[i + 1], y[i], -y[i + w.pitch]});
                if (now <= 0x1p-48 * (was + in)) own += now, now = 0; // all but rounding has been passed on
            }
            if (held) held[j * w.pitch + i] = was;
            put(row[i], now, own);
        }
        double rest = sum_of_chains(owed);
        bool taken = false;
        for (size_t i = w.columns; i-- > 0 && rest != 0 && !taken && (w.passes || i + 1 == w.columns);) {
            taken = can_take(double(row[i]), rest);
            if (taken) put(row[i], double(row[i]), rest);
        }
        owed_by[j] = taken ? 0 : rest;
    }
    return probe == probe;
}

#define CD_INSTANTIATE(T)                                                                                            \
    template void guess_water(const WaterAxis&, const WaterLines<T>&, const WaterPlanes&, double*, size_t, size_t);  \
    template void finish_water(const WaterAxis&, const WaterLines<T>&, const WaterPlanes&, double*, size_t, size_t); \
    template bool keep_water(const WaterAxis&, const WaterLines<T>&, const WaterPlanes&, double*, size_t, size_t);   \
    template bool settle_water(const WaterAxis&, const WaterLines<T>&, const WaterPlanes&, double*, size_t, size_t); \
    template void balance_water(const WaterBeside<T>&, size_t, size_t);                                              \
    template void look_beside(const WaterBeside<T>&, size_t, size_t);                                                \
    template void share_water(const WaterCells&, const T*, double*, double*, size_t, size_t);                        \
    template bool fill_water(const WaterCells&, T*, double*, double*, size_t, size_t);
#if CD_WITH_FLOAT32
CD_INSTANTIATE(float)
#endif
#if CD_WITH_FLOAT64
CD_INSTANTIATE(double)
#endif

} // namespace CD_ISA
} // namespace cd
