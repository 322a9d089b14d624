// Chains whose springs have a length: what is done with them, and what must hold after each of their steps.
#include <math.h>

#include "chain.hpp"
#include "random.hpp"

namespace fuzz {

bool Chain::has_lengths() const {
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
    double lambda = 1, damping = 0;
    cd_chain_get_method(first(), &method);
    cd_chain_get_lambda(first(), &lambda);
    cd_chain_get_stiffness_damping(first(), &damping);
    return method != CD_METHOD_IMPLICIT || lambda < 0.5 || damping > 0 || is_ring() ||
           has_matched();
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

size_t Chain::cut_springs() const {
    size_t cut = 0;
    for (double k : all_of(CD_STIFFNESS)) cut += k == 0;
    return cut;
}

void Chain::before_step(double dt) {
    Body<ChainApi>::before_step(dt);
    step_before = dt;
    cut_before = cut_springs();
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

// At least what would stop the nodes within the step, in any wind, and what bent joints push by.
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
           stiffest_joint() * x + stiffest_tie() * (x + largest_of({CD_TARGET})) + largest_of({CD_FORCE}) +
           2 * (along + across) * longest() * blows + 1e-30;
}

// What the tolerance is worth: tension times length, and the energy of a spring that is wrong by so much; after 8
// or 16 iterations, which are Newton's, the interior point counts the force on the nodes for a smaller tension. A
// spring of fixed length that was too long, which holds no energy, comes back by the work of its tension, its nodes keep
// the speed at which it did, and attachments give way to it.
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
    double back = 0;
    for (double stretch : stretched) back += stretch;
    room += stiffest_tie() * double(nodes) * back * back;
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
    size_t broken = 0;
    cd_chain_get_broken(first(), &broken);
    if (cut_springs() != cut_before + broken)
        return problem("rope: %zu springs were cut and %zu broke, but %zu are cut", cut_before, broken, cut_springs());
    size_t iterations[2] = {}, most = 0;
    double error[2] = {}, tolerance = 0;
    cd_chain_get_tolerance(first(), &tolerance, &most);
    cd_chain_get_convergence(first(), &iterations[0], &error[0]);
    cd_chain_get_convergence(twin(), &iterations[1], &error[1]);
    must_agree("iterations", &iterations[0], &iterations[1]);
    must_agree("error", &error[0], &error[1]);
    if (run.broken || sleeps()) return;
    if ((s.status == CD_OK) != (error[0] <= tolerance) || error[0] < 0)
        return problem("rope: %s, with an error of %g and tolerance %g", cd_status_name(s.status), error[0], tolerance);
    if (iterations[0] < 1 || iterations[0] > 20 + most) return problem("rope: %zu iterations", iterations[0]);
    if (!run.sane || !past.moderate || past.crafted) return;
    if (s.status != CD_OK) return;
    for (const Thing& thing : things())
        if (has_hollows(thing)) return; // how far nodes come out of such counts for what tensions may be
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
    const double x = fmax(largest_of({CD_POSITION}), position_before);
    const double rounding = (precision == CD_FLOAT64 ? 1e-14 : 1e-6) * x;
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
            rounding * fabs(momentum_before[c]) + n * heaviest() * 1e-14 * position_before / s.dt; // what was too long
        if (fabs(after[c] - wanted) > room)
            return problem(
                "rope: momentum from %.17g to %.17g, not %.17g, where rounding explains %g; tolerance %g, "
                "%zu iterations and %zu at most, dt %g",
                momentum_before[c], after[c], wanted, room, tolerance, iterations, most, s.dt);
    }
}

} // namespace fuzz
