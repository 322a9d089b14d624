// Random waters, and what is done with them while they run: see random_bodies.hpp. For test_random.cpp.
#ifndef RANDOM_WATER_HPP
#define RANDOM_WATER_HPP

#include "random_bodies.hpp"

struct WaterScene {
    using Handle = cd_water;
    static constexpr const char* name = "water";
    size_t columns, rows;
    cd_precision precision;
    double dx, dy, depth; // a usual depth

    explicit WaterScene(Random& random) {
        const Lines lines(random);
        const bool turned = random.chance(0.5);
        columns = turned ? lines.count : lines.length, rows = turned ? lines.length : lines.count;
        precision = random.chance(0.6) ? CD_FLOAT32 : CD_FLOAT64;
        dx = random.decades(-1, 1), dy = random.chance(0.5) ? dx : random.decades(-1, 1);
        depth = random_size(random, precision) * random.decades(-1, 1);
    }
    Handle* make() const {
        Handle* water = nullptr;
        cd_water_create(columns, rows, dx, dy, precision, nullptr, &water);
        return water;
    }
    size_t numbers() const { return rows * columns; }
    Size size_of(const Handle*, cd_field field) const {
        const bool x_faces = field == CD_VELOCITY_X || field == CD_FORCE_X || field == CD_WALL_X;
        const bool y_faces = field == CD_VELOCITY_Y || field == CD_FORCE_Y || field == CD_WALL_Y;
        return {rows + y_faces, columns + x_faces, 1};
    }
    cd_status write(Handle* water, cd_field field, size_t row, size_t n_rows, size_t column, size_t n_columns,
                    const std::vector<double>& values) const {
        return cd_water_write_f64(water, field, column, row, n_columns, n_rows, values.data(), values.size());
    }
    cd_status read(const Handle* water, cd_field field, std::vector<double>& out) const {
        const Size s = size_of(water, field);
        out.resize(s.rows * s.columns);
        return cd_water_read_f64(water, field, 0, 0, s.columns, s.rows, out.data(), out.size());
    }

    void begin(Handle* water, Random& random, size_t busy, Returned& returned) const {
        write_bed(water, random, returned);
        write_depth(water, random, returned);
        if (random.chance(0.5)) returned += cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED);
        if (random.chance(0.3)) returned += cd_water_set_method(water, cd_method(random.any_of({1, 2, 2})));
        for (size_t k = random.below(busy); k > 0; --k) act(water, random, returned);
    }
    // Flat, or rough enough for islands and shores.
    void write_bed(Handle* water, Random& random, Returned& returned) const {
        const double roughness = depth * random.any_of({0, 0.01, 1, 3});
        write_part(*this, water, CD_BED, random, returned, [&] { return roughness * random.uniform(-1, 1); });
    }
    // Even, waved, or with dry places.
    void write_depth(Handle* water, Random& random, Returned& returned) const {
        const double waves = random.any_of({0, 0.01, 0.5, 1}), dry = random.any_of({0, 0, 0.3, 0.9});
        const cd_field field = random.chance(0.7) ? CD_DEPTH : CD_SURFACE;
        write_part(*this, water, field, random, returned,
                   [&] { return random.chance(dry) ? 0 : depth * (1 + waves * random.uniform(-1, 1)); });
    }
    void act(Handle* water, Random& random, Returned& returned) const;
    void act_on_a_place(Handle* water, Random& random, Returned& returned) const;
    void float_hulls(Handle* water, Random& random, Returned& returned) const;
    void write_optional(Handle* water, cd_field field, Random& random, Returned& returned) const;

    // Implicit steps in which waves cross from a hundredth of a cell to thousands of them; steps of which some may grow
    // only where they are short.
    double pick_dt(const Handle* water, Random& random, Returned& returned) const {
        cd_method method = CD_METHOD_IMPLICIT;
        double lambda = 0, stable = 0;
        cd_water_get_method(water, &method);
        cd_water_get_lambda(water, &lambda);
        returned += cd_water_stable_dt(water, &stable);
        returned += stable;
        if (!(stable < 100)) stable = 100;
        const double share = random.decades(-2.5, 0), crossed = random.decades(-2, 3.5);
        if (method == CD_METHOD_FORWARD_EULER) return 0.1 * share * stable;
        if (method == CD_METHOD_SYMPLECTIC_EULER || lambda < 0.5) return share * stable;
        return fmin(1e20, crossed * fmin(dx, dy) / sqrt(9.81 * depth));
    }
    void set_callbacks(Handle*) const {}
    void measure(const Handle* water, Returned& returned) const {
        double out[7] = {};
        uint64_t cells = 0;
        returned += cd_water_get_energy(water, &out[0], &out[1]);
        returned += cd_water_get_account(water, nullptr, &out[2], &out[3], &out[4]);
        returned += cd_water_get_limited(water, &cells, &out[5]);
        returned += cd_water_get_wet_area(water, &out[6]);
        for (double number : out) returned += number;
        returned += double(cells);
    }
};

inline void WaterScene::write_optional(Handle* water, cd_field field, Random& random, Returned& returned) const {
    const double head = 9.81 * depth;
    returned += cd_water_enable_field(water, field);
    write_part(*this, water, field, random, returned, [&] {
        switch (field) {
        case CD_MASK: return double(random.chance(0.9));
        case CD_WALL_X:
        case CD_WALL_Y: return double(random.chance(0.1));
        case CD_SOURCE: return 0.1 * depth * random.uniform(-1, 1);
        case CD_PRESSURE: return 100 * head * random.uniform(-1, 1);
        default: return 0.1 * head / dx * random.uniform(-1, 1);
        }
    });
}

inline void WaterScene::act_on_a_place(Handle* water, Random& random, Returned& returned) const {
    const double length_x = double(columns) * dx, length_y = double(rows) * dy;
    const double x = random.uniform(0, length_x), y = random.uniform(0, length_y);
    const double radius = random.uniform(0, 0.5) * fmin(length_x, length_y);
    const double amount = random.uniform(-0.5, 1) * depth * dx * dy, push = 1000 * amount;
    double added = 0;
    switch (random.below(5)) {
    case 0: returned += cd_water_add_volume(water, x, y, radius, amount, &added); break;
    case 1: returned += cd_water_add_volume_rectangle(water, columns / 2, 0, 1, rows, amount, &added); break;
    case 2: returned += cd_water_add_source(water, x, y, radius, amount); break;
    case 3: returned += cd_water_splash(water, x, y, radius, 0.3 * depth); break;
    default: returned += cd_water_impulse(water, x, y, radius, push, -push);
    }
    returned += added;
}

inline void WaterScene::float_hulls(Handle* water, Random& random, Returned& returned) const {
    size_t count = 0;
    cd_water_get_hulls(water, &count, nullptr, nullptr);
    if (count == 0 || random.chance(0.2)) count = random.below(3), returned += cd_water_set_hulls(water, count, 3, 2);
    if (count == 0) return;
    const size_t index = random.below(count);
    const double length_x = double(columns) * dx, length_y = double(rows) * dy;
    const double length = fmin(length_x, length_y) * random.uniform(0.1, 0.6), width = length * random.uniform(0.2, 1);
    const double mass = 1000 * length * width * depth * random.decades(-3, 0);
    double out[7] = {};
    returned += cd_water_set_hull(water, index, mass, length, width, nullptr, 0);
    returned += cd_water_set_hull_drag(water, index, mass * random.uniform(0, 1), mass, 0.3);
    returned += cd_water_launch_hull(water, index, random.uniform(0, length_x), random.uniform(0, length_y), 1,
                                     random.uniform(-1, 1));
    const double force[6] = {mass * random.uniform(-1, 1), 0, 0, 0, 0, 0};
    returned += cd_water_set_hull_force(water, index, force, 6);
    returned += cd_water_get_hull_floor(water, index, out, 7);
    for (double number : out) returned += number;
}

inline void WaterScene::act(Handle* water, Random& random, Returned& returned) const {
    static const cd_field optional[] = {CD_MASK, CD_WALL_X, CD_WALL_Y, CD_SOURCE, CD_PRESSURE, CD_FORCE_X, CD_FORCE_Y};
    const cd_field field = optional[random.below(7)];
    const double speed = sqrt(9.81 * depth) * random.any_of({0.1, 1, 3});
    switch (random.below(24)) {
    case 23: returned += cd_water_set_sleep(water, random.any_of({0, 1e-4 * depth, 0.01 * depth, depth})); break;
    case 20:
    case 21:
    case 22: return float_hulls(water, random, returned);
    case 0: return write_bed(water, random, returned);
    case 1: return write_depth(water, random, returned);
    case 2:
    case 3: {
        const cd_field velocity = random.chance(0.5) ? CD_VELOCITY_X : CD_VELOCITY_Y;
        return write_part(*this, water, velocity, random, returned, [&] { return speed * random.uniform(-1, 1); });
    }
    case 4:
    case 5:
    case 6: return write_optional(water, field, random, returned);
    case 7: returned += cd_water_disable_field(water, field); break;
    case 8:
    case 9: return act_on_a_place(water, random, returned);
    case 10:
    case 11:
    case 12: {
        const cd_side side = cd_side(random.below(4));
        const cd_border kind = cd_border(random.below(5));
        const double value = depth * random.uniform(-1, 2), rate = random.any_of({0, 0, 0.1 * depth});
        returned += cd_water_set_side(water, side, kind, value, rate);
        returned += cd_water_set_inflow_depth(water, side, value > 0.5 * depth ? 0.25 * depth : 0);
        break;
    }
    case 13: returned += cd_water_set_momentum(water, cd_momentum(random.below(2))); break;
    case 14: returned += cd_water_set_method(water, cd_method(random.chance(0.6) ? 0 : random.below(3))); break;
    case 15: returned += cd_water_set_lambda(water, random.any_of({0.5, 0.5, 0.55, 0.75, 1, 0.3})); break;
    case 16: returned += cd_water_set_drag(water, random.any_of({0, 0.1, 3})); break;
    case 17: returned += cd_water_set_manning(water, random.any_of({0, 0.01, 0.1})); break;
    case 18: returned += cd_water_set_first(water, int32_t(random.below(2))); break;
    default: returned += cd_water_set_bed_rule(water, cd_bed_rule(random.below(2)));
    }
}

#endif
