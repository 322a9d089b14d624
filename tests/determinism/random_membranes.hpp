// Random membranes, cloth among them, as random_bodies.hpp has chains.
#ifndef RANDOM_MEMBRANES_HPP
#define RANDOM_MEMBRANES_HPP

#include "random_bodies.hpp"

struct MembraneScene {
    using Handle = cd_membrane;
    static constexpr const char* name = "membrane";
    size_t columns, rows, components;
    cd_precision precision;
    double size;
    bool cloth; // now and then with springs that have no length

    explicit MembraneScene(Random& random) {
        const Lines lines(random);
        const bool turned = random.chance(0.5);
        columns = turned ? lines.count : lines.length, rows = turned ? lines.length : lines.count;
        components = columns * rows > 600 ? 1 : random.from_to(1, 4);
        cloth = columns > 1 && rows > 1 && columns * rows <= 1000 && random.chance(0.4);
        if (cloth) components = 3;
        precision = cd_precision(random.below(2));
        size = random_size(random, precision);
    }
    Handle* make() const {
        Handle* membrane = nullptr;
        cd_membrane_create(columns - 1, rows - 1, components, precision, nullptr, &membrane);
        return membrane;
    }
    size_t numbers() const { return rows * columns * components; }
    Size size_of(const Handle* membrane, cd_field field) const {
        int32_t u = 0, v = 0;
        cd_membrane_get_ring(membrane, &u, &v);
        switch (field) {
        case CD_STIFFNESS_U:
        case CD_REST_LENGTH_U:
        case CD_TENSION_U:
        case CD_STRAIN_U:
        case CD_BREAKING_STRAIN_U: return {rows, columns - 1 + size_t(u), 1};
        case CD_STIFFNESS_V:
        case CD_REST_LENGTH_V:
        case CD_TENSION_V:
        case CD_STRAIN_V:
        case CD_BREAKING_STRAIN_V: return {rows - 1 + size_t(v), columns, 1};
        default: return {rows, columns, field == CD_MASS || field == CD_PIN || field == CD_MASK ? 1 : components};
        }
    }
    cd_status write(Handle* membrane, cd_field field, size_t row, size_t n_rows, size_t column, size_t n_columns,
                    const std::vector<double>& values) const {
        return cd_membrane_write_f64(membrane, field, column, row, n_columns, n_rows, values.data(), values.size());
    }
    cd_status read(const Handle* membrane, cd_field field, std::vector<double>& out) const {
        const Size s = size_of(membrane, field);
        out.resize(s.rows * s.columns * s.components);
        return cd_membrane_read_f64(membrane, field, 0, 0, s.columns, s.rows, out.data(), out.size());
    }

    void begin(Handle* membrane, Random& random, size_t busy, Returned& returned) const {
        const double tolerance = random.decades(-12, -2), along_u = random.decades(-1, 3);
        returned += cd_membrane_set_tolerance(membrane, tolerance, random.from_to(1, 12));
        returned += cd_membrane_set_stiffness(membrane, along_u, random.decades(-1, 3));
        write_numbers(membrane, CD_POSITION, random, returned);
        write_numbers(membrane, CD_VELOCITY, random, returned);
        if (cloth) become_cloth(membrane, random, returned);
        else if (random.chance(0.3)) returned += cd_membrane_set_method(membrane, cd_method(random.below(4)));
        for (size_t k = random.below(busy); k > 0; --k) act(membrane, random, returned);
    }
    void write_numbers(Handle* membrane, cd_field field, Random& random, Returned& returned) const {
        write_part(*this, membrane, field, random, returned, [&] { return size * random.uniform(-1, 1); });
    }
    bool has_lengths(const Handle* membrane) const {
        double along_u = 0, along_v = 0;
        cd_membrane_get_rest_length(membrane, &along_u, &along_v);
        return along_u > 0;
    }
    void become_cloth(Handle* membrane, Random& random, Returned& returned) const;
    void may_tear(Handle* membrane, Random& random, Returned& returned) const;
    void act_on_cloth(Handle* membrane, Random& random, Returned& returned) const;
    void act(Handle* membrane, Random& random, Returned& returned) const;
    double pick_dt(const Handle* membrane, Random& random, Returned& returned) const {
        if (has_lengths(membrane)) return random.decades(-4, 1);
        return ChainScene::chain_or_membrane_dt(membrane, cd_membrane_get_method, cd_membrane_get_lambda,
                                                cd_membrane_stable_dt, random, returned);
    }
    void set_callbacks(Handle* membrane) const { set_callbacks_again<ClothThings>(membrane, components); }
    void measure(const Handle* membrane, Returned& returned) const {
        double k = 0, e = 0, g = 0, residual = 0;
        size_t iterations = 0, broken = 0;
        returned += cd_membrane_get_broken(membrane, &broken);
        returned += double(broken);
        returned += cd_membrane_get_energy(membrane, &k, &e, &g);
        returned += cd_membrane_get_convergence(membrane, &iterations, &residual);
        returned += k, returned += e, returned += g, returned += residual, returned += double(iterations);
        for (cd_field field = CD_TENSION_U; field <= CD_STRAIN_V && has_lengths(membrane); ++field) {
            std::vector<double> numbers;
            returned += read(membrane, field, numbers);
            for (double number : numbers) returned += number;
        }
        measure_loads<ClothThings>(membrane, returned);
    }
};

// Springs get lengths, and what cloth can't have is done away with.
inline void MembraneScene::become_cloth(Handle* membrane, Random& random, Returned& returned) const {
    const double along_u = size * random.decades(-1, 1), along_v = size * random.decades(-1, 1);
    const auto length = [](double wanted) { return wanted < 1e-60 ? 1e-60 : wanted; };
    returned += cd_membrane_set_method(membrane, CD_METHOD_IMPLICIT);
    returned += cd_membrane_set_stiffness_damping(membrane, 0);
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        cd_node kind = CD_NODE_FREE;
        cd_membrane_get_edge(membrane, edge, &kind);
        if (kind == CD_NODE_MATCHED) returned += cd_membrane_set_edge(membrane, edge, CD_NODE_FREE);
    }
    returned += cd_membrane_set_rest_length(membrane, length(along_u), length(along_v));
    returned += cd_membrane_set_lambda(membrane, random.any_of({0.5, 0.75, 1, 1}));
}

// Springs tear at some strain, all at the same or each at its own, or hold.
inline void MembraneScene::may_tear(Handle* membrane, Random& random, Returned& returned) const {
    const auto strain = [&] { return random.chance(0.2) ? double(INFINITY) : random.decades(-2, 1); };
    if (random.chance(0.5)) {
        returned += cd_membrane_set_breaking_strain(membrane, strain());
        return;
    }
    const cd_field field = random.chance(0.5) ? CD_BREAKING_STRAIN_U : CD_BREAKING_STRAIN_V;
    if (random.chance(0.3)) {
        returned += cd_membrane_disable_field(membrane, field);
        return;
    }
    returned += cd_membrane_enable_field(membrane, field);
    write_part(*this, membrane, field, random, returned, strain);
}

// What only cloth has.
inline void MembraneScene::act_on_cloth(Handle* membrane, Random& random, Returned& returned) const {
    switch (random.below(17)) {
    case 14: return may_tear(membrane, random, returned);
    case 0:
    case 1:
    case 2: return become_cloth(membrane, random, returned);
    case 3:
        if (random.chance(0.3)) returned += cd_membrane_set_rest_length(membrane, 0, 0);
        else returned += cd_membrane_disable_field(membrane, random.chance(0.5) ? CD_REST_LENGTH_U : CD_REST_LENGTH_V);
        break;
    case 4: returned += cd_membrane_set_shear(membrane, random.chance(0.3) ? 0 : random.decades(-1, 5)); break;
    case 5: returned += cd_membrane_set_compression(membrane, random.chance(0.3) ? 0 : random.decades(-1, 4)); break;
    case 6: {
        const size_t newton = random.from_to(1, 4);
        returned += cd_membrane_set_effort(membrane, newton, random.from_to(0, 25));
        break;
    }
    case 7: {
        const cd_field field = random.chance(0.5) ? CD_REST_LENGTH_U : CD_REST_LENGTH_V;
        const double each = size / double(field == CD_REST_LENGTH_U ? columns : rows);
        returned += cd_membrane_enable_field(membrane, field);
        return write_part(*this, membrane, field, random, returned, [&] {
            const double length = each * random.decades(-1, 1);
            return length < 1e-60 ? 1e-60 : length;
        });
    }
    case 8: {
        const double wind[3] = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
        const double across = random.decades(-3, 3), along = random.any_of({0, 0.1, 2}) * across;
        returned += cd_membrane_set_air(membrane, along, random.chance(0.2) ? 0 : across);
        returned += cd_membrane_set_wind(membrane, wind, components);
        break;
    }
    case 9:
        if (random.chance(0.3)) returned += cd_membrane_disable_field(membrane, CD_WIND);
        else returned += cd_membrane_enable_field(membrane, CD_WIND);
        return write_numbers(membrane, CD_WIND, random, returned);
    default: return meet_things<ClothThings>(membrane, components, size, random, returned);
    }
}

// One random change.
inline void MembraneScene::act(Handle* membrane, Random& random, Returned& returned) const {
    if (cloth && random.chance(0.5)) return act_on_cloth(membrane, random, returned);
    static const cd_field optional[] = {CD_FORCE, CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_TARGET, CD_PIN, CD_MASK};
    const cd_field field = optional[random.below(7)];
    double vector[4];
    for (double& x : vector) x = size * random.uniform(-1, 1);
    switch (random.below(22)) {
    case 20: returned += cd_membrane_teleport(membrane, Turn(random, components).rotation, vector, components); break;
    case 0: return write_numbers(membrane, CD_POSITION, random, returned);
    case 1: return write_numbers(membrane, CD_VELOCITY, random, returned);
    case 2: returned += cd_membrane_disable_field(membrane, field); break;
    case 3:
    case 4:
    case 5:
        returned += cd_membrane_enable_field(membrane, field);
        if (field == CD_FORCE || field == CD_TARGET) return write_numbers(membrane, field, random, returned);
        return write_part(*this, membrane, field, random, returned, [&] {
            if (field == CD_PIN) return random.chance(0.1) ? random.any_of({1, 2, CD_NODE_POSED}) : 0;
            if (field == CD_MASK) return double(random.chance(0.9));
            return field != CD_MASS && random.chance(0.1) ? 0 : random.decades(-2, 2);
        });
    case 6: returned += cd_membrane_set_mass(membrane, random.decades(-1, 1)); break;
    case 7: {
        const double along_u = random.chance(0.1) ? 0 : random.decades(-1, 4);
        returned += cd_membrane_set_stiffness(membrane, along_u, random.chance(0.1) ? 0 : random.decades(-1, 4));
        break;
    }
    case 8: returned += cd_membrane_set_bend(membrane, random.chance(0.5) ? 0 : random.decades(-5, -1)); break;
    case 9: returned += cd_membrane_set_drag(membrane, random.any_of({0, 0.1, 3})); break;
    case 10: returned += cd_membrane_set_stiffness_damping(membrane, random.any_of({0, 0.001, 0.1})); break;
    case 11: returned += cd_membrane_set_gravity(membrane, vector, components); break;
    case 12: {
        const int32_t along_u = int32_t(random.below(2));
        returned += cd_membrane_set_ring(membrane, along_u, int32_t(random.below(2)));
        break;
    }
    case 13:
    case 14: {
        const cd_edge edge = cd_edge(random.below(4));
        returned += cd_membrane_set_edge(membrane, edge, cd_node(random.below(5)));
        break;
    }
    case 15: returned += cd_membrane_set_mass_rule(membrane, cd_mass_rule(random.below(2))); break;
    case 16: returned += cd_membrane_set_method(membrane, cd_method(random.chance(0.5) ? 0 : random.below(4))); break;
    case 17: returned += cd_membrane_set_lambda(membrane, random.any_of({0.5, 0.5, 0.6, 0.75, 1, 0.3})); break;
    case 18: returned += cd_membrane_set_solver(membrane, cd_solver(random.below(3))); break;
    case 19: {
        const size_t u = random.below(columns), v = random.below(rows);
        const double stiffness = random.decades(-1, 3), damping = random.any_of({0, 1});
        returned += random.chance(0.3) ? cd_membrane_detach(membrane, u, v)
                                       : cd_membrane_attach(membrane, u, v, stiffness, damping, vector, components);
        break;
    }
    default:
        if (random.chance(0.5)) {
            returned += cd_membrane_set_pressure(membrane, random.chance(0.5) ? 0 : random.uniform(-1, 1));
        } else {
            const double u = random.uniform(0, double(columns - 1)), v = random.uniform(0, double(rows - 1));
            returned += cd_membrane_impulse(membrane, u, v, random.uniform(0, 5), vector, components);
        }
    }
}

#endif
