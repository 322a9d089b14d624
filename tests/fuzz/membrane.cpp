#include "membrane.hpp"

#include <math.h>

#include "random.hpp"

namespace fuzz {

static size_t pick_springs() { return chance(0.25) ? below(4) : chance(0.6) ? below(14) : below(40); }

Membrane::Membrane() {
    nu = pick_springs();
    nv = pick_springs();
    components = chance(0.4) ? 3 : 1 + below(4);
    nodes = (nu + 1) * (nv + 1);
    likes_lengths = nu > 0 && nv > 0 && components == 3 && chance(0.7);
    likes_things = likes_lengths && chance(0.5);
    precision = cd_precision(below(2));
    trace(text("membrane_create %zu x %zu springs, %zu components, precision %d", nu, nv, components, int(precision)));
    create();
}

cd_status Membrane::make(const cd_allocator* allocator, cd_membrane** out) {
    return cd_membrane_create(nu, nv, components, precision, allocator, out);
}

Membrane::Rings Membrane::rings() const {
    int32_t u = 0, v = 0;
    cd_membrane_get_ring(first(), &u, &v);
    return {size_t(u), size_t(v)};
}

bool Membrane::extent(cd_field field, Extent& out) const {
    switch (field) {
    case CD_POSITION:
    case CD_VELOCITY:
    case CD_FORCE:
    case CD_TARGET: out = {nv + 1, nu + 1, components}; return true;
    case CD_MASS:
    case CD_PIN:
    case CD_MASK: out = {nv + 1, nu + 1, 1}; return true;
    case CD_STIFFNESS_U: out = {nv + 1, nu + rings().u, 1}; return true;
    case CD_STIFFNESS_V: out = {nv + rings().v, nu + 1, 1}; return true;
    case CD_WIND: out = {nv + 1, nu + 1, components}; return has_lengths();
    case CD_REST_LENGTH_U:
    case CD_TENSION_U:
    case CD_STRAIN_U:
    case CD_BREAKING_STRAIN_U: out = {nv + 1, nu + rings().u, 1}; return has_lengths();
    case CD_REST_LENGTH_V:
    case CD_TENSION_V:
    case CD_STRAIN_V:
    case CD_BREAKING_STRAIN_V: out = {nv + rings().v, nu + 1, 1}; return has_lengths();
    default: return false;
    }
}

cd_status Membrane::view(cd_membrane* handle, cd_field field, View& out) const {
    return cd_membrane_view(handle, field, &out.data, &out.inner_stride, &out.outer_stride, &out.component_stride);
}

// ---- what must hold ------------------------------------------------------------------------------------------------

bool Membrane::is_edge(size_t u, size_t v, cd_node kind) const {
    const bool on[4] = {u == 0, u == nu, v == 0, v == nv};
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        cd_node set = CD_NODE_FREE;
        cd_membrane_get_edge(first(), edge, &set);
        if (on[edge] && set == kind) return true;
    }
    return false;
}

// Pinned and absent nodes rest, and time is finite.
void Membrane::check_state() {
    double time = 0;
    cd_membrane_get_time(first(), &time);
    if (!isfinite(time)) return problem("membrane: time %g", time);
    if (run.broken || !is_finite()) return;
    const Doubles pin = all_of(CD_PIN), mask = all_of(CD_MASK), velocity = all_of(CD_VELOCITY);
    for (size_t v = 0, node = 0; v <= nv; ++v)
        for (size_t u = 0; u <= nu; ++u, ++node) {
            const bool pinned = pin.empty() ? is_edge(u, v, CD_NODE_PINNED) : pin[node] == CD_NODE_PINNED;
            const bool absent = !mask.empty() && mask[node] == 0;
            for (size_t c = 0; c < components && (pinned || absent); ++c)
                if (velocity[node * components + c] != 0)
                    return problem("membrane: node (%zu, %zu) is %s and moves", u, v, pinned ? "pinned" : "absent");
        }
}

double Membrane::energy() const {
    double kinetic = 0, elastic = 0, gravity = 0;
    cd_membrane_get_energy(first(), &kinetic, &elastic, &gravity);
    return kinetic + elastic + gravity + of_contacts().sum;
}

double Membrane::stiffest() const {
    const double columns = double(nu + 2), rows = double(nv + 2);
    double along_u = 0, along_v = 0, bend = 0, tie = 0, shear = 0, compression = 0;
    cd_membrane_get_shear(first(), &shear);
    cd_membrane_get_compression(first(), &compression);
    cd_membrane_get_stiffness(first(), &along_u, &along_v);
    cd_membrane_get_bend(first(), &bend);
    double stretch = along_u * columns + along_v * rows;
    bend *= 64 * (columns * columns * columns + rows * rows * rows);
    for (cd_field field : {CD_STIFFNESS_U, CD_STIFFNESS_V})
        for (double k : all_of(field)) stretch = fmax(stretch, k);
    for (size_t v = 0; v <= nv && !all_of(CD_TARGET).empty(); ++v)
        for (size_t u = 0; u <= nu; ++u) {
            double stiffness = 0, damping;
            cd_membrane_get_attachment(first(), u, v, &stiffness, &damping);
            tie = fmax(tie, stiffness);
        }
    return stretch + bend + tie + shear + heaviest() * compression * (columns + rows);
}

double Membrane::heaviest() const {
    double mass = 0;
    cd_membrane_get_mass(first(), &mass);
    for (double m : all_of(CD_MASS)) mass = fmax(mass, m);
    return mass;
}

double Membrane::gravity() const {
    double gravity[4] = {}, most = 0;
    cd_membrane_get_gravity(first(), gravity, components);
    for (double g : gravity) most = fmax(most, fabs(g));
    return most;
}

bool Membrane::is_driven() const {
    double pressure = 0, wind[4] = {};
    cd_membrane_get_pressure(first(), &pressure);
    if (pressure != 0) return true;
    cd_membrane_get_wind(first(), wind, components);
    for (double v : wind)
        if (v != 0) return true;
    for (double v : all_of(CD_WIND))
        if (v != 0) return true;
    const std::vector<Thing> all = things();
    if (all.size() > 3) return true; // a node heeds no more at once
    for (const Thing& thing : all)
        if (moves(thing)) return true;
    for (double force : all_of(CD_FORCE))
        if (force != 0) return true;
    for (double pin : all_of(CD_PIN))
        if (pin == CD_NODE_DRIVEN || pin == CD_NODE_POSED) return true;
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        cd_node kind = CD_NODE_FREE;
        cd_membrane_get_edge(first(), edge, &kind);
        if (kind == CD_NODE_DRIVEN || kind == CD_NODE_POSED) return true;
    }
    return false;
}

// The alternating solver keeps another energy, which counts extra mass: see membrane.h.
bool Membrane::keeps_its_energy() const {
    cd_solver solver = CD_SOLVER_ALTERNATING;
    cd_membrane_get_solver(first(), &solver);
    return solver == CD_SOLVER_COUPLED || has_lengths();
}

// ---- setters -------------------------------------------------------------------------------------------------------

void Membrane::act_by_kind() {
    switch (below(has_lengths() || likes_lengths ? 62 : 33)) {
    case 0: set_number("set_mass", cd_membrane_set_mass, pick_number(-2, 3), {1e-3, 1e4}); break;
    case 1:
    case 2: set_stiffness(); break;
    case 3: set_number("set_bend", cd_membrane_set_bend, chance(0.4) ? 0 : pick_number(-6, 0), {0, 1e2}, 0); break;
    case 4:
        set_number("set_stiffness_damping", cd_membrane_set_stiffness_damping, chance(0.3) ? 0 : pick_number(-4, 0),
                   {0, 1e2});
        break;
    case 5:
    case 6: set_gravity(cd_membrane_set_gravity); break;
    case 7:
    case 8: set_edge(); break;
    case 9: set_ring(); break;
    case 10: set_enum("set_mass_rule", cd_membrane_set_mass_rule, 1, kNoMemory); break;
    case 11: impulse(); break;
    case 12:
    case 13: attach(); break;
    case 14: detach(); break;
    case 15:
    case 16: set_enum("set_solver", cd_membrane_set_solver, CD_SOLVER_AUTO); break;
    case 17: set_tolerance(); break;
    case 18:
        set_number("set_pressure", cd_membrane_set_pressure, chance(0.5) ? 0 : pick_number(-2, 2), {-1e3, 1e3}, 0);
        break;
    case 19: get_energy(cd_membrane_get_energy); break;
    case 20: get_momentum(cd_membrane_get_momentum); break;
    case 21: get_volume(); break;
    case 22: sample(); break;
    case 23: write_vertices(); break;
    case 24: write_indices(); break;
    case 25: get_convergence(); break;
    case 26: get_shape(); break;
    case 27: chance(0.4) ? get_edge() : chance(0.5) ? get_attachment() : get_reaction(); break;
    case 28: chance(0.5) ? teleport() : set_sleep(cd_membrane_set_sleep); break;
    case 29: get_of_cloth(); break;
    case 30: set_air(); break;
    case 31: chance(0.5) ? set_shear() : set_compression(); break;
    case 32: get_parameter(); break;
    case 33:
    case 34:
    case 35: set_rest_length(); break;
    case 36:
    case 37: set_shear(); break;
    case 38:
    case 39: set_compression(); break;
    case 40:
    case 41: set_effort(); break;
    case 42:
    case 43: set_air(); break;
    case 44: set_wind(); break;
    case 45: set_colliders(); break;
    case 46:
    case 47: set_plane(); break;
    case 48:
    case 49:
    case 50: set_capsule(); break;
    case 51: remove_collider(); break;
    case 52: set_collider_velocity(); break;
    case 53: chance(0.5) ? set_thickness() : set_loads(); break;
    case 54: chance(0.5) ? get_collider() : get_collider_load(); break;
    case 55:
    case 56: set_bed(); break;
    case 57: get_bed(); break;
    case 58:
    case 59: set_callback(); break;
    case 60: set_breaking_strain(); break;
    default: get_parameter();
    }
}

void Membrane::set_stiffness() {
    const double along_u = chance(0.2) ? 0 : pick_number(-2, 5), along_v = chance(0.2) ? 0 : pick_number(-2, 5);
    const cd_status status =
        both(text("set_stiffness %.17g %.17g", along_u, along_v), kNoMemory,
             [&](cd_membrane* membrane, int) { return cd_membrane_set_stiffness(membrane, along_u, along_v); });
    if (status == CD_OK && !(along_u < 1e7 && along_v < 1e7)) past.moderate = false;
}

void Membrane::set_edge() {
    const cd_edge edge = pick_enum(CD_EDGE_V_LAST);
    const cd_node kind = pick_enum(CD_NODE_POSED);
    both(text("set_edge %d %d", int(edge), int(kind)), 0,
         [&](cd_membrane* membrane, int) { return cd_membrane_set_edge(membrane, edge, kind); });
}

void Membrane::set_ring() {
    const int32_t u = pick_enum(1), v = pick_enum(1);
    both(text("set_ring %d %d", int(u), int(v)), 0,
         [&](cd_membrane* membrane, int) { return cd_membrane_set_ring(membrane, u, v); });
}

void Membrane::set_tolerance() {
    const double tolerance = chance(run.bad) ? wild_number() : decades(-13.9, -0.4);
    const size_t most = chance(run.bad) ? below(2) : 1 + below(100);
    both(text("set_tolerance %.17g %zu", tolerance, most), kNoMemory,
         [&](cd_membrane* membrane, int) { return cd_membrane_set_tolerance(membrane, tolerance, most); });
}

// ---- acting on it --------------------------------------------------------------------------------------------------

void Membrane::impulse() {
    const Impulse push = pick_impulse();
    const double u = pick_between(0, double(nu)), v = pick_between(0, double(nv)), radius = pick_between(0, 6);
    const cd_status status = both(
        text("impulse at %.17g %.17g, radius %.17g, %.17g.., count %zu", u, v, radius, push.size[0], push.count),
        kNoMemory,
        [&](cd_membrane* membrane, int) { return cd_membrane_impulse(membrane, u, v, radius, push.size, push.count); });
    if (status == CD_OK && !run.sane) past.moderate = false;
}

void Membrane::teleport() {
    const Move move = pick_move();
    const cd_status status = both(text("teleport by %.17g.., count %zu", move.offset[0], move.count), kNoMemory,
                                  [&](cd_membrane* membrane, int) {
                                      return cd_membrane_teleport(membrane, move.turn(), move.offset, move.count);
                                  });
    if (status == CD_OK && !(move.moderate && run.sane)) past.moderate = false;
}

void Membrane::attach() {
    const Tie tie = pick_tie();
    const size_t u = pick_index(nu + 1), v = pick_index(nv + 1);
    const cd_status status =
        both(text("attach (%zu, %zu), %.17g, %.17g%s", u, v, tie.stiffness, tie.damping, tie.null ? ", null" : ""), 0,
             [&](cd_membrane* membrane, int) {
                 return cd_membrane_attach(membrane, u, v, tie.stiffness, tie.damping, tie.at(), tie.count);
             });
    has_tied(tie, status);
}

void Membrane::detach() {
    const size_t u = pick_index(nu + 1), v = pick_index(nv + 1);
    both(text("detach (%zu, %zu)", u, v), 0,
         [&](cd_membrane* membrane, int) { return cd_membrane_detach(membrane, u, v); });
}

} // namespace fuzz
