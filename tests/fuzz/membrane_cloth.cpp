// Membranes whose springs have a length: what must hold after each of their steps.
#include <math.h>

#include "membrane.hpp"
#include "random.hpp"

namespace fuzz {

bool Membrane::has_lengths() const {
    double along_u = 0, along_v = 0;
    cd_membrane_get_rest_length(first(), &along_u, &along_v);
    return along_u > 0;
}

bool Membrane::lacks_something() const {
    cd_method method = CD_METHOD_IMPLICIT;
    double lambda = 1, damping = 0;
    bool matched = false;
    cd_membrane_get_method(first(), &method);
    cd_membrane_get_lambda(first(), &lambda);
    cd_membrane_get_stiffness_damping(first(), &damping);
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        cd_node kind = CD_NODE_FREE;
        cd_membrane_get_edge(first(), edge, &kind);
        matched |= kind == CD_NODE_MATCHED;
    }
    return method != CD_METHOD_IMPLICIT || lambda < 0.5 || damping > 0 || matched;
}

// Or more: what the rules deal out is at most 4 times the mean.
Doubles Membrane::masses() const {
    double mass = 0;
    cd_membrane_get_mass(first(), &mass);
    const Doubles own = all_of(CD_MASS);
    if (!own.empty()) return own;
    cd_mass_rule rule = CD_MASS_EQUAL;
    cd_membrane_get_mass_rule(first(), &rule);
    const Rings ring = rings();
    const bool half = rule == CD_MASS_HALF_ENDS;
    const auto cells = [&](size_t springs, size_t closed) {
        return springs == 0 || closed || !half ? double(springs + 1) : double(springs);
    };
    const auto weight = [&](size_t i, size_t springs, size_t closed) {
        return half && springs > 0 && !closed && (i == 0 || i == springs) ? 0.5 : 1.0;
    };
    Doubles out;
    for (size_t v = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u)
            out.push_back(mass / (cells(nu, ring.u) * cells(nv, ring.v)) * weight(u, nu, ring.u) *
                          weight(v, nv, ring.v));
    return out;
}

// A contact pushes like a spring of 1e4 m / (lambda dt^2) that is as short as its node is deep.
Membrane::Energies Membrane::of_contacts() const {
    Energies out = {0, 0};
    const std::vector<Thing> all = things();
    if (all.empty() || !has_lengths()) return out;
    const Doubles x = all_of(CD_POSITION), pin = all_of(CD_PIN), mask = all_of(CD_MASK), mass = masses();
    double lambda = 1;
    cd_membrane_get_lambda(first(), &lambda);
    for (size_t i = 0; i < nodes; ++i) {
        const bool held = pin.empty() ? is_edge(i % (nu + 1), i / (nu + 1), CD_NODE_PINNED) : pin[i] != CD_NODE_FREE;
        if (held || (!mask.empty() && mask[i] == 0)) continue;
        for (const Thing& thing : all) {
            const double depth = depth_in(thing, &x[i * components]);
            const double stiffness = 1e4 * mass[i] / (lambda * step_before * step_before);
            if (depth > 0) out.sum += stiffness / 2 * depth * depth, out.stiffness += stiffness;
        }
    }
    return out;
}

bool Membrane::is_free() const {
    double drag = 0, along = 0, across = 0;
    cd_membrane_get_drag(first(), &drag);
    cd_membrane_get_air(first(), &along, &across);
    for (size_t v = 0, i = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u, ++i) {
            const Doubles pin = i == 0 ? all_of(CD_PIN) : Doubles();
            for (double kind : pin)
                if (kind != CD_NODE_FREE) return false;
            if (is_edge(u, v, CD_NODE_PINNED) || is_edge(u, v, CD_NODE_DRIVEN) || is_edge(u, v, CD_NODE_POSED))
                return false;
        }
    return drag + along + across == 0 && !is_driven() && all_of(CD_TARGET).empty() && things().empty();
}

// ---- what must hold ------------------------------------------------------------------------------------------------

void Membrane::before_step(double dt) {
    step_before = dt > 0 && dt < HUGE_VAL ? dt : 1;
    Body<MembraneApi>::before_step(dt);
    if (!has_lengths()) return;
    position_before = all_of(CD_POSITION);
    velocity_before = largest_of({CD_VELOCITY});
    cd_membrane_get_momentum(first(), momentum_before, components);
}

// What is stored rounded, of springs by what they pull.
double Membrane::room_for_energy(double dt) const {
    if (!has_lengths()) return Body<MembraneApi>::room_for_energy(dt);
    const bool wide = precision == CD_FLOAT64;
    const double x = largest_of({CD_POSITION, CD_TARGET}), v = largest_of({CD_VELOCITY}),
                 n = double(nodes * components);
    const double off = (wide ? 1e-15 : 1e-6) * x, smallest = wide ? 0x1p-500 : 0x1p-80;
    const double k = stiffest(), m = heaviest();
    double kinetic = 0, elastic = 0;
    cd_membrane_get_energy(first(), &kinetic, &elastic, nullptr);
    const double all = kinetic + fabs(elastic) + of_contacts().sum + n * m * gravity() * x;
    return (wide ? 1e-12 : 1e-5) * all + 4 * n * (sqrt(2 * k * all) + k * off) * off +
           4 * n * smallest * (8 * k * x + m * v + m * gravity() + smallest * (k + m));
}

// What contacts, the two parts of the springs against crumpling, and the air round to.
double Membrane::room_of_kind() const {
    if (!has_lengths()) return 0;
    const bool wide = precision == CD_FLOAT64;
    const double off = (wide ? 1e-15 : 1e-6) * largest_of({CD_POSITION});
    const Energies contacts = of_contacts();
    double place = 0;
    for (const Thing& thing : things())
        for (size_t c = 0; c < components; ++c) place = fmax(place, fabs(thing.first[c]) + fabs(thing.second[c]));
    const double far = off + 1e-15 * place, most = double(nodes) * 1e4 * heaviest();
    const double stiffness = things().empty() ? 0 : most / (step_before * step_before);
    return 4 * (sqrt(2 * stiffness * contacts.sum) * far + stiffness * far * far) +
           push_of_crumpling() * (off + 1e-13 * longest()) + 1e-15 * work_of_air();
}

// At most what the air takes in a step, of faces that may have been drawn out without end: what the iterations balance,
// and round, where it is large beside all energies.
double Membrane::work_of_air() const {
    double along = 0, across = 0;
    cd_membrane_get_air(first(), &along, &across);
    const double x = largest_of({CD_POSITION}), v = fmax(velocity_before, largest_of({CD_VELOCITY}));
    return step_before * (along + across) * double(nodes) * x * x * v * v;
}

double Membrane::longest() const {
    double length[2] = {};
    cd_membrane_get_rest_length(first(), &length[0], &length[1]);
    return fmax(length[0] + length[1], largest_of({CD_REST_LENGTH_U, CD_REST_LENGTH_V})) * double(nu + nv);
}

double Membrane::push_of_crumpling() const {
    double compression = 0;
    cd_membrane_get_compression(first(), &compression);
    return heaviest() * compression * double(nodes) * longest();
}

void Membrane::after_step(const Step& s) {
    if (has_lengths()) check_cloth(s);
    if (!run.broken) Body<MembraneApi>::after_step(s);
}

void Membrane::check_cloth(const Step& s) {
    if (s.count == 0 || s.status == CD_ERROR_VALUE || s.size_before == HUGE_VAL) return;
    if ((s.status == CD_ERROR_UNSUPPORTED) != lacks_something())
        return problem("cloth: a step gives %s, and something is lacking: %d", cd_status_name(s.status),
                       int(lacks_something()));
    if (s.status == CD_ERROR_TOLERANCE) return problem("cloth: ends short of a tolerance");
    if (s.status != CD_OK) return;
    size_t iterations[2] = {}, newton = 0, gradient = 0;
    double left[2] = {};
    cd_membrane_get_effort(first(), &newton, &gradient);
    cd_membrane_get_convergence(first(), &iterations[0], &left[0]);
    cd_membrane_get_convergence(twin(), &iterations[1], &left[1]);
    must_agree("iterations", &iterations[0], &iterations[1]);
    must_agree("left", &left[0], &left[1]);
    if (iterations[0] > (newton + 4) * (gradient > 0 ? gradient : 10000))
        return problem("cloth: %zu iterations, with an effort of %zu and %zu", iterations[0], newton, gradient);
    check_held();
    if (sleeps()) return;
    if (run.sane && past.moderate && !past.crafted && s.count == 1 && is_free() && !run.broken) check_momentum(s);
}

// What is pinned or absent stays where it is.
void Membrane::check_held() {
    const Doubles x = all_of(CD_POSITION), pin = all_of(CD_PIN), mask = all_of(CD_MASK);
    for (size_t i = 0; i < nodes && x.size() == position_before.size(); ++i) {
        const bool pinned =
            pin.empty() ? is_edge(i % (nu + 1), i / (nu + 1), CD_NODE_PINNED) : pin[i] == CD_NODE_PINNED;
        if (!pinned && (mask.empty() || mask[i] != 0)) continue;
        for (size_t c = i * components; c < (i + 1) * components; ++c)
            if (x[c] != position_before[c] && fabs(position_before[c]) > 1e-20)
                return problem("cloth: node %zu is held, but goes from %.17g to %.17g", i, position_before[c], x[c]);
    }
}

// Nothing but gravity works on a free sheet.
void Membrane::check_momentum(const Step& s) {
    double after[4] = {}, gravity[4] = {}, mass = 0;
    cd_membrane_get_momentum(first(), after, components);
    cd_membrane_get_gravity(first(), gravity, components);
    const Doubles all = masses(), mask = all_of(CD_MASK);
    for (size_t i = 0; i < nodes; ++i) mass += mask.empty() || mask[i] != 0 ? all[i] : 0;
    const double v = fmax(velocity_before, largest_of({CD_VELOCITY})), n = double(nodes);
    const bool wide = precision == CD_FLOAT64;
    const double rounding = wide ? 1e-11 : 1e-6, smallest = wide ? 0x1p-500 : 0x1p-80;
    for (size_t c = 0; c < components; ++c) {
        const double wanted = momentum_before[c] + mass * gravity[c] * s.dt;
        const double by_rounding = heaviest() * v + fabs(mass * gravity[c] * s.dt) + fabs(momentum_before[c]);
        const double room = n * (rounding * by_rounding + smallest * heaviest()) + 1e-14 * s.dt * push_of_crumpling();
        if (fabs(after[c] - wanted) > room)
            return problem("cloth: momentum from %.17g to %.17g, not %.17g, where rounding explains %g; dt %g",
                           momentum_before[c], after[c], wanted, room, s.dt);
    }
}

} // namespace fuzz
