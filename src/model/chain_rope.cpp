// Steps of chains whose springs have a length: what the kernel is given, see kernel/rope_step.hh.
#include <math.h>

#include "base/parallel.hh"
#include "model/chain.hh"

namespace cd {

namespace {

// Strands are stepped in groups, and a task steps some groups one after the other with a scratch of its own.
constexpr size_t kMostTasks = 16;

size_t groups_of(const Chain& c) { return (c.strands + kRopeStrands - 1) / kRopeStrands; }
size_t tasks_of(const Chain& c) { return groups_of(c) < kMostTasks ? groups_of(c) : kMostTasks; }
size_t scratch_of_task(const Chain& c, bool air) {
    return c.nodes * (kRopeScratch + (air ? kAirScratch : 0)) * (c.strands > 1 ? kRopeStrands : 1);
}

RopeCoefficients coefficients_of(Chain& c, bool changed) {
    double* const row = c.coefficients.data;
    double *const mass = row, *const drag = row + c.nodes, *const tie = row + 2 * c.nodes,
                  *const length = row + 3 * c.nodes, *const per_length = row + 4 * c.nodes,
                  *const compliance = row + 5 * c.nodes, *const share = row + 6 * c.nodes;
    for (size_t i = 0; i < c.nodes && changed; ++i) {
        mass[i] = mass_of(c, i);
        drag[i] = drag_of(c, i);
        tie[i] = tie_of(c, i);
    }
    for (size_t i = 0; i < c.springs && changed; ++i) {
        length[i] = length_of(c, i);
        per_length[i] = 1 / length[i];
        compliance[i] = 1 / fabs(stiffness_of(c, i)); // which may be -0
    }
    const auto half = [&](size_t i) { return i < c.springs && !isinf(compliance[i]) ? 0.5 * length[i] : 0; };
    for (size_t i = 0; i < c.nodes && changed; ++i) share[i] = half(i) + (i > 0 ? half(i - 1) : 0);
    return {mass, drag, tie, length, per_length, compliance, share, c.pin.data};
}

} // namespace

const char* what_ropes_lack(const Chain& c) {
    if (c.method != CD_METHOD_IMPLICIT) return "method but CD_METHOD_IMPLICIT";
    if (c.lambda < 0.5) return "lambda below 1/2";
    if (has_bend(c)) return "bend";
    if (c.ring) return "ring";
    if (c.damping > 0) return "stiffness damping";
    if (c.pin[0] == CD_NODE_MATCHED || c.pin[c.nodes - 1] == CD_NODE_MATCHED) return "matched end";
    return nullptr;
}

size_t rope_coefficients(const Chain& c) { return 7 * c.nodes; }
size_t rope_scratch(const Chain& c, bool air) { return tasks_of(c) * scratch_of_task(c, air); }

void clear_state(Chain& c) {
    clear_state(static_cast<Body&>(c));
    if (c.tension) memset(c.tension.data, 0, c.tension.bytes());
}

uint64_t step_ropes(Chain& c, double dt, size_t count) {
    const bool changed = c.prepared_dt == 0 && must_prepare(c, dt); // coefficients are the same at any dt
    const RopeCoefficients coefficients = coefficients_of(c, changed);
    const auto state = [&](const Array<char>& array) { return StateNumbers{array.data, c.precision == CD_FLOAT64}; };
    const Ropes ropes = {c.nodes,           c.strands,      c.components,    c.pitch,       state(c.position),
                         state(c.velocity), state(c.force), state(c.target), state(c.wind), c.tension.data};
    const RopeStage stage = {dt,
                             c.lambda,
                             {c.gravity[0], c.gravity[1], c.gravity[2]},
                             c.air.along,
                             c.air.across,
                             {c.air.wind[0], c.air.wind[1], c.air.wind[2]},
                             c.rope.push != 0,
                             c.rope.tolerance,
                             size_t(c.rope.most_iterations)};
    RopeResult results[kMostTasks];
    uint64_t bad[kMostTasks];
    const size_t groups = groups_of(c), tasks = tasks_of(c);
    auto task = [&](size_t t) {
        double* const scratch = c.scratch.data + t * scratch_of_task(c, stage.has_air());
        bad[t] = UINT64_MAX;
        for (size_t g = t * groups / tasks; g < (t + 1) * groups / tasks; ++g) {
            const size_t first = g * kRopeStrands, left = c.strands - first;
            for (size_t s = 0; s < count; ++s) {
                const RopeResult result = c.kernels->rope_step(ropes, coefficients, stage, scratch, first,
                                                               left < kRopeStrands ? left : kRopeStrands);
                results[t].add(result);
                if (!result.finite && s < bad[t]) bad[t] = s;
            }
        }
    };
    parallel_for(c.parallel, tasks, task);
    uint64_t first_bad = UINT64_MAX;
    for (size_t t = 0; t < tasks; ++t) {
        if (bad[t] < first_bad) first_bad = bad[t];
        if (results[t].iterations > c.iterations) c.iterations = results[t].iterations;
        if (!(results[t].error <= c.residual)) c.residual = results[t].error;
    }
    return first_bad;
}

} // namespace cd
