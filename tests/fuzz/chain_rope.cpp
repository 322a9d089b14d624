// Chains whose springs have a length: what is done with them, and what must hold after each of their steps.
#include <math.h>

#include "chain.hpp"
#include "random.hpp"

namespace fuzz {

bool Chain::is_rope() const {
    double length = 0;
    cd_chain_get_rest_length(first(), &length);
    return length > 0;
}

size_t Chain::own_strands() const { return is_rope() ? strands : 1; }

bool Chain::has_matched() const {
    bool matched = false;
    for (double pin : all_of(CD_PIN)) matched |= pin == CD_NODE_MATCHED;
    return matched;
}

bool Chain::lacks_something() const {
    cd_method method = CD_METHOD_IMPLICIT;
    double lambda = 1, bend = 0, damping = 0;
    cd_chain_get_method(first(), &method);
    cd_chain_get_lambda(first(), &lambda);
    cd_chain_get_bend(first(), &bend);
    cd_chain_get_stiffness_damping(first(), &damping);
    return method != CD_METHOD_IMPLICIT || lambda < 0.5 || bend > 0 || !all_of(CD_BEND).empty() || damping > 0 ||
           is_ring() || has_matched();
}

Doubles Chain::lengths() const {
    double total = 0;
    cd_chain_get_rest_length(first(), &total);
    const Doubles own = all_of(CD_REST_LENGTH);
    return own.empty() ? Doubles(strands * springs_now(), total / double(springs_now())) : own;
}

Doubles Chain::stiffnesses() const {
    double total = 0;
    cd_chain_get_stiffness(first(), &total);
    const Doubles own = all_of(CD_STIFFNESS);
    return own.empty() ? Doubles(strands * springs_now(), total * double(springs_now())) : own;
}

Doubles Chain::lengths_now() const {
    const Doubles x = all_of(CD_POSITION);
    Doubles now;
    for (size_t strand = 0; strand < strands; ++strand)
        for (size_t i = 0; i < springs; ++i) {
            const double* const left = &x[(strand * (springs + 1) + i) * components];
            double square = 0;
            for (size_t c = 0; c < components; ++c) square += pow(left[components + c] - left[c], 2);
            now.push_back(sqrt(square));
        }
    return now;
}

bool Chain::is_free() const {
    double drag = 0;
    cd_chain_get_drag(first(), &drag);
    for (double pin : all_of(CD_PIN))
        if (pin != CD_NODE_FREE) return false;
    double along = 0, across = 0;
    cd_chain_get_air(first(), &along, &across);
    return drag + along + across == 0 && !is_driven() && all_of(CD_TARGET).empty() && things().empty();
}

std::vector<Chain::Thing> Chain::things() const {
    size_t count = 0;
    cd_chain_get_colliders(first(), &count);
    std::vector<Thing> all(count);
    for (size_t i = 0; i < count; ++i) {
        Thing& thing = all[i] = {};
        cd_chain_get_collider(first(), i, &thing.shape, thing.first, thing.second, thing.velocity, components,
                              &thing.radius, &thing.friction);
    }
    return all;
}

bool Chain::moves(const Thing& thing) {
    for (double v : thing.velocity)
        if (v != 0 && thing.shape != CD_SHAPE_NONE) return true;
    return false;
}

bool Chain::same(const Thing& a, const Thing& b) {
    bool same = a.shape == b.shape && a.radius == b.radius && a.friction == b.friction;
    for (size_t c = 0; c < 4; ++c)
        same &= a.first[c] == b.first[c] && a.second[c] == b.second[c] && a.velocity[c] == b.velocity[c];
    return same;
}

double Chain::depth_in(const Thing& thing, const double* x) const {
    double thickness = 0, along = 0, square = 0, away = 0;
    cd_chain_get_thickness(first(), &thickness);
    if (thing.shape == CD_SHAPE_NONE) return -HUGE_VAL;
    if (thing.shape == CD_SHAPE_PLANE) {
        for (size_t c = 0; c < components; ++c) away += (x[c] - thing.first[c]) * thing.second[c];
        return thickness - away;
    }
    for (size_t c = 0; c < components; ++c) {
        const double way = thing.second[c] - thing.first[c];
        along += way * (x[c] - thing.first[c]), square += way * way;
    }
    const double share = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    for (size_t c = 0; c < components; ++c)
        away += pow(x[c] - thing.first[c] - share * (thing.second[c] - thing.first[c]), 2);
    return thing.radius + thickness - sqrt(away);
}

double Chain::deepest(const std::vector<Thing>& of) const {
    if (of.empty() || !is_rope()) return 0;
    const Doubles x = all_of(CD_POSITION), pin = all_of(CD_PIN);
    double depth = 0;
    for (size_t i = 0; i < nodes; ++i)
        for (size_t k = 0; k < of.size() && pin[i] == CD_NODE_FREE; ++k)
            depth = fmax(depth, depth_in(of[k], &x[i * components]));
    return depth;
}

double Chain::longest() const {
    double most = 0;
    for (double length : lengths()) most = fmax(most, length);
    return most;
}

double Chain::room_for_depth(const std::vector<Thing>& of) const {
    double tolerance = 0, x = largest_of({CD_POSITION}), place = 0, thickness = 0;
    size_t most = 0;
    cd_chain_get_tolerance(first(), &tolerance, &most);
    cd_chain_get_thickness(first(), &thickness);
    for (const Thing& thing : of)
        for (size_t c = 0; c < components; ++c)
            place = fmax(place, fabs(thing.first[c]) + fabs(thing.second[c]) + thing.radius + thickness);
    return 1.001 * tolerance * longest() + (precision == CD_FLOAT64 ? 1e-14 : 1e-6) * x + 1e-14 * (x + place);
}

// ---- what must hold ------------------------------------------------------------------------------------------------

void Chain::before_step(double dt) {
    Body<ChainApi>::before_step(dt);
    step_before = dt;
    const std::vector<Thing> all = things();
    depth_before = deepest(all);
    began_inside = depth_before > room_for_depth(all);
    cd_chain_get_momentum(first(), momentum_before, components);
    velocity_before = largest_of({CD_VELOCITY});
    position_before = largest_of({CD_POSITION});
    stretched.clear();
    if (!is_rope() || is_ring()) return;
    const Doubles length = lengths(), k = stiffnesses(), now = lengths_now();
    int32_t push = 0;
    cd_chain_get_push(first(), &push);
    for (size_t i = 0; i < now.size(); ++i) {
        const double over = now[i] - length[i];
        stretched.push_back(isinf(k[i]) ? push ? fabs(over) : fmax(over, 0) : 0);
    }
}

// At least what would stop the nodes within the step, in any wind.
double Chain::force_on_nodes(double dt) const {
    const double x = fmax(largest_of({CD_POSITION}), position_before);
    const double v = fmax(largest_of({CD_VELOCITY}), velocity_before);
    double along = 0, across = 0, wind[4] = {}, blows = largest_of({CD_WIND});
    cd_chain_get_air(first(), &along, &across);
    cd_chain_get_wind(first(), wind, components);
    for (double u : wind) blows = fmax(blows, fabs(u));
    double push = depth_before / dt / dt, rough = 0;
    for (const Thing& thing : things()) {
        for (double u : thing.velocity) push += fabs(u) / dt;
        rough += thing.friction;
    }
    return (1 + rough) * heaviest() * (v / dt + gravity() + push) +
           stiffest_tie() * (x + largest_of({CD_TARGET})) + largest_of({CD_FORCE}) +
           2 * (along + across) * longest() * blows + 1e-30;
}

// What the tolerance is worth: tension times length, and the energy of a spring that is wrong by so much; after 8
// or 16 iterations, which are Newton's, the interior point counts the force on the nodes for a smaller tension. A
// spring of fixed length that was too long, which holds no energy, comes back by the work of its tension, and its nodes
// keep the speed at which it did.
double Chain::room_of_kind() const {
    if (!is_rope() || is_ring()) return 0;
    double tolerance = 0, room = 0;
    size_t most = 0, iterations = 0;
    cd_chain_get_tolerance(first(), &tolerance, &most);
    cd_chain_get_convergence(first(), &iterations, nullptr);
    const Doubles length = lengths(), k = stiffnesses(), tension = all_of(CD_TENSION);
    const double force = iterations > 8 ? force_on_nodes(step_before) : 0;
    if (depth_before > 0) // nodes come out of where they were within the tolerance
        room += 4 * double(nodes) * (force_on_nodes(step_before) + largest_of({CD_TENSION})) * depth_before;
    for (size_t i = 0; i < tension.size(); ++i) {
        const double wrong = tolerance * length[i];
        room += 4 * fmax(fabs(tension[i]), force) * wrong + fabs(tension[i]) * stretched[i];
        room += heaviest() * pow(stretched[i] / step_before, 2);
        if (!isinf(k[i])) room += k[i] * wrong * wrong;
    }
    return room;
}

void Chain::after_step(const Step& s) {
    ended_short = s.status == CD_ERROR_TOLERANCE;
    if (is_rope()) check_rope(s);
    else if (s.status == CD_ERROR_TOLERANCE) problem("chain: ends short of its tolerance, but has no lengths");
    if (!run.broken) Body<ChainApi>::after_step(s);
}

void Chain::check_rope(const Step& s) {
    if (s.count == 0 || s.status == CD_ERROR_VALUE || s.size_before == HUGE_VAL) return;
    if ((s.status == CD_ERROR_UNSUPPORTED) != lacks_something())
        return problem("rope: a step gives %s, and something is lacking: %d", cd_status_name(s.status),
                       int(lacks_something()));
    if (s.status != CD_OK && s.status != CD_ERROR_TOLERANCE) return;
    size_t iterations[2] = {}, most = 0;
    double error[2] = {}, tolerance = 0;
    cd_chain_get_tolerance(first(), &tolerance, &most);
    cd_chain_get_convergence(first(), &iterations[0], &error[0]);
    cd_chain_get_convergence(twin(), &iterations[1], &error[1]);
    must_agree("iterations", &iterations[0], &iterations[1]);
    must_agree("error", &error[0], &error[1]);
    if (run.broken) return;
    if ((s.status == CD_OK) != (error[0] <= tolerance) || error[0] < 0)
        return problem("rope: %s, with an error of %g and tolerance %g", cd_status_name(s.status), error[0], tolerance);
    if (iterations[0] < 1 || iterations[0] > 20 + most) return problem("rope: %zu iterations", iterations[0]);
    if (!run.sane || !past.moderate || past.crafted) return;
    if (s.status != CD_OK) return;
    check_lengths(tolerance, s.dt);
    if (!run.broken) check_depth(s);
    if (s.count == 1 && is_free() && !run.broken) check_momentum(s);
}

// Springs are as long as their tensions make them: those that are slack, at most. A tension that is small beside the
// forces that would stop the nodes within the step may be there all the same.
void Chain::check_lengths(double tolerance, double dt) {
    const Doubles length = lengths(), k = stiffnesses(), tension = all_of(CD_TENSION), now = lengths_now();
    const Doubles pin = all_of(CD_PIN);
    const auto is_held = [](double kind) { return kind != CD_NODE_FREE; };
    int32_t push = 0;
    size_t iterations = 0, most = 0;
    cd_chain_get_push(first(), &push);
    cd_chain_get_convergence(first(), &iterations, nullptr);
    cd_chain_get_tolerance(first(), &tolerance, &most);
    const double x = largest_of({CD_POSITION}), rounding = (precision == CD_FLOAT64 ? 1e-14 : 1e-6) * x;
    const double force = force_on_nodes(dt) + largest_of({CD_TENSION});
    for (size_t i = 0; i < now.size(); ++i) {
        const size_t node = i + i / springs;
        if (!(tension[i] >= 0) && !push) return problem("rope: tension %g, but it does not push", tension[i]);
        if (k[i] == 0 && tension[i] != 0) return problem("rope: a cut spring has the tension %g", tension[i]);
        if (k[i] == 0 || (is_held(pin[node]) && is_held(pin[node + 1]))) continue; // nothing moves by it
        const double give = tension[i] / k[i], over = now[i] - length[i] - give;
        const double room = 1.001 * tolerance * length[i] + rounding + 1e-12 * (length[i] + fabs(give));
        const bool taut = push || tension[i] * -over > 4 * double(springs) * tolerance * force * length[i];
        if (over > room || (taut && over < -room))
            return problem(
                "rope: spring %zu of strand %zu is %.17g long, of length %g and with tension %g over %g: "
                "wrong by %g, where %g would do; tension at most %g; tolerance %g, %zu iterations and %zu at most, dt "
                "%g",
                i % springs, i / springs, now[i], length[i], tension[i], k[i], over, room, largest_of({CD_TENSION}),
                tolerance, iterations, most, dt);
    }
}

// Nodes that may move lie outside of all colliders, but for what the tolerance and rounding leave.
void Chain::check_depth(const Step& s) {
    const std::vector<Thing> all = things();
    const double depth = deepest(all), room = room_for_depth(all);
    double tolerance = 0;
    size_t most = 0, iterations = 0;
    cd_chain_get_convergence(first(), &iterations, nullptr);
    cd_chain_get_tolerance(first(), &tolerance, &most);
    if (depth > room)
        problem(
            "rope: a node ends %g deep in a collider, where %g would do, and began %g deep at most; %zu colliders, "
            "tolerance %g, %zu iterations and %zu at most, dt %g, %zu steps",
            depth, room, depth_before, all.size(), tolerance, iterations, most, s.dt, s.count);
}

// Nothing but gravity works on a free rope.
void Chain::check_momentum(const Step& s) {
    double after[4] = {}, gravity[4] = {}, mass = 0, total = 0;
    cd_chain_get_momentum(first(), after, components);
    cd_chain_get_gravity(first(), gravity, components);
    cd_chain_get_mass(first(), &total);
    const Doubles masses = all_of(CD_MASS);
    if (masses.empty()) mass = total * double(strands);
    for (double m : masses) mass += m;
    double pull = 0, tolerance = 0;
    size_t iterations = 0, most = 0;
    cd_chain_get_convergence(first(), &iterations, nullptr);
    cd_chain_get_tolerance(first(), &tolerance, &most);
    for (double t : all_of(CD_TENSION)) pull = fmax(pull, fabs(t));
    const double v = largest_of({CD_VELOCITY}), n = double(nodes);
    const bool wide = precision == CD_FLOAT64;
    const double rounding = wide ? 1e-12 : 1e-6, smallest = wide ? 0x1p-500 : 0x1p-80;
    for (size_t c = 0; c < components; ++c) {
        const double wanted = momentum_before[c] + mass * gravity[c] * s.dt;
        const double room =
            n * (rounding * (heaviest() * v + fabs(mass * gravity[c] * s.dt) + pull * s.dt) + smallest * heaviest()) +
            rounding * fabs(momentum_before[c]);
        if (fabs(after[c] - wanted) > room)
            return problem(
                "rope: momentum from %.17g to %.17g, not %.17g, where rounding explains %g; tolerance %g, "
                "%zu iterations and %zu at most, dt %g",
                momentum_before[c], after[c], wanted, room, tolerance, iterations, most, s.dt);
    }
}

// ---- calls ---------------------------------------------------------------------------------------------------------

void Chain::act() {
    if (is_rope() && lacks_something() && chance(0.4)) return get_ready();
    if (likes_lengths && !is_rope() && chance(0.1)) return set_rest_length();
    if (likes_things && is_rope() && chance(0.12)) {
        if (things().empty()) return set_colliders();
        return chance(0.4) ? set_plane() : set_capsule();
    }
    Body<ChainApi>::act();
}

void Chain::get_ready() {
    const double lambda = chance(0.5) ? 0.5 : chance(0.5) ? 1 : 0.75;
    both("set_method 0", 0, [&](cd_chain* chain, int) { return cd_chain_set_method(chain, CD_METHOD_IMPLICIT); });
    both(text("set_lambda %g", lambda), kNoMemory,
         [&](cd_chain* chain, int) { return cd_chain_set_lambda(chain, lambda); });
    both("set_bend 0", 0, [&](cd_chain* chain, int) { return cd_chain_set_bend(chain, 0); });
    both("disable_field 5", 0, [&](cd_chain* chain, int) { return cd_chain_disable_field(chain, CD_BEND); });
    both("set_stiffness_damping 0", kNoMemory,
         [&](cd_chain* chain, int) { return cd_chain_set_stiffness_damping(chain, 0); });
    both("set_ring 0", 0, [&](cd_chain* chain, int) { return cd_chain_set_ring(chain, 0); });
    for (cd_end end = CD_END_FIRST; end <= CD_END_LAST && has_matched(); ++end)
        both(text("set_end %d 0", int(end)), kNoMemory,
             [&](cd_chain* chain, int) { return cd_chain_set_end(chain, end, CD_NODE_FREE); });
}

void Chain::set_rest_length() {
    static const double hostile[] = {1e-60, 1e60, 9e-61, 1.1e60, -0.0, 5e-324};
    const double length = chance(0.15)               ? 0
                          : !run.sane && chance(0.1) ? hostile[below(6)]
                          : chance(0.05)             ? pick_number(-60, 60)
                                                     : pick_number(-2, 2);
    const bool was_rope = is_rope();
    set_number("set_rest_length", cd_chain_set_rest_length, length, {length == 0 ? 0 : 1e-3, 1e3}, 0);
    if (!run.broken && is_rope() && (components > 3 || springs == 0)) problem("rope: it can't be one");
    Doubles tension;
    const bool has_tension = on_part<ChainApi>(cd_chain_read_f64, first(), CD_TENSION, {0, strands, 0, 0, 0},
                                               static_cast<double*>(nullptr)) == CD_OK;
    if (!run.broken && has_tension != is_rope()) problem("rope: has a tension: %d", int(has_tension));
    if (!was_rope && is_rope())
        for (double t : all_of(CD_TENSION))
            if (t != 0) return problem("rope: begins with a tension of %g", t);
}

void Chain::set_tolerance() {
    const double tolerance = chance(run.bad) ? wild_number() : chance(0.1) ? 0.5 : decades(-13.9, -0.4);
    const size_t most = chance(run.bad) ? below(2) : 1 + below(chance(0.3) ? 3 : 300);
    both(text("set_tolerance %.17g %zu", tolerance, most), kNoMemory,
         [&](cd_chain* chain, int) { return cd_chain_set_tolerance(chain, tolerance, most); });
}

void Chain::get_tolerance() {
    double tolerance[2] = {};
    size_t most[2] = {};
    const bool null = pick_null();
    both("get_tolerance", kReads, [&](cd_chain* chain, int which) {
        return cd_chain_get_tolerance(chain, &tolerance[which], null ? nullptr : &most[which]);
    });
    must_agree("get_tolerance", &tolerance[0], &tolerance[1]);
    must_agree("get_tolerance", &most[0], &most[1]);
}

void Chain::set_air() {
    const double along = chance(0.4) ? 0 : pick_number(-3, 3), across = chance(0.2) ? 0 : pick_number(-3, 3);
    const cd_status status = both(text("set_air %.17g %.17g", along, across), 0,
                                  [&](cd_chain* chain, int) { return cd_chain_set_air(chain, along, across); });
    if (status == CD_OK && !(along < 1e6 && across < 1e6)) past.moderate = false;
    if (status == CD_OK && !is_rope()) problem("set_air: no rope, but it is taken");
}

void Chain::get_air() {
    double air[2][2] = {}, wind[2][4] = {};
    both("get_air", kReads,
         [&](cd_chain* chain, int which) { return cd_chain_get_air(chain, &air[which][0], &air[which][1]); });
    must_agree("get_air", air[0], air[1], 2);
    const size_t count = pick_count(components);
    both("get_wind", kReads, [&](cd_chain* chain, int which) { return cd_chain_get_wind(chain, wind[which], count); });
    must_agree("get_wind", wind[0], wind[1], 4);
}

void Chain::set_wind() {
    double wind[4];
    bool moderate = true;
    for (double& v : wind) {
        v = chance(0.5) ? 0 : pick_number(-1, 1.5);
        moderate &= fabs(v) < 1e3;
    }
    const size_t count = pick_count(components);
    const bool null = pick_null();
    const cd_status status =
        both(text("set_wind %.17g %.17g %.17g, count %zu%s", wind[0], wind[1], wind[2], count, null ? ", null" : ""),
             kNoMemory, [&](cd_chain* chain, int) { return cd_chain_set_wind(chain, null ? nullptr : wind, count); });
    if (status == CD_OK && !moderate) past.moderate = false;
}

void Chain::set_strength() {
    const double strength = chance(0.4) ? double(INFINITY) : pick_number(-2, 5);
    const cd_status status = both(text("set_strength %.17g", strength), 0,
                                  [&](cd_chain* chain, int) { return cd_chain_set_strength(chain, strength); });
    if (status == CD_OK && !is_rope()) problem("set_strength: no rope, but it is taken");
    if (status == CD_OK && strength < HUGE_VAL && all_of(CD_STIFFNESS).empty())
        problem("set_strength: springs may break, but have no stiffness of their own");
}

void Chain::set_colliders() {
    const size_t count = pick_index(5);
    size_t before = 0, after = 0;
    cd_chain_get_colliders(first(), &before);
    const std::vector<Thing> was = things();
    const cd_status status = both(text("set_colliders %zu", count), 0,
                                  [&](cd_chain* chain, int) { return cd_chain_set_colliders(chain, count); });
    cd_chain_get_colliders(first(), &after);
    if (status == CD_OK && !is_rope()) return problem("set_colliders: no rope, but it is taken");
    if (after != (status == CD_OK ? count : before)) return problem("set_colliders: %zu, not %zu", after, count);
    const std::vector<Thing> now = things();
    for (size_t i = 0; i < now.size(); ++i) {
        if (!same(now[i], i < was.size() ? was[i] : Thing())) return problem("set_colliders: another collider %zu", i);
    }
}

// Of the colliders there are, and sometimes of none.
size_t Chain::pick_collider() const {
    size_t count = 0;
    cd_chain_get_colliders(first(), &count);
    return count == 0 ? 0 : pick_index(count);
}

Chain::Place Chain::pick_place(double size) const {
    Place place = {{}, true, pick_count(components)};
    for (double& x : place.at) {
        const bool wild = chance(run.bad * 0.5) || (!run.sane && chance(0.05));
        x = wild ? wild_number() : chance(0.1) ? 0 : uniform(-size, size);
        place.moderate &= fabs(x) < 1e3;
    }
    return place;
}

void Chain::set_plane() {
    const size_t index = pick_collider();
    const Place point = pick_place(decades(-2, 1)), normal = pick_place(1);
    const double friction = chance(0.3) ? 0 : pick_number(-2, 1);
    const bool null[2] = {pick_null(), pick_null()};
    const size_t count = point.count;
    const cd_status status =
        both(text("set_plane %zu, %.17g %.17g %.17g, %.17g %.17g %.17g, count %zu, %.17g%s", index, point.at[0],
                  point.at[1], point.at[2], normal.at[0], normal.at[1], normal.at[2], count, friction,
                  null[0] || null[1] ? ", null" : ""),
             kNoMemory, [&](cd_chain* chain, int) {
                 return cd_chain_set_plane(chain, index, null[0] ? nullptr : point.at, null[1] ? nullptr : normal.at,
                                           count, friction);
             });
    if (status == CD_OK && !(point.moderate && friction < 1e3)) past.moderate = false;
    if (status != CD_OK || run.broken) return;
    const Thing now = things()[index];
    double square = 0;
    for (double n : now.second) square += n * n;
    if (now.shape != CD_SHAPE_PLANE) problem("set_plane: collider %zu is none", index);
    else if (!(fabs(square - 1) < 1e-14)) problem("set_plane: a normal %g long", sqrt(square));
}

void Chain::set_capsule() {
    const size_t index = pick_collider();
    const double size = decades(-2, 1), radius = pick_number(-2, 0.5), friction = chance(0.3) ? 0 : pick_number(-2, 1);
    const Place first_end = pick_place(size), last_end = chance(0.3) ? first_end : pick_place(size);
    const bool null[2] = {pick_null(), pick_null()};
    const size_t count = first_end.count;
    const cd_status status =
        both(text("set_capsule %zu, %.17g %.17g %.17g, %.17g %.17g %.17g, count %zu, %.17g, %.17g%s", index,
                  first_end.at[0], first_end.at[1], first_end.at[2], last_end.at[0], last_end.at[1], last_end.at[2],
                  count, radius, friction, null[0] || null[1] ? ", null" : ""),
             kNoMemory, [&](cd_chain* chain, int) {
                 return cd_chain_set_capsule(chain, index, null[0] ? nullptr : first_end.at,
                                             null[1] ? nullptr : last_end.at, count, radius, friction);
             });
    const bool moderate = first_end.moderate && last_end.moderate && radius > 1e-3 && radius < 1e3 && friction < 1e3;
    if (status == CD_OK && !moderate) past.moderate = false;
    if (status == CD_OK && !run.broken && things()[index].shape != CD_SHAPE_CAPSULE)
        problem("set_capsule: collider %zu is none", index);
}

void Chain::remove_collider() {
    const size_t index = pick_collider();
    const cd_status status = both(text("remove_collider %zu", index), kNoMemory, [&](cd_chain* chain, int) {
        return cd_chain_remove_collider(chain, index);
    });
    if (status != CD_OK || run.broken) return;
    if (!same(things()[index], Thing())) problem("remove_collider: collider %zu is still something", index);
}

void Chain::set_collider_velocity() {
    const size_t index = pick_collider();
    const Place velocity = pick_place(chance(0.2) ? 0 : decades(-2, 1));
    const bool null = pick_null();
    const cd_status status =
        both(text("set_collider_velocity %zu, %.17g %.17g %.17g, count %zu%s", index, velocity.at[0], velocity.at[1],
                  velocity.at[2], velocity.count, null ? ", null" : ""),
             kNoMemory, [&](cd_chain* chain, int) {
                 return cd_chain_set_collider_velocity(chain, index, null ? nullptr : velocity.at, velocity.count);
             });
    if (status == CD_OK && !velocity.moderate) past.moderate = false;
}

void Chain::set_thickness() {
    const double radius = chance(0.3) ? 0 : pick_number(-4, 0);
    const cd_status status = both(text("set_thickness %.17g", radius), kNoMemory,
                                  [&](cd_chain* chain, int) { return cd_chain_set_thickness(chain, radius); });
    if (status == CD_OK && !is_rope()) problem("set_thickness: no rope, but it is taken");
    if (status == CD_OK && !(radius < 1e3)) past.moderate = false;
}

void Chain::get_collider() {
    const size_t index = pick_collider(), count = pick_count(components);
    Thing told[2] = {};
    const bool some = chance(0.2);
    const auto get = [&](cd_chain* chain, int which) {
        Thing& out = told[which];
        return cd_chain_get_collider(chain, index, some ? nullptr : &out.shape, some ? nullptr : out.first, out.second,
                                     some ? nullptr : out.velocity, count, &out.radius, some ? nullptr : &out.friction);
    };
    const cd_status status = both(text("get_collider %zu, count %zu", index, count), kReads, get);
    must_agree("get_collider", &told[0].shape, &told[1].shape);
    must_agree("get_collider", told[0].first, told[1].first, 4);
    must_agree("get_collider", told[0].second, told[1].second, 4);
    must_agree("get_collider", told[0].velocity, told[1].velocity, 4);
    must_agree("get_collider", &told[0].radius, &told[1].radius);
    must_agree("get_collider", &told[0].friction, &told[1].friction);
    size_t all = 0;
    cd_chain_get_colliders(first(), &all);
    if ((status == CD_OK) != (index < all && count == components))
        problem("get_collider: %s of collider %zu of %zu, count %zu", cd_status_name(status), index, all, count);
}

void Chain::get_reaction() {
    const size_t strand = pick_index(strands), node = pick_index(springs + 1), count = pick_count(components);
    double force[2][4] = {};
    const cd_status status = both("get_reaction", kReads, [&](cd_chain* chain, int which) {
        return cd_chain_get_reaction(chain, strand, node, force[which], count);
    });
    must_agree("get_reaction", force[0], force[1], 4);
    double most = 0;
    for (double t : all_of(CD_TENSION)) most += fabs(t);
    for (double f : force[0])
        if (status == CD_OK && past.moderate && !past.crafted && is_finite() && !(fabs(f) <= 1.01 * most))
            problem("get_reaction tells %g, tensions are %g together", f, most);
}

// The twin may be a copy that has not stepped yet: they need not agree.
void Chain::get_convergence() {
    size_t iterations = 0;
    double error = 0;
    const bool only_one = chance(0.1);
    both("get_convergence", kReads, [&](cd_chain* chain, int) {
        return cd_chain_get_convergence(chain, only_one ? nullptr : &iterations, &error);
    });
    if (!(error >= 0) && !past.diverged && !past.crafted && past.moderate)
        problem("get_convergence tells an error of %g", error);
}

} // namespace fuzz
