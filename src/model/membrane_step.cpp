// Steps of a membrane, one component after the other. Each stage (stages.hh) solves, for the change dw = w - v
// (model.md, 29),
//
//      S dw = r,     S = M + h C + h^2 K,     r = h [f + M g - K (x + (h + damping) v)] - h (drag M + Z) v
//
// Separable sheets, alternating: B dw = r (model.md, 30), rows then columns, with
//      B = (M' + A_u) M'^-1 (M' + A_v),     M' = M (1 + h drag),     A_d = h (h + damping) K_d.
// Of a plate with twist A_d has the bend along d twice: with both ends of every line held or joined, the twist is at
// most as stiff as the two bends together, 2 |x_uv|^2 <= |x_uu|^2 + |x_vv|^2 in the mean. So B >= S, which makes steps
// stable for lambda >= 1/2. (With the bends once and the twist in r alone, B - h^2 K has modes of no mass, and with
// drag of a negative one: a hinged plate then grows without bound.)
//
// B >= S needs directions that commute. Where they do not, the factored system blows up; a pinned corner is enough. So
// on any other sheet the lines' answers only span a space, and w is the element of it that comes nearest to the system
// in energy. Its residual is then orthogonal to w, and the energy's change over a step, which is w times what the step
// got wrong, is that of the exact solve: none at lambda = 1/2, a loss above. The space is v, a motion of all nodes
// alike (so that momentum is kept; of each part on its own, where a sheet is in parts), S_u r, S_v r and S_v M S_u r +
// S_u M S_v r, with S_d = (M + A_d)^-1 and r what is left of the system after the best multiple of v. With v in it the
// steps together act as conjugate gradients towards the static solution.
//
// Coupled: conjugate gradients on the same r; then once more the best of v, all alike and its answer, for the same
// reasons.
//
// Of a stiff sheet that nothing holds the mean motion is computed apart: see membrane_mean.cpp.
//
// Of a single line with stiff bend, B is S, and with s = x / (h + damping) + v and what acts but springs, e, is
//      dw = B^-1 (e + M' s) - s:
// r, which is as large as the forces, of which B^-1 leaves little, is not made.
//
// In both, where springs are stiff, r starts from the whole of S w = b and v is taken out of that: of a stiff spring's
// velocity most cancels, and what is left would be lost in r's rounding. Where they are soft the change is all there is
// to lose.
#include <math.h>

#include "model/membrane_work.hh"

namespace cd {

namespace {

struct Stepper {
    Membrane& m;
    Work& w;
    double dt, h;
    Convergence worst; // of all coupled solves

    const SheetKernels& sheet() const { return m.kernels->sheet; }
    template <class Body> void rows(const Body& body) const { w.system.rows(body); }

    // Makes a step. False if a number left the finite range.
    bool step() {
        if (m.pressure != 0) press(m);
        bool finite = true;
        const StageMoves moves(m, dt);
        const StateNumbers kept_x{w.kept_x, true}, kept_v{w.kept_v, true};
        for (size_t k = 0; k < m.components; ++k) {
            const StateNumbers x = plane_of(m.position, k), v = plane_of(m.velocity, k);
            if (!w.implicit) {
                const SheetMove by{1, dt, m.method == CD_METHOD_SYMPLECTIC_EULER ? 1.0 : 0.0, {w.residual}, {1}, 1};
                if (w.uniform) {
                    finite &= sweep_once(k, by, x, v);
                    continue;
                }
                start(k, x, v);
                w.system.multiply(w.residual, w.inverse, w.residual);
                finite &= move(by, x, v, x, v);
            } else if (moves.count == 1) {
                finite &= stage(k, moves, 0, x, v, x, v);
            } else {
                stage(k, moves, 0, x, v, kept_x, kept_v);
                finite &= stage(k, moves, 1, kept_x, kept_v, x, v);
            }
        }
        return finite;
    }

    // What acts on component k of a uniform sheet.
    struct Uniform {
        SheetPush push;
        SeparableSheet sheet;
        UniformStage stage;

        Uniform(const Stepper& s, size_t k)
            : push(s.push(k)),
              sheet(s.separable_sheet()),
              stage{sheet,
                    push,
                    s.w.implicit ? 1 / (s.h + s.m.damping) : 1,
                    s.w.implicit ? 1 : s.m.damping,
                    s.m.ring[kU] != 0,
                    is_constant(push, sheet),
                    {s.w.shared[kU].carry, s.w.shared[kU].pull},
                    {s.w.shared[kV].carry, s.w.shared[kV].pull},
                    !s.m.parallel.run && s.w.held.count == 0,
                    s.w.held.count,
                    s.w.held.place,
                    s.w.held.compliance,
                    s.m.mean_apart ? flatten_rows : nullptr} {}
    };
    // Held nodes, which rounding would move by the impulses that hold them.
    struct KeptNodes {
        const HeldNodes& held;
        double x[HeldNodes::kMost], v[HeldNodes::kMost];

        KeptNodes(const HeldNodes& held_, double move, const StateNumbers& from_x, const StateNumbers& from_v)
            : held(held_) {
            for (size_t a = 0; a < held.count; ++a) {
                v[a] = from_v[held.place[a]];
                x[a] = from_x[held.place[a]] + move * v[a];
            }
        }
        void put(const StateNumbers& to_x, const StateNumbers& to_v) const {
            for (size_t a = 0; a < held.count; ++a) {
                if (!held.is_held(a)) continue;
                to_x.put(held.place[a], x[a]);
                to_v.put(held.place[a], v[a]);
            }
        }
    };
    // w.wish = by how much ties alone would change the velocities of their nodes.
    void find_wishes(size_t k, const StateNumbers& x, const StateNumbers& v) const {
        const StateNumbers target = plane_of(m.target, k);
        for (size_t a = 0; a < w.held.count; ++a) {
            const size_t at = w.held.place[a], node = node_at(m, at % w.grid.pitch, at / w.grid.pitch);
            w.wish[a] =
                w.held.is_held(a) ? 0 : tie_wish(tie_of(m, node), tie_damping_of(m, node), target[at], x[at], v[at]);
        }
    }
    double tie_wish(double tie, double damping, double target, double x, double v) const {
        return (tie * (target - (x + h * v)) - damping * v) / (h * tie + damping);
    }
    double* looked(size_t band) const { return w.looked + band * kLookedRows * w.grid.pitch; }

    bool sweep_once(size_t k, const SheetMove& by, const StateNumbers& x, const StateNumbers& v) const {
        const Uniform now(*this, k);
        bool finite = true;
        w.bands.each(m.parallel, [&](size_t band, size_t first, size_t count) {
            sheet().look_beyond(w.grid, now.stage, by, x, v, looked(band), first, count);
        });
        w.bands.each(m.parallel, [&](size_t band, size_t first, size_t count) {
            if (!sheet().step_rows(w.grid, now.stage, by, x, v, looked(band), first, count))
                __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
        });
        return finite;
    }

    // One implicit stage of component k, from (x, v) to (to_x, to_v).
    bool stage(size_t k, const StageMoves& by, int number, const StateNumbers& x, const StateNumbers& v,
               const StateNumbers& to_x, const StateNumbers& to_v) {
        if (w.swept) return sweep(k, by, number, x, v, to_x, to_v);
        start(k, x, v);
        if (!w.general) find_wishes(k, x, v);
        return move(solve(by.overshoot[number], by.move[number]), x, v, to_x, to_v);
    }

    // Likewise of a uniform sheet. On one thread, and where no single nodes are held, the filters down the columns
    // start at once.
    bool sweep(size_t k, const StageMoves& by, int number, const StateNumbers& x, const StateNumbers& v,
               const StateNumbers& to_x, const StateNumbers& to_v) const {
        const Uniform now(*this, k);
        if (m.mean_apart) change_rows(now, x, v);
        const UniformStage& stage = now.stage;
        const KeptNodes kept(w.held, by.move[number], x, v);
        find_wishes(k, x, v);
        w.bands.each(m.parallel, [&](size_t band, size_t first, size_t count) {
            sheet().sweep_down(w.grid, stage, x, v, w.residual, looked(band), first, count);
        });
        if (w.held.count > 0) hold(m, w, w.residual);
        const SheetMove move{1 + by.overshoot[number], by.move[number], 1, {}, {}, 0};
        bool finite = true;
        w.strips.each(m.parallel, [&](size_t, size_t first, size_t count) {
            if (!sheet().sweep_up(w.grid, stage.along_v, stage.carries, move, m.mean_apart ? w.row_change : nullptr,
                                  w.residual, w.looked, x, v, to_x, to_v, first, count))
                __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
        });
        kept.put(to_x, to_v);
        return finite;
    }

    bool move(const SheetMove& by, const StateNumbers& x, const StateNumbers& v, const StateNumbers& to_x,
              const StateNumbers& to_v) const {
        bool finite = true;
        rows([&](size_t first, size_t count) {
            if (!sheet().move_nodes(w.grid, by, x, v, to_x, to_v, first, count))
                __atomic_store_n(&finite, false, __ATOMIC_RELAXED);
        });
        return finite;
    }

    // w.residual = r for component k, where nodes move; of a separable sheet without planes divided by its masses.
    // w.free_v too, if the solver wants it.
    void start(size_t k, const StateNumbers& x, const StateNumbers& v) const {
        const double closing_rate = w.implicit ? 1 / (h + m.damping) : 1, v_share = w.implicit ? 1 : m.damping;
        const SheetGather look{closing_rate, m.whole ? 0 : v_share, v_share, w.mass, w.scaled, w.free_v};
        const SheetPush push = this->push(k);
        rows([&](size_t first, size_t count) { sheet().gather(w.grid, look, x, v, first, count); });
        if (w.general) {
            rows([&](size_t first, size_t count) {
                sheet().push_general(w.grid, w.system.sheet, push, x, v, w.residual, first, count);
            });
            if (m.mean_apart && m.likeness != kDiffer && !w.coupled)
                cd::change_rows(m, w, h, x, v, {w.residual, w.inverse, 1});
            else if (m.mean_apart) find_outer(m, w, w.residual);
            if (!m.stiff_rod) w.system.pull(w.scaled, w.residual);
            return;
        }
        const Uniform now(*this, k);
        if (m.mean_apart) change_rows(now, x, v);
        const bool constant = now.stage.constant;
        w.system.wrap(w.scaled);
        rows([&](size_t first, size_t count) {
            if (!constant) sheet().push_separable(w.grid, now.sheet, push, v, w.residual, first, count);
            sheet().pull_separable(w.grid, now.sheet, w.scaled, constant, push.gravity, w.residual, first, count);
        });
    }

    // For a uniform sheet whose mean motion is apart; w.residual is scratch.
    void change_rows(const Uniform& now, const StateNumbers& x, const StateNumbers& v) const {
        const double gain = w.rows[kV].gain[0];
        if (now.stage.constant) return cd::change_rows(m, w, h, x, v, {nullptr, nullptr, gain * now.push.gravity});
        rows([&](size_t first, size_t count) {
            sheet().push_separable(w.grid, now.sheet, now.push, v, w.residual, first, count);
        });
        cd::change_rows(m, w, h, x, v, {w.residual, nullptr, gain});
    }

    SheetPush push(size_t k) const {
        return {h * m.gravity[k],
                h,
                h * m.drag,
                plane_of(m.force, k),
                plane_of(m.target, k),
                m.pressed ? m.pressed.data + k * m.plane : nullptr,
                w.tie,
                m.whole};
    }
    // Whether h g is all that acts on nodes beside springs.
    static bool is_constant(const SheetPush& push, const SeparableSheet& sheet) {
        return !push.forces && !push.pressed && push.drag == 0 && !sheet.drag[0];
    }

    StateNumbers plane_of(const Array<char>& array, size_t k) const {
        const StateNumbers all = state_of(m, array);
        return all ? all.from(k * m.plane) : all;
    }

    SeparableSheet separable_sheet() const {
        const DirectionRows &u = w.rows[kU], &v = w.rows[kV];
        bool matched = false;
        for (cd_node edge : m.edge) matched |= edge == CD_NODE_MATCHED;
        return {{u.before, v.before},
                {u.after, v.after},
                {u.gain, v.gain},
                {u.inverse_mass, v.inverse_mass},
                {matched ? u.drag : nullptr, matched ? v.drag : nullptr}};
    }

    // How the solver moves the nodes, from w.residual.
    SheetMove solve(double overshoot, double move) {
        SheetMove by{1 + overshoot, move, 1, {w.residual}, {1}, 1};
        if (CD_WITH_COUPLED && w.coupled) solve_together(by);
        else if (m.likeness != kDiffer) alternate();
        else alternate_nearest(by);
        return by;
    }

    // w.residual = B^-1 r
    void alternate() const {
        if (w.general) w.system.multiply(w.residual, w.inverse, w.residual);
        const auto flatten = [&](size_t first, size_t count) {
            flatten_rows(w.grid, w.rows[kU].inverse_mass, w.residual, first, count);
        };
        if (m.stiff_rod) w.system.combine(1, w.residual, 1, w.scaled);
        if (m.mean_apart) rows(flatten);
        if (w.general) take_wishes(w, w.residual);
        w.held.clear(w.residual);
        w.system.turn(w.residual, w.turned_plane);
        w.shared[kU].solve(*m.kernels, m.parallel, w.turned, w.turned_plane, w.slope);
        w.system.turn_back(w.turned_plane, w.residual);
        if (m.mean_apart) rows(flatten);
        if (w.held.count > 0) hold(m, w, w.residual);
        w.shared[kV].solve(*m.kernels, m.parallel, w.grid, w.residual, w.slope);
        w.held.clear(w.residual);
        for (size_t r = 0; r < w.grid.rows && m.mean_apart; ++r)
            for (size_t u = 0; u < w.grid.columns; ++u) w.residual[r * w.grid.pitch + u] += w.row_change[r];
        if (m.stiff_rod) w.system.combine(1, w.residual, -1, w.scaled);
    }

    // to = S_d from, nearly; with bend the product of two factors. They may be one plane.
    void solve_lines(Direction d, const double* from, double* to) const {
        const Grid& grid = d == kU ? w.turned : w.grid;
        double* const lines = d == kU ? w.turned_plane : to;
        if (d == kU) w.system.turn(from, lines);
        const double* right = d == kU ? lines : from;
        for (int f = 0; f < w.factors(); ++f) {
            const LineFactors factors = w.line[f][d].factors();
            in_parts(m.parallel, grid.columns, grid.rows, [&](size_t first, size_t count) {
                sheet().solve_lines(grid, factors, right, lines, first, count);
            });
            right = lines;
        }
        if (d == kU) w.system.turn_back(lines, to);
    }

    // Takes the best multiple 1 - share of v out of w.residual; returns share. applied: scratch.
    double take_out_velocity(double* applied) const {
        const double energy = w.system.apply(w.free_v, applied), match = w.system.dot(w.free_v, w.residual);
        const double part = energy > 0 ? match / energy : 0; // of v: of all of it, or of its change
        if (part != 0 || !m.whole) w.system.combine(1, w.residual, -part, applied);
        return m.whole ? 1 - part : -part;
    }

    // Moves by the best of v, of a motion of all nodes alike, and of n answers, given the residual that is left beside
    // (1 - share) v. It keeps the momentum of a free sheet, and of each part of it, whatever the answers are.
    void move_by_nearest(SheetMove& by, double share, double* const* answers, int n, const double* residual) const {
        double *planes[kMostDirections] = {w.free_v}, taken[kMostDirections] = {};
        const bool parts_apart = m.parts > 1 || m.mean_apart;
        int count = 1;
        if (!parts_apart) planes[count++] = w.one;
        for (int k = 0; k < n; ++k) planes[count++] = answers[k];
        if (parts_apart) separate_parts(m, w, planes, count, share, residual, taken);
        for (int k = 0; k < count; ++k) by.change[k] = planes[k];
        w.system.project(planes, count, residual, taken, by.factor);
        by.factor[0] -= share;
        if (parts_apart) {
            by.change[count] = w.one;
            by.factor[count++] = 1;
        }
        by.changes = count;
    }

    void alternate_nearest(SheetMove& by) const {
        double *const both = w.answer[0], *const along_u = w.answer[1], *const along_v = w.answer[2];
        const double share = take_out_velocity(w.scaled);
        solve_lines(kU, w.residual, along_u);
        solve_lines(kV, w.residual, along_v);
        w.system.multiply(w.ground, along_u, both);
        solve_lines(kV, both, both);
        w.system.multiply(w.ground, along_v, w.scaled);
        solve_lines(kU, w.scaled, w.scaled);
        w.system.combine(1, both, 1, w.scaled);
        move_by_nearest(by, share, w.answer, 3, w.residual);
    }

    void solve_together(SheetMove& by) {
        const double share = take_out_velocity(w.gradient.applied);
        const Goal goal{m.tolerance, sqrt(w.system.dot(w.scaled, w.scaled)), m.most_iterations};
        const Convergence reached =
            solve_coupled(w.system, w.preconditioner, goal, w.gradient, w.residual, w.answer[0]);
        if (reached.iterations > worst.iterations) worst.iterations = reached.iterations;
        const bool has_square = reached.residual == reached.residual;
        const double residual = has_square ? reached.residual : HUGE_VAL;
        if (residual > worst.residual) worst.residual = residual;
        worst.reached &= reached.reached;
        move_by_nearest(by, share, w.answer, 1, w.gradient.start);
    }
};

// What lies beyond the rows' ends, and in the scratch, is no part of the sheet, but sweeps work on it too: numbers that
// are not finite leak there and back, or grow there by themselves.
void clear_beyond(Membrane& m) {
    if (m.scratch) memset(m.scratch.data, 0, m.scratch.bytes());
    const size_t size = number_size(m);
    for (char* const state : {m.position.data, m.velocity.data})
        for (size_t row = 0; row < m.components * m.rows; ++row)
            memset(state + (row * m.pitch + m.columns) * size, 0, (m.pitch - m.columns) * size);
}

MembraneOutcome step_springs(Membrane& m, double dt, size_t count) {
    const bool anew = must_prepare(m, dt);
    MembraneFeatures with = features(m);
    with.solver = m.taken, with.likeness = m.likeness;
    if (anew) {
        with.solver = m.solver;
        choose_way(m, dt, with);
    }
    if (with.solver != m.taken || with.likeness != m.likeness) clear_work(m);
    m.taken = with.solver, m.likeness = with.likeness;
    Carver coefficients{m.coefficients.data}, scratch{m.scratch.data};
    Work work(m, with, coefficients, scratch);
    if (anew) {
        prepare(m, work, dt);
        if (work.implicit) ++m.factorizations;
    }
    Stepper stepper{m, work, dt, stage_share(m, dt), {}};
    uint64_t bad = 0;
    for (size_t s = 0; s < count; ++s) {
        if (stepper.step()) continue;
        clear_beyond(m);
        if (bad == 0 && !all_finite(m)) bad = m.clock.steps + s + 1;
    }
    if (bad) stop_nodes(m);
    m.iterations = stepper.worst.iterations;
    m.residual = stepper.worst.residual;
    return {bad, stepper.worst.reached};
}

} // namespace

// f(place) for each number of nodes that are driven to their targets.
template <class F> static void each_posed(const Membrane& m, F f) {
    bool any = m.pin && memchr(m.pin.data, CD_NODE_POSED, m.pin.count);
    for (cd_node edge : m.edge) any |= edge == CD_NODE_POSED;
    for (size_t i = 0; i < m.nodes && any && m.target; ++i) {
        const size_t u = i % m.columns, v = i / m.columns;
        const bool posed = kind_of(m, u, v) == CD_NODE_POSED && present(m, u, v);
        for (size_t k = 0; k < m.components && posed; ++k) f(place(m, u, v, k));
    }
}

static MembraneOutcome make_steps(Membrane& m, double dt, size_t count) {
    if constexpr (CD_WITH_CLOTH)
        if (has_lengths(m)) {
            m.taken = CD_SOLVER_AUTO;
            return step_cloth(m, dt, count);
        }
    return step_springs(m, dt, count);
}

// All of a membrane, as what sleeps: see model/sleep.hh.
static SleepingPart sleeping_part(const Membrane& m) {
    return {0, m.nodes, 0, m.columns, m.pitch, 1, m.plane, [](const Body& b, const SleepingPart& part, size_t i) {
                return held(static_cast<const Membrane&>(b), i % part.width, i / part.width);
            }};
}

// As make_steps, of a membrane that may sleep.
static MembraneOutcome step_until_asleep(Membrane& m, double dt, size_t count) {
    MembraneOutcome all{0, true};
    Convergence worst{};
    const Clock start = m.clock;
    for (size_t s = 0; s < count; ++s) {
        Clock after = m.clock;
        after.advance(dt, 1);
        const Surroundings around(m, m.cloth.thickness, dt, after.time());
        const bool asleep = goes_on_sleeping(m, sleeping_part(m), around);
        const size_t broken = m.broken;
        const MembraneOutcome one = asleep ? MembraneOutcome{0, true} : make_steps(m, dt, 1);
        m.clock = after;
        if (asleep) continue;
        if (all.diverged_at == 0) all.diverged_at = one.diverged_at;
        all.converged &= one.converged;
        if (m.iterations > worst.iterations) worst.iterations = m.iterations;
        if (m.residual > worst.residual) worst.residual = m.residual;
        if (m.broken > broken) wake(m);
        fall_asleep(m, sleeping_part(m), around);
    }
    m.iterations = worst.iterations;
    m.residual = worst.residual;
    m.clock = start;
    return all;
}

MembraneOutcome step_membrane(Membrane& m, double dt, size_t count) {
    each_posed(m, [&](size_t at) { pose(m, at, dt * double(count)); });
    m.bad_answer = {};
    m.broken = 0;
    const MembraneOutcome outcome = may_sleep(m) ? step_until_asleep(m, dt, count) : make_steps(m, dt, count);
    m.clock.advance(dt, count);
    // Steps that keep the energy without the extra mass of factored lines.
    if (m.taken == CD_SOLVER_COUPLED || (m.taken == CD_SOLVER_ALTERNATING && m.likeness == kDiffer)) make_unlike(m);
    m.diverged = outcome.diverged_at != 0;
    if (!m.diverged) each_posed(m, [&](size_t at) { arrive(m, at); });
    return outcome;
}

} // namespace cd
