// Steps of chains whose springs have a length: what the kernel is given, see kernel/rope_step.hh.
#include <math.h>

#include "base/parallel.hh"
#include "model/chain.hh"

namespace cd {

namespace {

// Strands are stepped in groups, and a task steps some groups one after the other with a scratch of its own.
constexpr size_t kMostTasks = 16;
// Of these those that are awake make all their steps before the next ones.
constexpr size_t kStrandsOfGroup = 8, kStrandsInTurn = 8 * kStrandsOfGroup;
constexpr size_t kObstacleNumbers = (sizeof(Obstacle) + sizeof(double) - 1) / sizeof(double);

size_t groups_of(const Chain& c) { return (c.strands + kStrandsOfGroup - 1) / kStrandsOfGroup; }
size_t tasks_of(const Chain& c) { return groups_of(c) < kMostTasks ? groups_of(c) : kMostTasks; }
size_t scratch_of_node(const Chain& c, const RopeNeeds& needs) {
    const size_t more = needs.bend ? kLinkScratch : 0;
    const ColliderSizes& colliders = needs.colliders;
    const size_t of_node = kRopeScratch + (needs.air ? kAirScratch + more : 0) +
                           colliders.count * (kContactScratch + more) + colliders.callbacks * kAnswerScratch +
                           (colliders.callbacks > 0 ? kQuestionScratch : 0) + (needs.bend ? kJointScratch : 0) +
                           (needs.loads ? colliders.count * kPushNumbers : 0);
    return of_node * (c.strands > 1 ? kRopeLanes : kLanesAlone);
}

// Strands side by side wait for the one that takes most iterations, mostly as many as in the step before: those that take
// as many go together. They stay in order where they are alike.
void sort_by(const double* taken, size_t* strands, size_t count) {
    for (size_t i = 1; i < count; ++i) {
        const size_t strand = strands[i];
        size_t at = i;
        for (; at > 0 && taken[strands[at - 1]] > taken[strand]; --at) strands[at] = strands[at - 1];
        strands[at] = strand;
    }
}

RopeParameters parameters_of(Chain& c, bool changed) {
    // Numbers that all strands have in common: of each node, what the total comes to; of all springs; and none.
    double *const mass = c.coefficients.data, *const one = mass + c.nodes;
    for (size_t i = 0; i < c.nodes && changed; ++i) mass[i] = uniform_mass(c, i);
    if (changed)
        one[0] = uniform_length(c), one[1] = uniform_stiffness(c), one[2] = 0, one[3] = uniform_bend(c),
        one[4] = uniform_angle(c);
    const auto own = [&](const Array<double>& field, const double* common, size_t of_item) {
        return field ? RopeNumbers<double>{field.data, c.strands, 1} : RopeNumbers<double>{common, of_item, 0};
    };
    return {own(c.node_mass, mass, 1),     own(c.attach_stiffness, one + 2, 0), own(c.attach_damping, one + 2, 0),
            own(c.spring_length, one, 0),  own(c.spring_stiffness, one + 1, 0), own(c.node_bend, one + 3, 0),
            own(c.node_angle, one + 4, 0), {c.pin.data, c.strands, 1},          c.drag};
}

// By how much spring i is longer than its length, over that, beyond what the tolerance and the rounding of positions
// explain: 0 and less where it is not, or yields.
double beyond_its_length(const Chain& c, size_t strand, size_t i) {
    if (!is_rigid(c, own_place(c, strand, i))) return 0;
    double size = 0; // of the positions
    for (size_t k = 0; k < c.components; ++k)
        for (const size_t node : {i, i + 1}) size += fabs(get_number(c, c.position, place(c, strand, node, k)));
    const double rounded = state_of(c, c.position).range().epsilon * size / length_of(c, own_place(c, strand, i));
    return strain_of(c, strand, i) - c.rope.tolerance - rounded;
}

// Cuts the spring of a strand that bears most over its strength, if that is more than 1; whether there is one. solved:
// whether the step reached its tolerance. Where springs of fixed length stay too long, no tension is enough: what the
// longest of them should bear has no bound, and others of fixed length pass it on, up to held nodes. The weakest of
// these breaks, and the longest before others that are as weak.
bool breaks(Chain& c, size_t strand, bool solved) {
    size_t first = 0, end = c.springs, worst = c.springs;
    double longest = 0, most = 1;
    for (size_t i = 0; i < c.springs && !solved; ++i) {
        const double beyond = beyond_its_length(c, strand, i);
        if (beyond > longest) longest = beyond, worst = i;
    }
    const bool bounded = worst == c.springs;
    const auto load = [&](size_t i) {
        const size_t at = own_place(c, strand, i);
        return (bounded ? c.tension[at] : 1) / strength_of(c, at);
    };
    if (!bounded) {
        const auto goes_on = [&](size_t node, size_t spring) { // what spring bears, from node on
            return !held(c, own_place(c, strand, node)) && is_rigid(c, own_place(c, strand, spring));
        };
        first = worst, end = worst + 1, most = load(worst);
        while (first > 0 && goes_on(first, first - 1)) --first;
        while (end < c.springs && goes_on(end, end)) ++end;
    }
    for (size_t i = first; i < end; ++i)
        if (load(i) > most) most = load(i), worst = i;
    if (worst == c.springs || most == 0) return false; // of infinite strength
    const size_t at = own_place(c, strand, worst);
    c.spring_stiffness[at] = c.tension[at] = 0;
    wake(c, strand, 1);
    return true;
}

} // namespace

const char* what_ropes_lack(const Chain& c) {
    if (c.method != CD_METHOD_IMPLICIT) return "method but CD_METHOD_IMPLICIT: see cd_chain_set_method";
    if (c.lambda < 0.5) return "lambda below 1/2: see cd_chain_set_lambda";
    if (c.ring) return "ring: see cd_chain_set_ring";
    if (c.damping > 0) return "stiffness damping: see cd_chain_set_stiffness_damping";
    for (size_t s = 0; s < c.strands; ++s)
        for (const size_t end : {size_t(0), c.springs})
            if (c.pin[own_place(c, s, end)] == CD_NODE_MATCHED) return "matched end: see cd_chain_set_end";
    return nullptr;
}

// Numbers that all strands have in common: see parameters_of.
static size_t common_numbers(const Chain& c) { return c.nodes + 5; }

size_t rope_coefficients(const Chain& c, size_t colliders) {
    return common_numbers(c) + c.strands + colliders * kObstacleNumbers;
}
size_t rope_scratch(const Chain& c, const RopeNeeds& needs) {
    size_t numbers;
    const bool fits = multiply(tasks_of(c) * rope_lane_room(c.nodes, rope_has_halves(needs.bend)),
                               scratch_of_node(c, needs), numbers);
    return fits ? numbers : SIZE_MAX; // more than there is
}

void clear_state(Chain& c) {
    clear_state(static_cast<Body&>(c));
    if (c.tension) memset(c.tension.data, 0, c.tension.bytes());
}

uint64_t step_ropes(Chain& c, double dt, size_t count) {
    const bool changed = c.prepared_dt == 0 && must_prepare(c, dt); // they are the same at any dt
    const RopeParameters parameters = parameters_of(c, changed);
    const Ropes ropes = {c.nodes,
                         c.strands,
                         c.components,
                         c.pitch,
                         state_of(c, c.position),
                         state_of(c, c.velocity),
                         state_of(c, c.force),
                         state_of(c, c.target),
                         state_of(c, c.wind),
                         c.tension.data,
                         c.coefficients.data + common_numbers(c),
                         c.loads.data,
                         collider_count(c)};
    Obstacle* const obstacles = reinterpret_cast<Obstacle*>(ropes.taken + c.strands);
    ColliderSizes met = {};
    each_obstacle(c, c.rope.thickness, [&](const Obstacle& to) {
        obstacles[met.count++] = to;
        met.callbacks += to.callback != nullptr;
    });
    const RopeStage stage = {dt,
                             c.lambda,
                             {c.gravity[0], c.gravity[1], c.gravity[2]},
                             c.air.along,
                             c.air.across,
                             {c.air.wind[0], c.air.wind[1], c.air.wind[2]},
                             c.rope.push != 0,
                             has_bend(c),
                             curls(c),
                             c.rope.tolerance,
                             size_t(c.rope.most_iterations),
                             obstacles,
                             met.count,
                             met.callbacks,
                             0,
                             0};
    RopeResult results[kMostTasks];
    uint64_t bad[kMostTasks];
    size_t broken[kMostTasks] = {};
    const size_t groups = groups_of(c), tasks = tasks_of(c);
    const size_t of_strand = load_numbers(ropes.collider_count, 1);
    const size_t of_task = rope_lane_room(c.nodes, stage.has_halves()) *
                           scratch_of_node(c, {stage.bends, stage.has_air(), bool(c.loads), met});
    const auto first_strand = [&](size_t task) {
        const size_t first = task * groups / tasks * kStrandsOfGroup;
        return first < c.strands ? first : c.strands;
    };
    auto task = [&](size_t t) {
        RopeStage now = stage;
        double* const scratch = c.scratch.data + t * of_task;
        bad[t] = UINT64_MAX;
        const size_t end = first_strand(t + 1);
        for (size_t first = first_strand(t); first < end; first += kStrandsInTurn)
            for (size_t s = 0; s < count; ++s) {
                Clock clock = c.clock;
                clock.advance(dt, s), now.time_before = clock.time();
                clock.advance(dt, 1), now.time_after = clock.time();
                const Surroundings around(c, c.rope.thickness, dt, now.time_after);
                size_t awake[kStrandsInTurn], several = 0;
                for (size_t strand = first; strand < end && strand < first + kStrandsInTurn; ++strand)
                    if (!sleeps(c, strand) || !goes_on_sleeping(c, sleeping_part(c, strand), around))
                        awake[several++] = strand;
                if (several == 0) continue;
                for (size_t i = 0; i < several && c.loads; ++i)
                    memset(c.loads.data + awake[i] * of_strand, 0, of_strand * sizeof(double));
                sort_by(ropes.taken, awake, several);
                const RopeResult result = c.kernels->rope_step(ropes, parameters, now, scratch, awake, several);
                results[t].add(result);
                if (!result.finite && s < bad[t]) bad[t] = s;
                for (size_t i = 0; i < several; ++i) {
                    if (can_break(c)) broken[t] += breaks(c, awake[i], result.error <= c.rope.tolerance);
                    if (may_sleep(c)) fall_asleep(c, sleeping_part(c, awake[i]), around);
                }
            }
    };
    parallel_for(c.parallel, tasks, task);
    uint64_t first_bad = UINT64_MAX;
    for (size_t t = 0; t < tasks; ++t) {
        if (bad[t] < first_bad) first_bad = bad[t];
        if (results[t].iterations > c.iterations) c.iterations = results[t].iterations;
        c.broken += broken[t];
        if (!(results[t].error <= c.residual)) c.residual = results[t].error;
        if (c.bad_answer.collider == SIZE_MAX) c.bad_answer = results[t].bad;
    }
    return first_bad;
}

} // namespace cd
