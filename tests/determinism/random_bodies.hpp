// Random chains, and what is done with them while they run: all of it follows from a seed, and is the same for every
// object that a scene is run on. For test_random.cpp; random_membranes.hpp goes on from here. No two random numbers are
// drawn among the arguments of one call, since compilers may take those in any order.
#ifndef RANDOM_BODIES_HPP
#define RANDOM_BODIES_HPP

#include <contdyn/contdyn.h>

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <initializer_list>
#include <vector>

class Random {
public:
    Random(uint64_t seed, uint64_t round) : state(seed * 0x2545f4914f6cdd1d + round * 0xd1342543de82ef95) { bits(); }
    size_t below(size_t n) { return size_t(bits() % n); }
    size_t from_to(size_t least, size_t most) { return least + below(most - least + 1); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    double uniform(double from, double to) { return from + (to - from) * (double(bits() >> 11) * 0x1p-53); }
    double decades(double from, double to) { return pow(10, uniform(from, to)); } // 10^from to 10^to
    double any_of(std::initializer_list<double> numbers) { return numbers.begin()[below(numbers.size())]; }

private:
    uint64_t state;
    uint64_t bits() { // splitmix64
        uint64_t z = state += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
        z = (z ^ z >> 27) * 0x94d049bb133111eb;
        return z ^ z >> 31;
    }
};

// What calls returned: must be the same for all objects that a scene is run on.
struct Returned {
    uint64_t hash = 0;
    void operator+=(double number) {
        uint64_t word;
        memcpy(&word, &number, sizeof word);
        hash = (hash ^ word) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 29;
    }
};

// How large a field is: rows of so many numbers, or strands of them.
struct Size {
    size_t rows, columns, components;
};

// Lines that are solved side by side, and nodes or cells along them: from one to 200 lines, mostly with few along them,
// so that there are full bundles of lanes, partly filled ones, and both short and long lines.
struct Lines {
    size_t count, length;
    explicit Lines(Random& random) {
        count = random.from_to(1, size_t(random.any_of({1, 4, 40, 40, 200})));
        const size_t most = random.chance(0.1) ? 200 : 24;
        length = random.from_to(1, count * most > 2400 ? 2400 / count : most);
    }
};

// A size of the numbers in a scene: mostly 1, at times such that squares of them or they themselves nearly vanish.
inline double random_size(Random& random, cd_precision precision) {
    if (random.chance(0.85)) return 1;
    return precision == CD_FLOAT64 ? random.decades(-165, -130) : random.decades(-26, -15);
}

// Writes a whole field or a random part of it, of a chain or of a sheet.
template <class Scene, class Pick> void write_part(const Scene& scene, typename Scene::Handle* handle, cd_field field,
                                                   Random& random, Returned& returned, const Pick& pick) {
    const Size size = scene.size_of(handle, field);
    if (size.rows == 0 || size.columns == 0) return;
    size_t row = 0, rows = size.rows, column = 0, columns = size.columns;
    if (random.chance(0.4)) {
        row = random.below(rows), rows = random.from_to(1, rows - row);
        column = random.below(columns), columns = random.from_to(1, columns - column);
    }
    std::vector<double> values(rows * columns * size.components);
    for (double& value : values) value = pick();
    returned += scene.write(handle, field, row, rows, column, columns, values);
}

// What a collider by callback is, by its index, for all objects alike: a ball, a bowl, a cylinder that grows, or a ball
// that tells nothing of some places.
inline void tell_distances(void* user, double time, size_t count, size_t components, const double* positions,
                           double* distances, double* normals) {
    const int kind = *static_cast<const int*>(user);
    for (size_t i = 0; i < count; ++i) {
        const double* const x = positions + i * components;
        double* const normal = normals + i * components;
        const size_t first = kind == 2 && components > 1 ? 1 : 0;
        double square = 0;
        for (size_t k = first; k < components; ++k) square += x[k] * x[k];
        const double r = sqrt(square), way = kind == 1 ? -1 : 1;
        distances[i] = way * (r - (kind == 1 ? 1 : 0.25)) - (kind == 2 ? 0.125 * (time < 1 ? time : 1) : 0);
        for (size_t k = 0; k < components; ++k) normal[k] = k >= first && r > 0 ? way * x[k] / r : 0;
        if (!(r > 0)) normal[components - 1] = 1;
        if (kind == 3 && x[0] > 0.75) distances[i] = double(NAN);
    }
}
inline cd_distance distance_of(size_t index) {
    static int kinds[4] = {0, 1, 2, 3};
    return {&kinds[index % 4], tell_distances};
}
// What a load and a copied state leave out.
template <class Api, class Handle> void set_callbacks_again(Handle* handle, size_t components) {
    size_t count = 0;
    Api::get_colliders(handle, &count);
    for (size_t i = 0; i < count; ++i) {
        cd_shape shape = CD_SHAPE_NONE;
        Api::get_collider(handle, i, &shape, nullptr, nullptr, nullptr, components, nullptr, nullptr);
        const cd_distance distance = distance_of(i);
        if (shape == CD_SHAPE_CALLBACK) Api::set_callback(handle, i, &distance, nullptr, 0, 0);
    }
}

// A bed of hills about as high as they are wide, which nodes may lie in.
template <class Api, class Handle>
void lie_on_a_bed(Handle* handle, size_t index, size_t components, double size, Random& random, Returned& returned) {
    const size_t columns = random.from_to(2, 6), rows = components == 3 ? random.from_to(2, 6) : 1;
    const double spacing = size * random.decades(-1, 0), friction = random.chance(0.3) ? 0 : random.uniform(0, 2);
    double origin[3], heights[36];
    for (double& x : origin) x = size * random.uniform(-2, 0);
    for (double& h : heights) h = spacing * random.uniform(0, 1);
    returned += Api::set_bed(handle, index, origin, components, columns, rows, spacing < 1e-60 ? 1e-60 : spacing,
                             spacing < 5e-61 ? 1e-60 : 2 * spacing, heights, columns * rows, friction);
    size_t told = 0;
    returned += Api::get_bed(handle, index, &told, nullptr, heights, 0);
    returned += double(told);
}

// Planes, capsules, beds and callbacks near the nodes, some of which lie in them. Api has the functions of ropes, or
// those of cloth.
template <class Api, class Handle>
void meet_things(Handle* handle, size_t components, double size, Random& random, Returned& returned) {
    size_t count = 0;
    returned += Api::get_colliders(handle, &count);
    if (count == 0 || random.chance(0.2)) returned += Api::set_colliders(handle, count = random.below(Api::most));
    const auto number = [&] { return size * random.uniform(-1.5, 1.5); };
    double first[3], last[3], velocity[3], normal[3];
    for (size_t k = 0; k < 3; ++k) {
        first[k] = number(), last[k] = number(), velocity[k] = number();
        normal[k] = random.uniform(-1, 1);
    }
    const double radius = size * random.decades(-2, 0), friction = random.chance(0.3) ? 0 : random.uniform(0, 2);
    for (size_t index = 0; index < count; ++index) {
        const size_t kind = random.below(11);
        const cd_distance distance = distance_of(index);
        if (kind <= 1) returned += Api::set_plane(handle, index, first, normal, components, friction);
        else if (kind <= 4)
            returned += Api::set_capsule(handle, index, first, kind == 4 ? first : last, components,
                                         radius < 1e-60 ? 1e-60 : radius, friction);
        else if (kind == 5) returned += Api::set_velocity(handle, index, velocity, components);
        else if (kind == 6) returned += Api::remove(handle, index);
        else if (kind == 7) lie_on_a_bed<Api>(handle, index, components, size, random, returned);
        else if (kind == 8)
            returned +=
                Api::set_callback(handle, index, &distance, random.chance(0.2) ? nullptr : first, components, friction);
        for (size_t k = 0; k < 3; ++k) first[k] += radius, normal[k] += 0.25;
    }
    if (random.chance(0.3)) returned += Api::set_thickness(handle, size * random.any_of({0, 0.001, 0.05}));
    if (random.chance(0.3)) returned += Api::set_loads(handle, int32_t(random.chance(0.8)));
}
template <class Api, class Handle> void measure_loads(const Handle* handle, Returned& returned) {
    size_t count = 0;
    double load[6] = {};
    Api::get_colliders(handle, &count);
    for (size_t i = 0; i < count; ++i) {
        returned += Api::get_load(handle, i, load, 6);
        for (double number : load) returned += number;
    }
}

#define COLLIDER_API(Name, object, most_at_once)                                  \
    struct Name {                                                                 \
        static constexpr size_t most = most_at_once;                              \
        static constexpr auto get_colliders = cd_##object##_get_colliders;        \
        static constexpr auto set_colliders = cd_##object##_set_colliders;        \
        static constexpr auto set_plane = cd_##object##_set_plane;                \
        static constexpr auto set_capsule = cd_##object##_set_capsule;            \
        static constexpr auto set_velocity = cd_##object##_set_collider_velocity; \
        static constexpr auto set_bed = cd_##object##_set_bed;                    \
        static constexpr auto get_bed = cd_##object##_get_bed;                    \
        static constexpr auto set_callback = cd_##object##_set_callback;          \
        static constexpr auto get_collider = cd_##object##_get_collider;          \
        static constexpr auto remove = cd_##object##_remove_collider;             \
        static constexpr auto set_thickness = cd_##object##_set_thickness;        \
        static constexpr auto set_loads = cd_##object##_set_loads;                \
        static constexpr auto get_load = cd_##object##_get_collider_load;         \
    }
COLLIDER_API(RopeThings, chain, 4);
COLLIDER_API(ClothThings, membrane, 6); // more than a node heeds
#undef COLLIDER_API

// ---- chains ---------------------------------------------------------------------------------------------------------

// A turn from one component towards the next.
struct Turn {
    double rotation[16] = {};

    Turn(Random& random, size_t components) {
        const size_t a = random.below(components), b = (a + 1) % components;
        const double angle = random.uniform(-4, 4);
        for (size_t i = 0; i < components; ++i) rotation[i * components + i] = 1;
        if (a == b) return;
        rotation[a * components + a] = rotation[b * components + b] = cos(angle);
        rotation[a * components + b] = -sin(angle), rotation[b * components + a] = sin(angle);
    }
};

struct ChainScene {
    using Handle = cd_chain;
    static constexpr const char* name = "chain";
    size_t strands, nodes, components;
    cd_precision precision;
    double size;
    bool rope; // now and then with springs that have no length

    explicit ChainScene(Random& random) {
        const Lines lines(random);
        strands = lines.count, nodes = lines.length, components = random.from_to(1, 4);
        precision = cd_precision(random.below(2));
        size = random_size(random, precision);
        rope = nodes > 1 && components < 4 && random.chance(0.4);
    }
    Handle* make() const {
        Handle* chain = nullptr;
        cd_chain_create(strands, nodes - 1, components, precision, nullptr, &chain);
        return chain;
    }
    size_t springs(const Handle* chain) const {
        int32_t ring = 0;
        cd_chain_get_ring(chain, &ring);
        return nodes - 1 + size_t(ring);
    }
    size_t own_strands(const Handle* chain) const {
        double length = 0;
        cd_chain_get_rest_length(chain, &length);
        return length > 0 ? strands : 1;
    }
    size_t numbers() const { return strands * nodes * components; }
    Size size_of(const Handle* chain, cd_field field) const {
        const bool of_springs = field == CD_STIFFNESS || (field >= CD_REST_LENGTH && field != CD_WIND);
        const bool of_strands =
            field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET || field == CD_WIND;
        return {of_strands ? strands : own_strands(chain), of_springs ? springs(chain) : nodes,
                of_strands ? components : 1};
    }
    cd_status write(Handle* chain, cd_field field, size_t strand, size_t count, size_t first, size_t n,
                    const std::vector<double>& values) const {
        return cd_chain_write_f64(chain, field, strand, count, first, n, values.data(), values.size());
    }
    cd_status read(const Handle* chain, cd_field field, std::vector<double>& out) const {
        const Size s = size_of(chain, field);
        out.resize(s.rows * s.columns * s.components);
        return cd_chain_read_f64(chain, field, 0, s.rows, 0, s.columns, out.data(), out.size());
    }

    void begin(Handle* chain, Random& random, size_t busy, Returned& returned) const {
        returned += cd_chain_set_stiffness(chain, random.decades(-1, 3));
        write_numbers(chain, CD_POSITION, random, returned);
        write_numbers(chain, CD_VELOCITY, random, returned);
        if (rope) become_rope(chain, random, returned);
        else if (random.chance(0.3)) returned += cd_chain_set_method(chain, cd_method(random.below(4)));
        for (size_t k = random.below(busy); k > 0; --k) act(chain, random, returned);
    }
    void set_callbacks(Handle* chain) const { set_callbacks_again<RopeThings>(chain, components); }
    void become_rope(Handle* chain, Random& random, Returned& returned) const;
    void act_on_rope(Handle* chain, Random& random, Returned& returned) const;
    void write_numbers(Handle* chain, cd_field field, Random& random, Returned& returned) const {
        write_part(*this, chain, field, random, returned, [&] { return size * random.uniform(-1, 1); });
    }
    void act(Handle* chain, Random& random, Returned& returned) const;
    double pick_dt(const Handle* chain, Random& random, Returned& returned) const {
        double length = 0;
        returned += cd_chain_get_rest_length(chain, &length);
        if (length > 0) return random.decades(-4, 1);
        return chain_or_membrane_dt(chain, cd_chain_get_method, cd_chain_get_lambda, cd_chain_stable_dt, random,
                                    returned);
    }
    void measure(const Handle* chain, Returned& returned) const {
        double k = 0, e = 0, g = 0, length = 0;
        returned += cd_chain_get_energy(chain, &k, &e, &g);
        returned += k, returned += e, returned += g;
        cd_chain_get_rest_length(chain, &length);
        if (length == 0) return;
        size_t iterations = 0;
        double error = 0;
        returned += cd_chain_get_convergence(chain, &iterations, &error);
        returned += double(iterations), returned += error;
        double force[4] = {};
        returned += cd_chain_get_broken(chain, &iterations);
        returned += cd_chain_get_reaction(chain, strands - 1, nodes / 2, force, components);
        returned += double(iterations), returned += force[0];
        returned += cd_chain_get_colliders(chain, &iterations);
        for (size_t i = 0; i < iterations; ++i) {
            returned += cd_chain_get_collider(chain, i, nullptr, force, nullptr, nullptr, components, nullptr, nullptr);
            returned += force[0];
        }
        measure_loads<RopeThings>(chain, returned);
    }

    // Implicit steps of all lengths; steps that may grow only where they are short.
    template <class Object, class Method, class Lambda, class Stable>
    static double chain_or_membrane_dt(const Object* object, Method get_method, Lambda get_lambda, Stable stable_dt,
                                       Random& random, Returned& returned) {
        cd_method method = CD_METHOD_IMPLICIT;
        double lambda = 0, stable = 0;
        get_method(object, &method);
        get_lambda(object, &lambda);
        returned += stable_dt(object, &stable);
        returned += stable;
        if (!(stable < 1)) stable = 1;
        const double share = random.uniform(0.1, 0.9), dt = random.decades(-4, 1);
        if (method == CD_METHOD_FORWARD_EULER) return 0.1 * share * stable;
        return method == CD_METHOD_SYMPLECTIC_EULER || (method == CD_METHOD_IMPLICIT && lambda < 0.5) ? share * stable
                                                                                                      : dt;
    }
};

// Springs get lengths, and what ropes can't have is done away with.
inline void ChainScene::become_rope(Handle* chain, Random& random, Returned& returned) const {
    const double lambda = random.any_of({0.5, 0.5, 0.75, 1}), length = size * random.decades(-1, 1);
    returned += cd_chain_set_method(chain, CD_METHOD_IMPLICIT);
    returned += cd_chain_set_lambda(chain, lambda);
    returned += cd_chain_set_stiffness_damping(chain, 0);
    returned += cd_chain_set_ring(chain, 0);
    for (cd_end end = CD_END_FIRST; end <= CD_END_LAST; ++end) {
        cd_node kind = CD_NODE_FREE;
        cd_chain_get_end(chain, end, &kind);
        if (kind == CD_NODE_MATCHED) returned += cd_chain_set_end(chain, end, CD_NODE_FREE);
    }
    returned += cd_chain_set_rest_length(chain, length < 1e-60 ? 1e-60 : length);
}

// What only ropes have. A hard one that ends short of its tolerance steps to the same bits, too.
inline void ChainScene::act_on_rope(Handle* chain, Random& random, Returned& returned) const {
    switch (random.below(18)) {
    case 16:
        if (components != 2 || nodes < 3) break;
        returned += cd_chain_set_rest_angle(chain, random.chance(0.2) ? 0 : double(nodes - 2) * random.uniform(-3, 3));
        break;
    case 17:
        if (components != 2) break;
        if (random.chance(0.2)) {
            returned += cd_chain_disable_field(chain, CD_REST_ANGLE);
            break;
        }
        returned += cd_chain_enable_field(chain, CD_REST_ANGLE);
        return write_part(*this, chain, CD_REST_ANGLE, random, returned, [&] { return random.uniform(-3.14, 3.14); });
    case 13:
    case 14:
    case 15: return meet_things<RopeThings>(chain, components, size, random, returned);
    case 0:
    case 1:
    case 8: return become_rope(chain, random, returned);
    case 2: returned += cd_chain_set_push(chain, int32_t(random.chance(0.3))); break;
    case 3: {
        const double tolerance = random.decades(-13, -1);
        returned += cd_chain_set_tolerance(chain, tolerance, random.from_to(1, random.chance(0.5) ? 4 : 200));
        break;
    }
    case 4: {
        returned += cd_chain_enable_field(chain, CD_REST_LENGTH);
        const double each = size / double(nodes);
        return write_part(*this, chain, CD_REST_LENGTH, random, returned, [&] {
            const double length = each * random.decades(-1, 1);
            return length < 1e-60 ? 1e-60 : length;
        });
    }
    case 5: {
        const bool rigid = random.chance(0.5);
        returned += cd_chain_set_stiffness(chain, rigid ? double(INFINITY) : random.decades(0, 6));
        break;
    }
    case 6:
        if (random.chance(0.5)) returned += cd_chain_set_rest_length(chain, 0);
        else returned += cd_chain_disable_field(chain, CD_REST_LENGTH);
        break;
    case 9: {
        const double wind[3] = {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
        const double most = random.decades(-3, 3), along = random.any_of({0, 0.1, 2}) * most;
        const double across = random.chance(0.2) ? 0 : most;
        returned += cd_chain_set_air(chain, along, across);
        returned += cd_chain_set_wind(chain, wind, components);
        break;
    }
    case 10:
        if (random.chance(0.3)) returned += cd_chain_disable_field(chain, CD_WIND);
        else returned += cd_chain_enable_field(chain, CD_WIND);
        return write_numbers(chain, CD_WIND, random, returned);
    case 11:
        returned += cd_chain_set_strength(chain, random.chance(0.5) ? double(INFINITY) : random.decades(-1, 4));
        break;
    case 12:
        if (random.chance(0.3)) {
            returned += cd_chain_disable_field(chain, CD_STRENGTH);
            break;
        }
        returned += cd_chain_enable_field(chain, CD_STRENGTH);
        return write_part(*this, chain, CD_STRENGTH, random, returned,
                          [&] { return random.chance(0.5) ? double(INFINITY) : random.decades(-1, 4); });
    default: return write_part(*this, chain, CD_TENSION, random, returned, [&] { return random.decades(-3, 3); });
    }
}

// One random change.
inline void ChainScene::act(Handle* chain, Random& random, Returned& returned) const {
    if (rope && random.chance(0.5)) return act_on_rope(chain, random, returned);
    static const cd_field optional[] = {CD_FORCE, CD_MASS, CD_STIFFNESS, CD_BEND, CD_TARGET};
    const cd_field field = optional[random.below(5)];
    const auto number = [&] { return size * random.uniform(-1, 1); };
    double vector[4];
    for (double& x : vector) x = number();
    switch (random.below(22)) {
    case 20: {
        const size_t strand = random.below(strands);
        returned += cd_chain_teleport(chain, strand, Turn(random, components).rotation, vector, components);
        break;
    }
    case 0: return write_numbers(chain, CD_POSITION, random, returned);
    case 1: return write_numbers(chain, CD_VELOCITY, random, returned);
    case 2: returned += cd_chain_disable_field(chain, field); break;
    case 3:
    case 4:
    case 5:
        returned += cd_chain_enable_field(chain, field);
        if (field == CD_FORCE || field == CD_TARGET) return write_numbers(chain, field, random, returned);
        return write_part(*this, chain, field, random, returned, [&] {
            if (field == CD_STIFFNESS && random.chance(0.1)) return random.any_of({0, INFINITY}); // a cut or a weld
            return field == CD_BEND ? random.decades(-4, 0) : random.decades(-2, 2);
        });
    case 6:
        return write_part(*this, chain, CD_PIN, random, returned, [&] {
            return random.chance(0.1) ? random.any_of({1, 2, CD_NODE_POSED}) : 0;
        });
    case 7: returned += cd_chain_set_mass(chain, random.decades(-1, 1)); break;
    case 21:
        returned += cd_chain_set_sleep(chain, random.chance(0.2) ? 0 : random.decades(-6, 2), random.decades(-2, 0));
        break;
    case 8: returned += cd_chain_set_stiffness(chain, random.chance(0.1) ? 0 : random.decades(-1, 4)); break;
    case 9: returned += cd_chain_set_bend(chain, random.chance(0.5) ? 0 : random.decades(-5, -1)); break;
    case 10: returned += cd_chain_set_drag(chain, random.any_of({0, 0.1, 3})); break;
    case 11: returned += cd_chain_set_stiffness_damping(chain, random.any_of({0, 0.001, 0.1})); break;
    case 12: returned += cd_chain_set_gravity(chain, vector, components); break;
    case 13: returned += cd_chain_set_ring(chain, int32_t(random.below(2))); break;
    case 14: {
        const cd_end end = cd_end(random.below(2));
        returned += cd_chain_set_end(chain, end, cd_node(random.below(5)));
        break;
    }
    case 15: returned += cd_chain_set_mass_rule(chain, cd_mass_rule(random.below(2))); break;
    case 16: returned += cd_chain_set_method(chain, cd_method(random.chance(0.5) ? 0 : random.below(4))); break;
    case 17: returned += cd_chain_set_lambda(chain, random.any_of({0.5, 0.5, 0.6, 0.75, 1, 0.3})); break;
    case 18: {
        const size_t strand = random.below(own_strands(chain)), node = random.below(nodes);
        const double stiffness = random.decades(-1, 3), damping = random.any_of({0, 1});
        returned += random.chance(0.3) ? cd_chain_detach(chain, strand, node)
                                       : cd_chain_attach(chain, strand, node, stiffness, damping, vector, components);
        break;
    }
    default:
        if (springs(chain) == 0 || random.chance(0.4)) {
            const size_t strand = random.below(strands);
            returned += cd_chain_impulse(chain, strand, random.below(nodes), vector, components);
        } else {
            const size_t strand = random.below(own_strands(chain)), spring = random.below(springs(chain));
            returned += random.chance(0.5) ? cd_chain_cut(chain, strand, spring) : cd_chain_weld(chain, strand, spring);
        }
    }
}

#endif
