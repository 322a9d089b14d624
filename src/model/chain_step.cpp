// Steps of a chain, in the stages of stages.hh. The springs enter the solvers with the stiffness h (h + damping) k_i
// and the wish that w_{i+1} - w_i be -(x_{i+1} - x_i) / (h + damping).
#include "model/chain.hh"

#include <math.h>

#include "base/parallel.hh"
#include "kernel/kernels.hh"
#include "model/stages.hh"
#include "solve/ring_closure.hh"
#include "solve/rod_line.hh"
#include "solve/segment_line.hh"
#include "solve/segment_rod.hh"
#include "solve/spring_line.hh"

namespace cd {

namespace {

bool is_rod(const Chain& c) { return CD_WITH_BEND && (has_bend(c) || c.ring); }

// The system of one stage, for the solvers to factor.
struct StageSystem {
    const Chain& c;
    double h, sigma = h * (h + c.damping);
    double end_mass = uniform_mass(c, 0), inner_mass = uniform_mass(c, 1),
           uniform_spring = sigma * uniform_stiffness(c);
    bool uniform = !c.node_mass && !c.spring_stiffness && !c.node_bend && !c.attach_stiffness && !c.attach_damping;

    double mass(size_t i) const {
        return c.node_mass ? c.node_mass[i] : i == 0 || i + 1 == c.nodes ? end_mass : inner_mass;
    }
    double drag(size_t i) const {
        return c.pin[i] == CD_NODE_MATCHED || c.attach_damping ? drag_of(c, i) : c.drag * mass(i);
    }
    [[gnu::noinline]] double ground(size_t i) const {
        return held(c, i) ? double(INFINITY) : mass(i) + h * drag(i) + h * h * tie_of(c, i);
    }
    double spring(size_t i) const { return c.spring_stiffness ? sigma * c.spring_stiffness[i] : uniform_spring; }
    double bend(size_t i) const { return sigma * bend_of(c, i); }
    bool repeats(size_t i) const {
        return i > 1 && i + 1 < c.nodes && c.pin[i] == c.pin[i - 1] && (uniform || fields_repeat(i));
    }

private:
    [[gnu::noinline]] bool fields_repeat(size_t i) const {
        const auto as_before = [i](const auto& field) { return !field || field[i] == field[i - 1]; };
        return as_before(c.node_mass) && as_before(c.spring_stiffness) && as_before(c.node_bend) &&
               as_before(c.attach_stiffness) && as_before(c.attach_damping);
    }
};

// The chain's coefficients, rows of one number per node, handed out to those who need one (chain.cpp counts them).
struct Rows {
    double* next;
    size_t length;

    explicit Rows(const Chain& c) : next(c.coefficients.data), length(row_length(c)) {}
    double* take(bool needed = true) { return needed ? take(length) : nullptr; }
    // Not inlined, as the two constructors below: all kinds of lines call them, and would each have a copy.
    [[gnu::noinline]] double* take(size_t numbers) {
        double* const row = next;
        next += numbers;
        return row;
    }
    template <class Thing> Thing* take_for(size_t count) {
        return reinterpret_cast<Thing*>(take(numbers_of<Thing>(count)));
    }
};

struct GainRows {
    double *gravity, *drag, *force, *attach; // the last two null where nothing of the kind acts
    bool drags;

    [[gnu::noinline]] GainRows(const Chain& c, Rows& rows)
        : gravity(rows.take()),
          drag(rows.take()),
          force(rows.take(bool(c.force))),
          attach(rows.take(bool(c.target))),
          drags(c.drag > 0 || c.target || c.pin[0] == CD_NODE_MATCHED || c.pin[c.nodes - 1] == CD_NODE_MATCHED) {}

    // Gains of node i, at place `at`, when `grounded` is what resists it; repeated: they are those of the last one.
    CD_INLINED void set(const StageSystem& s, size_t i, double grounded, size_t at, bool repeated) {
        if (!repeated) {
            if (i == 0 || !s.repeats(i)) {
                mass = s.mass(i);
                if (drags) dragging = s.h * s.drag(i) + s.h * s.h * tie_of(s.c, i);
                if (attach) tie = s.h * tie_of(s.c, i);
            }
            of_mass = mass / grounded;
            if (force) of_force = s.h / grounded;
            if (drags) of_drag = dragging / grounded;
            if (attach) of_tie = tie / grounded;
        }
        gravity[at] = of_mass;
        if (drags) drag[at] = of_drag;
        if (force) force[at] = of_force;
        if (attach) attach[at] = of_tie;
    }
    // Of all nodes, when nothing resists them but what is their own.
    [[gnu::noinline]] void set_all(const StageSystem& s, PlacesInTurn place) {
        double ground = 0;
        for (size_t i = 0; i < s.c.nodes; ++i) {
            const bool alike = s.repeats(i);
            if (!alike) ground = s.ground(i);
            set(s, i, ground, place(i), alike);
        }
    }
    NodeGains gains() const { return {gravity, force, drags ? drag : nullptr, attach}; }

private:
    double mass = 0, dragging = 0, tie = 0; // of the last node
    double of_mass = 0, of_drag = 0, of_force = 0, of_tie = 0;
};

// Gains, as factorizations of springs tell them.
struct GainSetter {
    GainRows& gains;
    const StageSystem& system;

    void operator()(size_t i, double grounded, size_t at, bool repeated) const {
        gains.set(system, i, grounded, at, repeated);
    }
};

// What to solve for, see Stage::of_change. Springs alone are better solved for w even where they are soft.
double of_change(const StageSystem& s) {
    if (s.c.method == CD_METHOD_IMPLICIT && s.c.lambda < 0.5) return 1;
    if (!is_rod(s.c)) return 0;
    double stiffest = 0, lightest = INFINITY; // of (omega h)^2, as far as it goes
    for (size_t i = 0; i < s.c.nodes; ++i) {
        if (s.repeats(i)) continue;
        if (i < springs_in_all(s.c) && !welded(s.c, i)) stiffest = fmax(stiffest, 4 * s.spring(i));
        stiffest = fmax(stiffest, 16 * s.bend(i));
        lightest = fmin(lightest, s.mass(i));
    }
    return stiffest < lightest ? 1 : 0;
}

// 1 for every spring that wants to close, 0 for welds.
void set_closing(const Chain& c, double* closing) {
    for (size_t i = 0; i < c.springs; ++i) closing[i] = welded(c, i) ? 0 : 1;
}

// Whether the numbers of a row from `first` to before `end` are all the same.
bool is_uniform(const double* row, size_t first, size_t end) {
    for (size_t i = first + 1; i < end; ++i)
        if (row[i] != row[first]) return false;
    return true;
}

// ---- the kinds of step ----------------------------------------------------------------------------------------------

Lines lines_of(const Chain& c) {
    return {c.nodes,
            c.pitch,
            c.components,
            state_of(c, c.position),
            state_of(c, c.velocity),
            state_of(c, c.force),
            state_of(c, c.target)};
}

// Whether lines are finite now: where welds take back what a sweep left, that may be all that was not.
bool are_finite(const Lines& lines, size_t first, size_t count) {
    bool finite = true;
    for (size_t i = 0; i < lines.nodes; ++i)
        for (size_t at = i * lines.pitch + first, end = at + count; at < end; ++at)
            finite &= isfinite(lines.position[at]) && isfinite(lines.velocity[at]);
    return finite;
}

struct Stages {
    Stage stage[2];
    int count;

    // Number by number: processors wait where what was just stored in parts is read as a whole.
    [[gnu::noinline]] Stages(const Chain& c, double dt) {
        const double h = stage_share(c, dt), closing_rate = 1 / (h + c.damping);
        const StageMoves moves(c, dt);
        count = moves.count;
        for (int s = 0; s < count; ++s) {
            stage[s].closing_rate = closing_rate;
            stage[s].overshoot = moves.overshoot[s], stage[s].move = moves.move[s];
            for (size_t k = 0; k < 4; ++k) stage[s].gravity[k] = h * c.gravity[k];
            stage[s].of_change = c.of_change;
        }
    }

    // Runs solve(stage, start, scratch row for the answer, whether to keep it there).
    template <class Solve> bool run(const Chain& c, Solve solve) const {
        double* const rows[2] = {c.scratch.data, c.scratch.data + c.nodes * c.pitch};
        if (count == 1) return solve(stage[0], Start{}, rows[0], false);
        solve(stage[0], Start{}, rows[0], true);
        return solve(stage[1], Start{rows[0], stage[0].overshoot, stage[0].move}, rows[1], false);
    }
};

struct SpringStep {
    Chain& chain;
    Lines lines;
    SpringCoefficients coefficients;
    Stages stages;

    SpringStep(Chain& c, double dt, bool refactor) : chain(c), lines(lines_of(c)), stages(c, dt) {
        Rows rows(c);
        GainRows gains(c, rows);
        double *const carry = rows.take(), *const pull = rows.take();
        double* const closing = rows.take(bool(c.spring_stiffness));
        if (refactor) {
            const StageSystem system{c, stage_share(c, dt)};
            factor_spring_line(c.nodes, system, PlacesInTurn(c.nodes), carry, pull, GainSetter{gains, system});
            if (closing) set_closing(c, closing);
        }
        coefficients = {carry, pull, c.has_welds ? closing : nullptr, gains.gains()};
    }
    // Welds keep their nodes together but for what is too small to be kept.
    bool operator()(size_t first, size_t count) const {
        const bool finite = stages.run(chain, [&](const Stage& stage, const Start& start, double* row, bool keep) {
            return chain.kernels->spring_sweep(lines, coefficients, stage, start, row, keep, first, count);
        });
        if (chain.has_welds) merge_velocities(chain, first, count);
        return finite;
    }
};

// Springs of one long strand.
struct SegmentStep {
    Chain& chain;
    Lines lines;
    SegmentCoefficients coefficients;
    Stages stages;

    SegmentStep(Chain& c, double dt, bool refactor) : chain(c), lines(lines_of(c)), stages(c, dt) {
        Rows rows(c);
        GainRows gains(c, rows);
        const SegmentRows segment{rows.take(), rows.take(),          rows.take(),
                                  rows.take(), rows.take(kSegments), rows.take(kSegments)};
        if (refactor) {
            const StageSystem system{c, stage_share(c, dt)};
            factor_segment_line(c.nodes, system, segment, GainSetter{gains, system});
        }
        coefficients = {segment.carry, segment.pull, segment.share, segment.reach,
                        segment.reply, segment.pass, gains.gains()};
    }
    bool operator()(size_t, size_t) const {
        return stages.run(chain, [&](const Stage& stage, const Start& start, double* row, bool keep) {
            return chain.kernels->segment_sweep(lines, coefficients, stage, start, row, keep);
        });
    }
};

RodRows take_rod(Rows& rows) {
    return {rows.take(), rows.take(), rows.take(), rows.take(), rows.take(), rows.take(), rows.take()};
}

// closing_rate: of springs that are not welded. segments: null where nodes lie in order.
[[gnu::cold]] void close_ring(Chain& c, const StageSystem& system, const RodRows& rod, double closing_rate,
                              const Segments* segments) {
    c.closure = {};
    if (!c.ring) return;
    const size_t n = c.nodes;
    const double stiffness[3] = {system.spring(c.springs), system.bend(n - 1), system.bend(0)};
    double* const response[3] = {c.ring_response.data, c.ring_response.data + n, c.ring_response.data + 2 * n};
    factor_ring(n, system, rod, has_bend(c) ? 3 : 1, stiffness, response, c.ring_response.data + 3 * n, c.closure,
                [&](size_t i) { return segments ? segments->place(i) : i; });
    c.closure.closing_rate = welded(c, c.springs) ? 0 : closing_rate;
}

struct RodStep {
    Chain& chain;
    Lines lines;
    RodCoefficients coefficients;
    Stages stages;

    RodStep(Chain& c, double dt, bool refactor) : chain(c), lines(lines_of(c)), stages(c, dt) {
        Rows rows(c);
        GainRows gains(c, rows);
        const RodRows rod = take_rod(rows);
        double *const has_bend = rows.take(), *const closing = rows.take(bool(c.spring_stiffness));
        if (refactor) {
            const StageSystem system{c, stage_share(c, dt)};
            factor_rod_line(c.nodes, system, rod, PlacesInTurn(c.nodes));
            gains.set_all(system, PlacesInTurn(c.nodes));
            for (size_t i = 0; i < c.nodes; ++i)
                has_bend[i] = system.repeats(i) ? has_bend[i - 1] : bend_of(c, i) > 0 ? 1 : 0;
            if (closing) set_closing(c, closing);
            close_ring(c, system, rod, stages.stage[0].closing_rate, nullptr);
        }
        coefficients = {rod.keep,   rod.close,     rod.turn,  rod.lever,
                        rod.follow, rod.lean,      rod.bend,  c.has_welds ? closing : nullptr,
                        has_bend,   gains.gains(), c.pin.data};
    }
    // The solve keeps welds to rounding; their nodes then share what they have, to the bit.
    bool operator()(size_t first, size_t count) const {
        const ChainKernels& kernels = *chain.kernels;
        double* const slope = chain.scratch.data + size_t(stages.count) * chain.nodes * chain.pitch;
        const bool finite = stages.run(chain, [&](const Stage& stage, const Start& start, double* row, bool keep) {
            if (!chain.ring) return kernels.rod_step(lines, coefficients, stage, start, row, slope, keep, first, count);
            kernels.rod_sweep(lines, coefficients, stage, start, row, slope, first, count);
            return kernels.advance(lines, stage, start, chain.closure, row, keep, first, count);
        });
        if (chain.has_welds) merge_velocities(chain, first, count);
        return finite || (chain.has_welds && are_finite(lines, first, count));
    }
};

// Of one long strand.
struct SegmentRodStep {
    Chain& chain;
    Lines lines;
    SegmentRodCoefficients coefficients;
    Stages stages;

    SegmentRodStep(Chain& c, double dt, bool refactor) : chain(c), lines(lines_of(c)), stages(c, dt) {
        Rows rows(c);
        GainRows gains(c, rows);
        const SegmentRodRows segment{
            take_rod(rows), {rows.take(), rows.take(), rows.take(), rows.take()}, rows.take_for<RodSegment>(kSegments)};
        if (refactor) {
            const StageSystem system{c, stage_share(c, dt)};
            const Segments segments(c.nodes);
            factor_segment_rod(c.nodes, system, segment);
            gains.set_all(system, PlacesInTurn(segments));
            close_ring(c, system, segment.rod, stages.stage[0].closing_rate, &segments);
        }
        const RodRows& rod = segment.rod;
        double* const* const influence = segment.influence;
        coefficients = {
            rod.keep,        rod.close,    rod.turn, rod.lever,
            rod.follow,      rod.lean,     rod.bend, {influence[0], influence[1], influence[2], influence[3]},
            segment.segment, gains.gains()};
    }
    bool operator()(size_t, size_t) const {
        const size_t row = chain.nodes * chain.pitch;
        double *const slope = chain.scratch.data + size_t(stages.count) * row, *const hold = slope + row;
        return stages.run(chain, [&](const Stage& stage, const Start& start, double* value, bool keep) {
            return chain.kernels->segment_rod_step(lines, coefficients, stage, start, chain.closure, value, slope, hold,
                                                   keep);
        });
    }
};

struct ExplicitStep {
    Chain& chain;
    Lines lines;
    ExplicitCoefficients coefficients;
    double dt, gravity[4];
    Carrier carrier;

    ExplicitStep(Chain& c, double dt_, bool refactor) : chain(c), lines(lines_of(c)), dt(dt_) {
        Rows rows(c);
        GainRows gains(c, rows);
        double *const stiffness = rows.take(), *const inertia = rows.take(), *const bend = rows.take(has_bend(c));
        if (refactor) {
            for (size_t i = 0; i < springs_in_all(c); ++i) stiffness[i] = welded(c, i) ? 0 : stiffness_of(c, i);
            for (size_t i = 0; i < c.nodes; ++i) {
                const double mass = held(c, i) ? double(INFINITY) : mass_of(c, i);
                inertia[i] = dt / mass;
                if (bend) bend[i] = bend_of(c, i);
                gains.gravity[i] = mass_of(c, i) / mass;
                gains.drag[i] = dt * drag_of(c, i) / mass;
                if (gains.force) gains.force[i] = inertia[i];
                if (gains.attach) gains.attach[i] = dt * tie_of(c, i) / mass;
            }
        }
        if (refactor)
            c.uniform = is_uniform(stiffness, 0, c.springs) && is_uniform(inertia, 1, c.springs) &&
                        is_uniform(gains.gravity, 1, c.springs);
        coefficients = {stiffness, bend, inertia, gains.gains(), c.damping, c.ring != 0, c.uniform};
        for (size_t k = 0; k < 4; ++k) gravity[k] = dt * c.gravity[k];
        const bool new_velocity = c.method == CD_METHOD_SYMPLECTIC_EULER;
        carrier = !new_velocity ? Carrier::kOldVelocity : c.has_welds ? Carrier::kNothing : Carrier::kNewVelocity;
    }
    // Welds take up any force without a tension of their own: the nodes they join share what they get.
    bool operator()(size_t first, size_t count) const {
        const ChainKernels& kernels = *chain.kernels;
        bool finite = kernels.explicit_sweep(lines, coefficients, dt, gravity, carrier, first, count);
        if (chain.has_welds) merge_velocities(chain, first, count);
        if (carrier == Carrier::kNothing) finite &= kernels.drift(lines, dt, first, count);
        return finite || (chain.has_welds && are_finite(lines, first, count));
    }
};

// ---- many steps of many lines ---------------------------------------------------------------------------------------

constexpr size_t kBundle = 16;

// Explicit steps of short lines are over soon: more of them at a time, as long as they fit the nearest caches and there
// are enough for all threads.
size_t explicit_bundle(const Chain& c) {
    constexpr size_t kNumbers = 1 << 12;
    const size_t most = (c.parallel.run ? 2 : 8) * kBundle, fitting = kNumbers / c.nodes / kBundle * kBundle;
    return fitting < kBundle ? kBundle : fitting < most ? fitting : most;
}

// Lines never mix, so a bundle of them makes all its steps while it is in the cache. A task is some bundles side by
// side: threads then write to lines of the cache apart from each other, and each has enough to do.
uint64_t run(Chain& c, const void* how, bool (*step)(const void* how, size_t first, size_t count), size_t count,
             size_t bundle_lines) {
    constexpr size_t kNumbers = 1 << 12;
    const size_t bundles = (c.lines + bundle_lines - 1) / bundle_lines;
    const size_t enough = kNumbers / bundle_lines / c.nodes / count, per_task = enough > 0 ? enough : 1;
    uint64_t first_bad = UINT64_MAX;
    auto task = [&](size_t t) {
        uint64_t bad = UINT64_MAX;
        for (size_t b = t * per_task; b < bundles && b < (t + 1) * per_task; ++b) {
            const size_t first = b * bundle_lines, left = c.lines - first;
            for (size_t s = 0; s < count; ++s)
                if (!step(how, first, left < bundle_lines ? left : bundle_lines) && s < bad) bad = s;
        }
        uint64_t seen = __atomic_load_n(&first_bad, __ATOMIC_RELAXED);
        while (bad < seen &&
               !__atomic_compare_exchange_n(&first_bad, &seen, bad, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
        }
    };
    parallel_for(c.parallel, (bundles + per_task - 1) / per_task, task);
    return first_bad;
}

template <class Step> uint64_t run(Chain& c, const Step& how, size_t count, size_t bundle_lines = kBundle) {
    const auto step = [](const void* of, size_t first, size_t lines) {
        return (*static_cast<const Step*>(of))(first, lines);
    };
    return run(c, &how, step, count, bundle_lines);
}

uint64_t step_lines(Chain& c, double dt, size_t count) {
    const bool refactor = must_prepare(c, dt);
    if (refactor) {
        c.has_welds = false;
        for (size_t i = 0; i < c.spring_stiffness.count; ++i) c.has_welds |= welded(c, i);
    }
    if (steps_explicitly(c)) return run(c, ExplicitStep(c, dt, refactor), count, explicit_bundle(c));
    if (refactor) {
        ++c.factorizations;
        c.of_change = of_change({c, stage_share(c, dt)});
    }
    const bool rod = is_rod(c), segments = takes_segments(c, rod) && !c.has_welds;
    if constexpr (CD_WITH_BEND) {
        if (rod && segments) return run(c, SegmentRodStep(c, dt, refactor), count);
        if (rod) return run(c, RodStep(c, dt, refactor), count);
    }
    if (segments) return run(c, SegmentStep(c, dt, refactor), count);
    return run(c, SpringStep(c, dt, refactor), count);
}

} // namespace

// f(place) for each number of nodes that are driven to their targets; whether there may be any.
template <class F> static bool each_posed(const Chain& c, F f) {
    if (!c.target || !memchr(c.pin.data, CD_NODE_POSED, c.pin.count)) return false;
    for (size_t i = 0; i < c.nodes; ++i)
        for (size_t s = 0; s < c.strands; ++s)
            for (size_t k = 0; k < c.components && c.pin[own_place(c, s, i)] == CD_NODE_POSED; ++k)
                f(place(c, s, i, k));
    return true;
}

// Steps of a chain that may sleep.
static uint64_t step_until_asleep(Chain& c, double dt, size_t count) {
    uint64_t bad = UINT64_MAX;
    for (size_t s = 0; s < count && !sleeps(c, 0); ++s) {
        if (step_lines(c, dt, 1) != UINT64_MAX && bad == UINT64_MAX) bad = s;
        fall_asleep(c, sleeping_part(c, 0), {c, 0, dt, 0}); // nothing is around it
    }
    return bad;
}

uint64_t step_chain(Chain& c, double dt, size_t count) {
    if (each_posed(c, [&](size_t at) { pose(c, at, dt * double(count)); })) merge_velocities(c, 0, c.lines);
    c.iterations = c.broken = 0, c.residual = 0, c.bad_answer = {};
    const uint64_t bad = has_lengths(c) ? step_ropes(c, dt, count)
                         : may_sleep(c) ? step_until_asleep(c, dt, count)
                                        : step_lines(c, dt, count);
    const uint64_t first = c.clock.steps;
    c.clock.advance(dt, count);
    c.diverged = bad != UINT64_MAX;
    if (c.diverged) hold_nodes(c);
    else each_posed(c, [&](size_t at) { arrive(c, at); });
    return c.diverged ? first + bad + 1 : 0;
}

} // namespace cd
