// Steps of cloth: springs of a length that only pull. (model.md, 42 to 48)
//
// With h = lambda dt and x1 = x0 + dt w a step minimizes over the velocities w the convex function
//
//      Phi(w) = 1/2 |w - b|_M^2 + lambda psi(x1) + ...,      b = v0 + h (g + f / m),      v1 = v0 + (w - v0) / lambda
//
// by Newton's method, from where the last step went. psi is the energy of springs, bend, ties; contacts, friction and
// air add what resists motion. The energy 1/2 c (|D| - L)^2 of a spring against crumpling is not convex; its part -c
// L |D| acts by a force along the direction that the spring is expected to have at x1, which is part of b and follows
// the first iterations. By convexity
//
//      E1 - E0 <= w . grad Phi(w) / lambda - (lambda - 1/2) |v1 - v0|_M^2 + U(w)
//
// for any w, however far from the minimum, U what such springs gain as they turn otherwise than expected. So a step
// ends by scaling w until w . grad Phi(w) and that with lambda U(w) are not positive, and then no energy has come
// from nothing, whatever dt, stiffness, masses and the number of iterations.
#include <math.h>

#include "model/membrane_cloth.hh"
#include "model/membrane_work.hh"

namespace cd {

namespace {

// Conjugate gradients are content with this part of what is to be found, recycled directions counted. Where their number
// is not given they also end once the last `kLastOnes` of them have brought less than `kLittle` of the energy that all have
// brought: what they bring bounds what was left before them (Hestenes and Stiefel 1952, Strakos and Tichy 2002).
constexpr double kContent = 1e-3, kLittle = 0.03;
constexpr uint64_t kLastOnes = 4;
// Newton's method goes on, at most so many times more, where it could take less than this part of a direction; and where
// the number of conjugate gradients is not given, after an iteration that brought more than `kMuch` of what all have;
// of cloth stiffer than kStiffCloth also one that brought more energy than what all added to the velocities moves with:
// there the first one brings much more, as it ends the stretch to which the old velocities lead.
constexpr double kWholeStep = 0.9, kMuch = 0.02;
constexpr uint64_t kMoreIterations = 4;
// So many of Newton's iterations expect springs to go on by the velocities found so far. From there on Phi stays as it
// is, so that what is left of its gradient goes to nothing.
constexpr uint64_t kExpectations = 3;
// A search along a direction, and the last scaling, evaluate the slope at most so often; a search ends where the slope is
// this part of the first one.
constexpr int kMostSearches = 8;
constexpr double kFlat = 0.1;
// Curvatures look ahead by kAhead of the soft part of a spring's law, so that what is nearly taut counts; but of cloth
// stiffer than kStiffCloth mass / dt^2 by less in proportion, though not below kNearest of that. It stretches by little of
// that part, and would seem so much stiffer, if they looked further, that Newton's method comes but slowly nearer.
constexpr double kAhead = 0.5, kStiffCloth = 20, kNearest = 0.1;

struct ClothStep {
    Membrane& m;
    ClothWork& w;
    double dt, h;
    size_t contacts = 0, iterations = 0;
    double ahead = 0;      // see ClothResidual
    double left = 0;       // of the gradient that the step starts from
    bool touched = false;  // whether an iteration met a collider
    bool recycles[2] = {}; // whether there is such a direction

    const SheetKernels& sheet() const { return m.kernels->sheet; }
    const ClothKernels& cloth() const { return m.kernels->cloth; }
    bool as_needed() const { return m.cloth.gradient == 0; }

    // Functions that are not inlined would be copied to where each is called: 5 kB.
    // body(first, count, scratch rows) for parts of the rows
    template <class Body> void rows(const Body& body) const {
        w.parts.each(m.parallel, [&](size_t part, size_t first, size_t count) {
            body(first, count, w.rows + part * kClothRows * w.grid.pitch);
        });
    }
    template <class Body> void columns(const Body& body) const {
        w.strips.each(m.parallel, [&](size_t, size_t first, size_t count) { body(first, count); });
    }

    void wrap(double* const* planes, int count = 3) const {
        if (!m.ring[kU]) return;
        rows([&](size_t first, size_t number, double*) {
            for (int k = 0; k < count; ++k) sheet().wrap(w.grid, planes[k], first, number);
        });
    }
    [[gnu::noinline]] double sum_of(const double* a, const double* b) const {
        double sum = 0;
        rows([&](size_t first, size_t count, double*) { sheet().dot(w.grid, a, b, w.sums, first, count); });
        for (size_t r = 0; r < w.grid.rows; ++r) sum += w.sums[r];
        return sum;
    }
    double dot(double* const* a, double* const* b) const {
        return (sum_of(a[0], b[0]) + sum_of(a[1], b[1])) + sum_of(a[2], b[2]);
    }
    [[gnu::noinline]] void copy(double* const* from, double* const* to) const {
        rows([&](size_t first, size_t count, double*) {
            for (int k = 0; k < 3; ++k)
                memcpy(to[k] + first * w.grid.pitch, from[k] + first * w.grid.pitch,
                       count * w.grid.pitch * sizeof(double));
        });
    }
    // out = alpha a + beta b
    [[gnu::noinline]] void combine(double alpha, double* const* a, double beta, double* const* b,
                                   double* const* out) const {
        rows([&](size_t first, size_t count, double*) {
            for (int k = 0; k < 3; ++k) sheet().combine(w.grid, alpha, a[k], beta, b[k], out[k], first, count);
        });
    }
    // a += beta b
    void add(double beta, double* const* b, double* const* a) const { combine(1, a, beta, b, a); }

    // The residual -grad Phi at these velocities; with `curves` the curvatures of the matrix too, and its ground.
    void find_residual(double* const* velocity, bool curves) const {
        combine(dt, velocity, 1, w.from, w.to);
        wrap(w.to);
        wrap(velocity);
        const ClothMatrix matrix = w.matrix(w.own);
        const ClothResidual with{h, dt, ahead, {w.rhs[0], w.rhs[1], w.rhs[2]}, {velocity[0], velocity[1], velocity[2]}};
        rows([&](size_t first, size_t count, double* scratch) {
            cloth().residual(w.grid, w.springs(), matrix, with, w.to, w.residual, curves, scratch, first, count);
            if (w.has_bend()) cloth().bend(w.grid, matrix, -1 / dt, w.to, w.residual, scratch, first, count);
        });
        if (curves && CD_WITH_CONTACT) take_pushes(w, contacts, dt, velocity, w.residual);
        if (curves && w.ground[0] != w.own[0])
            for (int k = 0; k < 6; ++k)
                memcpy(w.ground[k] - kBefore, w.own[k] - kBefore,
                       (w.grid.pitch * w.grid.rows + 2 * kBefore) * sizeof(double));
        if (CD_WITH_CONTACT)
            add_contacts(w, contacts, dt, velocity, w.residual, curves && contacts > 0 ? w.ground : nullptr);
    }

    // Leaves the residual of w without contacts: what their impulses make up for.
    [[gnu::cold]] void find_pushes() {
        const size_t all = contacts;
        contacts = 0;
        find_residual(w.w, false);
        contacts = all;
    }

    // image = matrix p
    void apply(double* const* p) const {
        wrap(p);
        const ClothMatrix matrix = w.matrix(w.ground);
        rows([&](size_t first, size_t count, double* scratch) {
            cloth().apply(w.grid, matrix, p, w.image, scratch, first, count);
            if (w.has_bend()) cloth().bend(w.grid, matrix, 1, p, w.image, scratch, first, count);
        });
    }

    [[gnu::noinline]] void turn(double* from, double* to) const {
        rows([&](size_t first, size_t count, double*) {
            sheet().transpose(w.grid, from, to, w.turned.pitch, first, count);
        });
    }

    // Factors all lines, along u in the turned layout.
    void factor() const {
        for (const auto& planes : w.curvature) wrap(planes, 4);
        const ClothMatrix matrix = w.matrix(w.ground);
        rows([&](size_t first, size_t count, double*) { cloth().blocks(w.grid, matrix, w.block, first, count); });
        for (int k = 0; k < 6; ++k) turn(w.block[k], w.turned_block[k]);
        for (int k = 0; k < 4; ++k) turn(w.curvature[kAlongU][k], w.turned_curvature[k]);
        columns([&](size_t first, size_t count) {
            cloth().factor(w.grid, matrix.spring[kAlongV], w.moves, w.block, first, count);
        });
        rows([&](size_t first, size_t count, double*) {
            cloth().factor(w.turned, along_u(), w.turned_moves, w.turned_block, first, count);
        });
    }
    ClothCurvature along_u() const {
        return {{w.turned_curvature[0], w.turned_curvature[1], w.turned_curvature[2], w.turned_curvature[3]}};
    }

    // answer = (lines along v)^-1 error + (lines along u)^-1 error + p (p . error) of what is recycled
    void precondition() const {
        for (int k = 0; k < 3; ++k) turn(w.error[k], w.turned_z[k]);
        const ClothCurvature along_v = w.matrix(w.ground).spring[kAlongV];
        columns([&](size_t first, size_t count) {
            cloth().solve(w.grid, along_v, w.block, w.error, w.answer, first, count);
        });
        rows([&](size_t first, size_t count, double*) {
            cloth().solve(w.turned, along_u(), w.turned_block, w.turned_z, w.turned_z, first, count);
        });
        columns([&](size_t first, size_t count) {
            for (int k = 0; k < 3; ++k)
                sheet().transpose(w.turned, w.turned_z[k], w.image[k], w.grid.pitch, first, count);
        });
        add(1, w.image, w.answer);
        for (int i = 0; i < 2; ++i)
            if (recycles[i]) add(dot(w.error, w.recycled[i]), w.recycled[i], w.answer);
    }

    // Makes a direction p, scaled to p . matrix p = 1, known to the preconditioner, and starts from the best multiple of
    // it. Tells what that is of r . matrix^-1 r, r the residual.
    [[gnu::noinline]] double recycle(int i) {
        double* const* const p = w.recycled[i];
        apply(p);
        const double scale = 1 / sqrt(dot(p, w.image));
        recycles[i] = scale > 0 && isfinite(scale);
        if (!recycles[i]) return 0;
        combine(0, p, scale, p, p);
        const double share = dot(w.residual, p);
        add(share, p, w.direction);
        add(-share * scale, w.image, w.error);
        return share * share;
    }
    // What moves goes on: what the last step changed is the first such direction.
    void load_change() const {
        const StateNumbers change = state_of(m, m.change);
        each_number([&](size_t k, size_t at, size_t i) { w.recycled[0][k][at] = w.moves[at] * change[i]; });
    }

    // direction = matrix^-1 residual, nearly. False where nothing could be found.
    [[gnu::noinline]] bool solve(bool first) {
        factor();
        copy(w.residual, w.error);
        if (first) load_change();
        else copy(w.direction, w.recycled[1]); // of the last iteration
        for (double* plane : w.direction) memset(plane, 0, w.grid.pitch * w.grid.rows * sizeof(double));
        const double known = recycle(first ? 0 : 1);
        bool found = known > 0;
        precondition();
        copy(w.answer, w.conjugate);
        double size = dot(w.error, w.answer);
        const double content = kContent * kContent * (known + size);
        const uint64_t most = as_needed() ? kMostGradient : m.cloth.gradient;
        double brought = known, last[kLastOnes] = {}; // twice the energy
        for (uint64_t i = 0; i < most && size > content; ++i) {
            apply(w.conjugate);
            const double energy = dot(w.conjugate, w.image);
            if (!(energy > 0)) break;
            const double share = size / energy;
            if (!(share <= HUGE_VAL)) break;
            ++iterations;
            found = true;
            add(share, w.conjugate, w.direction);
            last[i % kLastOnes] = share * size;
            brought += share * size;
            double lately = 0;
            for (double one : last) lately += one;
            if (i + 1 == most || (as_needed() && i + 1 >= kLastOnes && lately < kLittle * brought)) break;
            add(-share, w.image, w.error);
            precondition();
            const double next = dot(w.error, w.answer);
            combine(next / size, w.conjugate, 1, w.answer, w.conjugate);
            size = next;
        }
        return found;
    }

    // The slope of Phi along `way` at from + share way.
    [[gnu::noinline]] double slope(double* const* from, double share, double* const* way) const {
        combine(1, from, share, way, w.trial);
        find_residual(w.trial, false);
        return -dot(w.residual, way);
    }

    // A share of a way in [least, most] at which `rise`, the rise of energy there over the share, is not positive, if
    // it is negative at `least` and positive at `most`.
    template <class Rise>
    double share_of(const Rise& rise, double least, double falls, double most, double rises) const {
        if (!isfinite(rises)) return least;
        const double flat = kFlat * falls;
        for (int i = 0; i < kMostSearches && falls < flat; ++i) { // secants; a side that stays counts for half
            const double middle = least + (most - least) * (falls / (falls - rises));
            if (!(middle < most)) return most; // where it rises by rounding only
            if (!(middle > least)) break;
            const double now = rise(middle);
            if (now <= 0) least = middle, falls = now, rises *= 0.5;
            else if (now > 0) most = middle, rises = now, falls *= 0.5;
            else break;
        }
        return least;
    }

    // way . ground way, the ground without contacts; spends the image.
    [[gnu::noinline]] double resisted(double* const* way) const {
        for (int k = 0; k < 3; ++k) w.each_place([&](size_t at) { w.image[k][at] = w.inertia[at] * way[k][at]; });
        return dot(way, w.image);
    }

    // How much of the direction to go. Where the slope at its end has nearly gone, one secant tells: among slopes that are
    // rounding more of them find none that falls, and the step stays where it is.
    double search(double falls) const {
        const auto rise = [&](double share) { return slope(w.w, share, w.direction); };
        const double end = rise(1);
        if (end <= 0) return 1;
        return end <= -kFlat * falls ? falls / (falls - end) : share_of(rise, 0, falls, 1, end);
    }

    void newton() {
        uint64_t most = m.cloth.newton;
        double start = 0, brought = 0, moving = 0; // moving: twice the energy
        touched = recycles[0] = recycles[1] = false;
        for (uint64_t i = 0;; ++i) {
            touched |= CD_WITH_CONTACT && touches(w, contacts, dt);
            if (i < kExpectations && m.cloth.compression > 0) unfold();
            find_residual(w.w, true);
            const double size = dot(w.residual, w.residual);
            if (i == 0) start = size;
            left = size == 0 ? 0 : sqrt(size / start);
            if (i == most || !(size > 0) || !solve(i == 0)) break;
            const double falls = -dot(w.residual, w.direction);
            if (!(falls < 0)) break;
            const double share = search(falls), brings = -share * falls;
            add(share, w.direction, w.w);
            brought += brings;
            if (ahead < kAhead) moving += share * share * resisted(w.direction);
            const bool much = brings > kMuch * brought || (moving > 0 && brings > 0.5 * moving);
            const bool more = share < kWholeStep || (as_needed() && much);
            if (more && i + 1 == most && most < m.cloth.newton + kMoreIterations) ++most;
        }
    }

    // The energy that springs against crumpling gain beyond what Phi knows of if the velocities `trial` move them.
    [[gnu::noinline]] double gain() const {
        rows([&](size_t first, size_t count, double*) {
            cloth().gains(w.grid, w.springs(), dt, w.from, w.expected, w.trial, w.conjugate, first, count);
        });
        return sum_of(w.compression[kU], w.conjugate[0]) + sum_of(w.compression[kV], w.conjugate[1]);
    }

    // Scales what w has beside the velocities of whole parts, or all that free ones have, so that Phi does not rise
    // along it, and no energy comes of springs that turn otherwise than expected. Those velocities, which may be as
    // good as nothing beside the rest, are what all of it is added to.
    void scale(bool free) const {
        double* const* const way = w.direction;
        for (int k = 0; k < 3; ++k)
            w.each_place([&](size_t at) {
                const double mean = free || w.bound[w.part[at]] > 0 ? w.error[k][w.part[at]] : 0;
                way[k][at] = w.moves[at] * (w.w[k][at] - mean);
                if (w.moves[at] > 0) w.w[k][at] = mean;
            });
        const auto rise = [&](double share) {
            const double falls = slope(w.w, share, way);
            const double gained = m.cloth.compression > 0 ? m.lambda * gain() : 0;
            return gained > 0 ? falls + gained / share : falls;
        };
        double share = 1, most = 1, end = rise(1);
        if (!(end <= 0)) {
            // Phi's second derivative along `way` is at least that of the ground.
            double least = fmax(0, 1 - end / resisted(way)), falls = least < 1 ? rise(least) : 0;
            if (falls > 0 && least > 0) most = least, end = falls, least = 0, falls = rise(0);
            share = falls < 0 ? share_of(rise, least, falls, most, end) : least;
        }
        add(share, way, w.w);
    }

    // A part of the sheet that nothing holds and that touches nothing keeps its momentum, however little of its step
    // was found, also in air. Should it touch something after all, or air be so thick that rounding counts, the last
    // scaling sees to it. Any other goes along with what holds or pushes it, as if that stood still.
    void bound() const {
        const bool free = share_momentum(w, contacts);
        scale(true);
        if (!free || !w.has_blocks()) return;
        if (CD_WITH_CONTACT && touches(w, contacts, dt)) {
            share_momentum(w, contacts);
            scale(true);
        }
        scale(false);
    }

    // The right side with what springs against crumpling push by where the velocities w lead.
    void unfold() const {
        double *const *const along_u = w.conjugate, *const *const along_v = w.error;
        copy(w.given, w.rhs);
        // What leads a node out of a collider is its own, and not what its neighbours expect.
        const bool out = CD_WITH_CONTACT && find_ways_out(w, contacts, dt);
        double* const* const going = out ? w.trial : w.w;
        wrap(going);
        rows([&](size_t first, size_t count, double*) {
            cloth().smooth(w.grid, w.springs(), going, w.expected, first, count);
        });
        if (out) add(1, w.image, w.expected);
        wrap(w.expected);
        rows([&](size_t first, size_t count, double*) {
            cloth().unfold(w.grid, w.springs(), h, dt, w.from, w.expected, along_u, along_v, first, count);
        });
        wrap(along_u);
        rows([&](size_t first, size_t count, double*) {
            const auto add = [&](double sign, const double* push, double* to, size_t row, size_t many) {
                sheet().combine(w.grid, 1, to, sign, push, to, row, many);
            };
            for (int k = 0; k < 3; ++k) {
                add(1, along_u[k], w.rhs[k], first, count);
                add(-1, along_u[k] - 1, w.rhs[k], first, count);
                add(1, along_v[k], w.rhs[k], first, count);
                for (size_t row = first; row < first + count; ++row) {
                    const ptrdiff_t above = ptrdiff_t(w.grid.above(row)) - ptrdiff_t(row);
                    add(-1, along_v[k] + above * ptrdiff_t(w.grid.pitch), w.rhs[k], row, 1);
                }
            }
        });
    }

    void look_ahead() {
        double mass = 0, stiffest[2] = {};
        w.each_place([&](size_t at) {
            mass += w.mass[at];
            for (Direction d : {kU, kV}) stiffest[d] = fmax(stiffest[d], w.stiffness[d][at]);
        });
        const double most = fmax(stiffest[kU] / per_spring(m, kU, 1), stiffest[kV] / per_spring(m, kV, 1));
        ahead = kAhead * fmax(kNearest, fmin(1, kStiffCloth * mass / (dt * dt * most)));
    }

    // Positions, velocities, what a node would do by itself, and what resists it.
    void start(double now) {
        const StateNumbers x = state_of(m, m.position), v0 = state_of(m, m.velocity);
        each_number([&](size_t k, size_t at, size_t i) { w.from[k][at] = x[i], w.w[k][at] = v0[i]; });
        if (m.pressure != 0) press(m);
        look_ahead();
        for (size_t v = 0; v < m.rows; ++v)
            for (size_t u = 0; u < m.columns; ++u) {
                const size_t at = w.place(u, v);
                const double tie = tie_of(m, u, v), mass = w.mass[at], moves = w.moves[at];
                if (!(moves > 0)) w.bound[w.part[at]] = 1;
                w.inertia[at] =
                    moves * (mass * (1 + h * m.drag) + h * (tie_damping_of(m, node_at(m, u, v)) + dt * tie));
                for (size_t k = 0; k < 3; ++k) {
                    const size_t from = place(m, u, v, k);
                    double force = mass * m.gravity[k];
                    if (m.force) force += get_number(m, m.force, from);
                    if (m.pressed) force += m.pressed[from];
                    if (m.target) force += tie * (get_number(m, m.target, from) - w.from[k][at]);
                    w.rhs[k][at] = mass * w.w[k][at] + h * force;
                }
            }
        wrap(w.from);
        if (w.has_blocks()) {
            for (int k = 0; k < 6; ++k) w.each_place([&](size_t at) { w.own[k][at] = k < 3 ? w.inertia[at] : 0; });
            if (m.cloth.along > 0 || m.cloth.across > 0) add_air(m, w, h);
            if (CD_WITH_CONTACT) contacts = find_contacts(m, w, now, dt);
        }
        copy(w.rhs, w.given);
    }
    // f(component, place in the planes, place in an array of the state)
    template <class F> void each_number(F f) const {
        for (size_t k = 0; k < 3; ++k)
            for (size_t v = 0; v < m.rows; ++v)
                for (size_t u = 0; u < m.columns; ++u) f(k, w.place(u, v), place(m, u, v, k));
    }

    // False if a number left the finite range.
    bool finish() const {
        const StateNumbers x = state_of(m, m.position), v = state_of(m, m.velocity), change = state_of(m, m.change);
        const double least = x.range().least;
        bool finite = true;
        const auto put = [&](double value, const StateNumbers& to, size_t i) {
            to.put(i, fabs(value) < least ? 0 : value);
            return isfinite(to[i]) != 0;
        };
        each_number([&](size_t k, size_t at, size_t i) {
            w.trial[k][at] = v[i];
            // What a collider gave does not go on.
            if (touched || !put(w.w[k][at] - w.trial[k][at], change, i)) change.put(i, 0);
        });
        const double share = 1 / m.lambda; // v1 = v0 + (w - v0) / lambda
        if (share != 1) combine(1 - share, w.trial, share, w.w, w.trial);
        else copy(w.w, w.trial);
        if (CD_WITH_CONTACT) settle_contacts(w, contacts, dt, m.lambda, w.trial);
        add(dt, w.w, w.from);
        if (CD_WITH_CONTACT && m.loads) tell_loads(m, w, contacts, dt);
        each_number([&](size_t k, size_t at, size_t i) {
            finite &= put(w.from[k][at], x, i);
            finite &= put(w.trial[k][at], v, i);
        });
        return finite;
    }

    bool step(double now) {
        iterations = 0;
        start(now);
        newton();
        bound();
        if (CD_WITH_CONTACT && m.loads) find_pushes();
        return finish();
    }
};

} // namespace

MembraneOutcome step_cloth(Membrane& m, double dt, size_t count) {
    Carver coefficients{m.coefficients.data}, scratch{m.scratch.data};
    ClothWork work(m, features(m), coefficients, scratch);
    const double h = m.lambda * dt;
    ClothStep step{m, work, dt, h};
    m.iterations = 0;
    m.residual = 0;
    const bool tears = can_tear(m, kU) || can_tear(m, kV);
    uint64_t bad = 0;
    for (size_t s = 0; s < count; ++s) {
        memset(m.scratch.data, 0, m.scratch.bytes()); // a step that went too far may have left what is not finite
        if (must_prepare(m, dt)) prepare(m, work, h, dt);
        Clock clock = m.clock;
        clock.advance(dt, s);
        const bool finite = step.step(clock.time());
        if (step.iterations > m.iterations) m.iterations = step.iterations;
        if (!(step.left <= m.residual)) m.residual = isnan(step.left) ? INFINITY : step.left;
        if (!finite && bad == 0) bad = m.clock.steps + s + 1;
        if (tears && finite) m.broken += tear_springs(m, work);
    }
    if (bad) stop_nodes(m);
    return {bad, true};
}

} // namespace cd
