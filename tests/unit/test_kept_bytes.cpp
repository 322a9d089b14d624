// Saved bytes made by someone who knows the format: any number in them may be anything. What is loaded can be used, and
// says what it was loaded from.
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <vector>

#include "contdyn/contdyn.h"
#include "model/keep.hh"

extern "C" {
#include "check.h"
#include "cmocka_all.h" // last: it makes a macro of the name fail
}

namespace {

const double heights[6] = {-8, -9, -8.5, -7, -8, -9};

// get: of an object of kComponents components
template <auto get, auto get_bed, int kComponents, class Handle>
bool colliders_are_possible(const Handle* object, size_t count) {
    bool good = count <= 4096;
    for (size_t i = 0; i < count; ++i) {
        cd_shape shape = -1;
        double first[kComponents], second[kComponents], velocity[kComponents], radius = -1, friction = -1, normal = 0;
        ok(get(object, i, &shape, first, second, velocity, kComponents, &radius, &friction));
        good &= shape >= CD_SHAPE_NONE && shape <= CD_SHAPE_CALLBACK && radius >= 0 && radius <= 1e60;
        size_t columns = 0, rows = 0;
        ok(get_bed(object, i, &columns, &rows, nullptr, 0));
        good &= shape == CD_SHAPE_BED ? columns >= 2 && rows >= kComponents - 1 : columns + rows == 0;
        double heights[6];
        good &= columns * rows <= 6;
        if (good) ok(get_bed(object, i, nullptr, nullptr, heights, columns * rows));
        for (size_t k = 0; good && k < columns * rows; ++k) good &= std::fabs(heights[k]) <= 1e60;
        good &= friction >= 0 && friction <= 1e60;
        for (int k = 0; k < kComponents; ++k) {
            good &= std::isfinite(first[k]) && std::isfinite(second[k]) && std::isfinite(velocity[k]);
            normal += second[k] * second[k];
        }
        good &= shape != CD_SHAPE_PLANE || std::fabs(normal - 1) < 1e-11;
        good &= shape != CD_SHAPE_CAPSULE || radius >= 1e-60;
    }
    return good;
}

// When it falls asleep, and the last numbers of its bytes but for `after` bytes: how calm each part is.
template <class C> bool sleep_is_possible(const typename C::Handle* object, size_t parts, size_t after = 0) {
    double speed = -1, seconds = -1;
    ok(C::get_sleep(object, &speed, &seconds));
    if (speed == 0) return seconds == 0;
    size_t size = 0;
    ok(C::save_size(object, &size));
    std::vector<unsigned char> bytes(size);
    ok(C::save(object, bytes.data(), size, &size));
    size -= after;
    cd::Reader reader{bytes.data() + size - parts * sizeof(double), bytes.data() + size};
    bool good = speed > 0 && speed <= 1e60 && seconds >= 1e-30 && seconds <= 1e60;
    for (size_t part = 0; part < parts; ++part) {
        double calm = NAN;
        walk(reader, calm);
        good &= calm == -1 || (calm >= 0 && calm <= seconds);
    }
    return good;
}

// The objects under one set of names.
struct ChainCalls {
    using Handle = cd_chain;
    static constexpr cd::Kind kind = {1, "", {}};
    static constexpr auto save_size = cd_chain_save_size;
    static constexpr auto save = cd_chain_save;
    static constexpr auto load = cd_chain_load;
    static constexpr auto step = cd_chain_step;
    static constexpr auto get_sleep = cd_chain_get_sleep;
    static constexpr auto destroy = cd_chain_destroy;

    static Handle* make() {
        Handle* chain = nullptr;
        ok(cd_chain_create(2, 5, 2, CD_FLOAT32, nullptr, &chain));
        return chain;
    }
    static void fill(Handle* chain) {
        const double gravity[2] = {1, -2};
        for (cd_field field : {CD_MASS, CD_STIFFNESS, CD_BEND, CD_FORCE}) ok(cd_chain_enable_field(chain, field));
        ok(cd_chain_set_bend(chain, 0.5));
        ok(cd_chain_set_gravity(chain, gravity, 2));
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_MATCHED));
        ok(cd_chain_attach(chain, 0, 2, 3, 1, nullptr, 0));
        ok(cd_chain_weld(chain, 0, 3));
        ok(cd_chain_step(chain, 0.125, 3));
    }
    // Pinned nodes rest, welded ones share a velocity, groups hold one held node at the most, time is finite.
    static bool is_possible(const Handle* chain) {
        double pin[6], stiffness[6], time;
        int32_t ring;
        ok(cd_chain_get_time(chain, &time));
        ok(cd_chain_get_ring(chain, &ring));
        const size_t springs = 5 + size_t(ring);
        ok(cd_chain_read_f64(chain, CD_PIN, 0, 1, 0, 6, pin, 6));
        if (cd_chain_read_f64(chain, CD_STIFFNESS, 0, 1, 0, springs, stiffness, springs) != CD_OK) return true;
        bool good = std::isfinite(time);
        for (size_t strand = 0; strand < 2; ++strand)
            for (size_t i = 0; i < 6; ++i) {
                double here[2], next[2];
                ok(cd_chain_read_f64(chain, CD_VELOCITY, strand, 1, i, 1, here, 2));
                ok(cd_chain_read_f64(chain, CD_VELOCITY, strand, 1, (i + 1) % 6, 1, next, 2));
                const bool welded = i < springs && std::isinf(stiffness[i]);
                const auto is_held = [&](size_t k) { return pin[k] != CD_NODE_FREE && pin[k] != CD_NODE_MATCHED; };
                good &= pin[i] != CD_NODE_PINNED || (here[0] == 0 && here[1] == 0);
                good &= !welded || memcmp(here, next, sizeof here) == 0 || std::isnan(here[0]) || std::isnan(here[1]);
                good &= !welded || !is_held(i) || !is_held((i + 1) % 6);
            }
        return good;
    }
};

// A rope: its springs of fixed length are no welds, and its lengths and tensions are numbers among the others.
struct RopeCalls : ChainCalls {
    static void fill(Handle* chain) {
        const double gravity[2] = {1, -2}, pins[2] = {CD_NODE_PINNED, CD_NODE_DRIVEN};
        ok(cd_chain_set_rest_length(chain, 2));
        ok(cd_chain_set_stiffness(chain, double(INFINITY)));
        ok(cd_chain_set_push(chain, 1));
        ok(cd_chain_set_tolerance(chain, 1e-4, 7));
        ok(cd_chain_set_air(chain, 0.25, 2));
        ok(cd_chain_set_wind(chain, gravity, 2));
        ok(cd_chain_set_strength(chain, 1e9));
        ok(cd_chain_set_thickness(chain, 0.125));
        ok(cd_chain_set_colliders(chain, 4));
        ok(cd_chain_set_plane(chain, 0, gravity, gravity, 2, 0.5));
        ok(cd_chain_set_capsule(chain, 1, gravity, pins, 2, 0.25, 1));
        ok(cd_chain_set_collider_velocity(chain, 1, gravity, 2));
        ok(cd_chain_set_bed(chain, 2, gravity, 2, 3, 1, 0.5, 1, heights, 3, 0.25));
        ok(cd_chain_set_bed(chain, 3, gravity, 2, 2, 1, 0.5, 1, heights, 2, 0.25));
        for (cd_field field : {CD_MASS, CD_STIFFNESS, CD_FORCE, CD_REST_LENGTH, CD_WIND, CD_STRENGTH})
            ok(cd_chain_enable_field(chain, field));
        ok(cd_chain_set_gravity(chain, gravity, 2));
        ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, 2, pins, 2)); // at both ends of a spring of fixed length
        ok(cd_chain_attach(chain, 0, 2, 3, 1, nullptr, 0));
        ok(cd_chain_cut(chain, 0, 0));
        ok(cd_chain_set_sleep(chain, 1e6, 0.5));
        const cd_status stepped = cd_chain_step(chain, 0.125, 3);
        assert_true(stepped == CD_OK || stepped == CD_ERROR_TOLERANCE);
    }
    static bool has_possible_colliders(const Handle* chain) {
        size_t count = 0;
        double thickness = -1;
        ok(cd_chain_get_colliders(chain, &count));
        ok(cd_chain_get_thickness(chain, &thickness));
        return thickness >= 0 && thickness <= 1e60 &&
               colliders_are_possible<cd_chain_get_collider, cd_chain_get_bed, 2>(chain, count);
    }
    static bool is_possible(const Handle* chain) {
        double length = 0, tolerance = 0, stiffness = 0, time;
        size_t most = 0;
        int32_t push = -1;
        ok(cd_chain_get_rest_length(chain, &length));
        if (!sleep_is_possible<RopeCalls>(chain, length > 0 ? 2 : 1)) return false;
        if (length == 0) return ChainCalls::is_possible(chain);
        ok(cd_chain_get_stiffness(chain, &stiffness));
        ok(cd_chain_get_tolerance(chain, &tolerance, &most));
        ok(cd_chain_get_push(chain, &push));
        ok(cd_chain_get_time(chain, &time));
        bool good = length >= 1e-60 && length <= 1e60 && tolerance >= 1e-14 && tolerance <= 0.5 && most >= 1 &&
                    (push == 0 || push == 1) && stiffness >= 0 && std::isfinite(time);
        double tension[2 * 6];
        int32_t ring;
        ok(cd_chain_get_ring(chain, &ring));
        const size_t springs = 5 + size_t(ring);
        ok(cd_chain_read_f64(chain, CD_TENSION, 0, 2, 0, springs, tension, 2 * springs));
        for (size_t i = 0; i < 2 * springs; ++i) good &= std::isfinite(tension[i]);
        double air[2], wind[2];
        ok(cd_chain_get_air(chain, &air[0], &air[1]));
        ok(cd_chain_get_wind(chain, wind, 2));
        for (int k = 0; k < 2; ++k) good &= air[k] >= 0 && air[k] <= 1e60 && std::isfinite(wind[k]);
        double strength;
        ok(cd_chain_get_strength(chain, &strength));
        good &= strength >= 1e-60 && (strength <= 1e60 || std::isinf(strength));
        const cd_status breaks = cd_chain_read_f64(chain, CD_STRENGTH, 0, 2, 0, springs, tension, 2 * springs);
        for (size_t i = 0; i < 2 * springs && breaks == CD_OK; ++i) good &= tension[i] > 0;
        good &= has_possible_colliders(chain);
        const bool can_break = breaks == CD_OK || !std::isinf(strength);
        return good &&
               (!can_break || cd_chain_read_f64(chain, CD_STIFFNESS, 0, 2, 0, springs, tension, 2 * springs) == CD_OK);
    }
};

struct MembraneCalls {
    using Handle = cd_membrane;
    static constexpr cd::Kind kind = {2, "", {}};
    static constexpr auto save_size = cd_membrane_save_size;
    static constexpr auto save = cd_membrane_save;
    static constexpr auto load = cd_membrane_load;
    static constexpr auto step = cd_membrane_step;
    static constexpr auto get_sleep = cd_membrane_get_sleep;
    static constexpr auto destroy = cd_membrane_destroy;

    static Handle* make() {
        Handle* membrane = nullptr;
        ok(cd_membrane_create(3, 1, 3, CD_FLOAT32, nullptr, &membrane));
        return membrane;
    }
    static void fill(Handle* membrane) {
        const double gravity[3] = {1, -2, 0.5};
        for (cd_field field : {CD_MASS, CD_STIFFNESS_U, CD_STIFFNESS_V, CD_FORCE, CD_PIN, CD_MASK})
            ok(cd_membrane_enable_field(membrane, field));
        ok(cd_membrane_set_bend(membrane, 0.5));
        ok(cd_membrane_set_pressure(membrane, 0.5));
        ok(cd_membrane_set_solver(membrane, CD_SOLVER_COUPLED));
        ok(cd_membrane_set_gravity(membrane, gravity, 3));
        ok(cd_membrane_set_edge(membrane, CD_EDGE_U_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_set_edge(membrane, CD_EDGE_U_LAST, CD_NODE_MATCHED));
        ok(cd_membrane_attach(membrane, 2, 1, 3, 1, nullptr, 0));
        ok(cd_membrane_step(membrane, 0.125, 3));
    }
    // Two nodes make no ring; pinned and absent ones rest; time is finite.
    static bool is_possible(const Handle* membrane) {
        int32_t ring[2];
        double pin[8], mask[8], v[24], time;
        ok(cd_membrane_get_time(membrane, &time));
        ok(cd_membrane_get_ring(membrane, &ring[0], &ring[1]));
        ok(cd_membrane_read_f64(membrane, CD_VELOCITY, 0, 0, 4, 2, v, 24));
        if (cd_membrane_read_f64(membrane, CD_PIN, 0, 0, 4, 2, pin, 8) != CD_OK) return true;
        if (cd_membrane_read_f64(membrane, CD_MASK, 0, 0, 4, 2, mask, 8) != CD_OK) return true;
        bool good = ring[1] == 0 && std::isfinite(time);
        for (size_t i = 0; i < 8; ++i)
            for (size_t k = 0; k < 3; ++k) good &= (pin[i] != CD_NODE_PINNED && mask[i] != 0) || v[3 * i + k] == 0;
        return good;
    }
};

// Cloth: its lengths, winds and colliders are numbers among the others.
struct ClothCalls : MembraneCalls {
    static Handle* make() {
        Handle* membrane = nullptr;
        ok(cd_membrane_create(3, 2, 3, CD_FLOAT32, nullptr, &membrane));
        return membrane;
    }
    static void fill(Handle* membrane) {
        const double there[3] = {1, -2, 0.5}, up[3] = {0.25, 0, 1};
        ok(cd_membrane_set_rest_length(membrane, 3, 2));
        ok(cd_membrane_set_shear(membrane, 2));
        ok(cd_membrane_set_sleep(membrane, 1e6, 0.5));
        ok(cd_membrane_set_compression(membrane, 3));
        ok(cd_membrane_set_effort(membrane, 3, 7));
        ok(cd_membrane_set_breaking_strain(membrane, 1e9));
        ok(cd_membrane_set_air(membrane, 0.25, 2));
        ok(cd_membrane_set_wind(membrane, there, 3));
        ok(cd_membrane_set_thickness(membrane, 0.125));
        ok(cd_membrane_set_colliders(membrane, 3));
        ok(cd_membrane_set_plane(membrane, 0, there, up, 3, 0.5));
        ok(cd_membrane_set_capsule(membrane, 1, there, up, 3, 0.25, 1));
        ok(cd_membrane_set_collider_velocity(membrane, 1, there, 3));
        ok(cd_membrane_set_bed(membrane, 2, there, 3, 3, 2, 0.5, 1, heights, 6, 0.25));
        for (cd_field field : {CD_MASS, CD_REST_LENGTH_U, CD_REST_LENGTH_V, CD_BREAKING_STRAIN_U, CD_BREAKING_STRAIN_V,
                               CD_WIND, CD_PIN, CD_MASK})
            ok(cd_membrane_enable_field(membrane, field));
        ok(cd_membrane_set_gravity(membrane, there, 3));
        ok(cd_membrane_set_edge(membrane, CD_EDGE_V_FIRST, CD_NODE_PINNED));
        ok(cd_membrane_attach(membrane, 2, 1, 3, 1, nullptr, 0));
        ok(cd_membrane_step(membrane, 0.125, 3));
    }
    // What only cloth has is there all together or not at all, and in the ranges of the header.
    static bool is_possible(const Handle* membrane) {
        double length[2], shear, rate, air[2], wind[3], thickness, v[36], time, strain;
        size_t newton, gradient, count;
        ok(cd_membrane_get_rest_length(membrane, &length[0], &length[1]));
        const size_t change = length[0] > 0 ? sizeof(float) * 36 : 0; // of the velocities
        if (!sleep_is_possible<ClothCalls>(membrane, 1, change)) return false;
        ok(cd_membrane_get_shear(membrane, &shear));
        ok(cd_membrane_get_compression(membrane, &rate));
        ok(cd_membrane_get_effort(membrane, &newton, &gradient));
        ok(cd_membrane_get_air(membrane, &air[0], &air[1]));
        ok(cd_membrane_get_wind(membrane, wind, 3));
        ok(cd_membrane_get_thickness(membrane, &thickness));
        ok(cd_membrane_get_colliders(membrane, &count));
        ok(cd_membrane_get_time(membrane, &time));
        ok(cd_membrane_get_breaking_strain(membrane, &strain));
        if (length[0] == 0)
            return length[1] == 0 && shear == 0 && air[0] == 0 && air[1] == 0 && thickness == 0 && count == 0 &&
                   wind[0] == 0 && wind[1] == 0 && wind[2] == 0 && std::isinf(strain) &&
                   cd_membrane_read_f64(membrane, CD_WIND, 0, 0, 4, 3, v, 36) == CD_ERROR_UNSUPPORTED;
        bool good = newton >= 1 && newton <= 1000 && gradient <= 10000 && std::isfinite(time);
        for (double l : length) good &= l >= 1e-60 && l <= 1e60;
        for (double number : {shear, rate, air[0], air[1], thickness}) good &= number >= 0 && number <= 1e60;
        for (double number : wind) good &= std::isfinite(number);
        if (cd_membrane_read_f64(membrane, CD_WIND, 0, 0, 4, 3, v, 36) == CD_OK)
            for (double number : v) good &= std::isfinite(number);
        if (cd_membrane_read_f64(membrane, CD_REST_LENGTH_U, 0, 0, 3, 3, v, 9) == CD_OK)
            for (size_t i = 0; i < 9; ++i) good &= v[i] > 0 && std::isfinite(v[i]);
        if (cd_membrane_read_f64(membrane, CD_REST_LENGTH_V, 0, 0, 4, 2, v, 8) == CD_OK)
            for (size_t i = 0; i < 8; ++i) good &= v[i] > 0 && std::isfinite(v[i]);
        // What may tear has stiffnesses of its own.
        good &= strain >= 1e-60 && (strain <= 1e60 || std::isinf(strain));
        for (bool along_v : {false, true}) {
            const auto read = [&](cd_field u, cd_field of_v, size_t& springs) {
                springs = along_v ? 8 : 9;
                return cd_membrane_read_f64(membrane, along_v ? of_v : u, 0, 0, along_v ? 4 : 3, along_v ? 2 : 3, v,
                                            springs);
            };
            size_t springs;
            const bool stiff = read(CD_STIFFNESS_U, CD_STIFFNESS_V, springs) == CD_OK;
            const bool tears = read(CD_BREAKING_STRAIN_U, CD_BREAKING_STRAIN_V, springs) == CD_OK;
            for (size_t i = 0; tears && i < springs; ++i) good &= v[i] >= 1e-60 && (v[i] <= 1e60 || std::isinf(v[i]));
            good &= stiff || (!tears && std::isinf(strain));
        }
        return good && colliders_are_possible<cd_membrane_get_collider, cd_membrane_get_bed, 3>(membrane, count);
    }
};

// Hulls on water, of which one is none: what acts on them is finite, and what they are is in range.
struct WaterCalls {
    using Handle = cd_water;
    static constexpr cd::Kind kind = {3, "", {}};
    static constexpr auto save_size = cd_water_save_size;
    static constexpr auto save = cd_water_save;
    static constexpr auto load = cd_water_load;
    static constexpr auto step = cd_water_step;
    static constexpr auto destroy = cd_water_destroy;

    static Handle* make() {
        Handle* water = nullptr;
        ok(cd_water_create(4, 3, 0.5, 0.25, CD_FLOAT32, nullptr, &water));
        return water;
    }
    static void fill(Handle* water) {
        const double depth[12] = {1, 1, 1, 1, 1, 2, 2, 1, 1, 1, 0, 0}, force[6] = {1, -2, 3, 4, -5, 6};
        const double floor[4] = {0, 0.125, -1, 0.25};
        ok(cd_water_write_f64(water, CD_DEPTH, 0, 0, 4, 3, depth, 12));
        ok(cd_water_enable_field(water, CD_SOURCE));
        ok(cd_water_set_hulls(water, 2, 2, 2));
        ok(cd_water_set_hull(water, 1, 50, 0.75, 0.5, floor, 4));
        ok(cd_water_launch_hull(water, 1, 1, 0.375, 1, 0.5));
        ok(cd_water_set_hull_drag(water, 1, 2, 3, 0.5));
        for (size_t i = 0; i < 2; ++i) ok(cd_water_set_hull_force(water, i, force, 6));
        ok(cd_water_step(water, 0.0625, 3));
    }
    static bool is_possible(const Handle* water) {
        double depth[12], force[6], drag[3], pose[7], mass, length, width, time;
        size_t count, along, across;
        ok(cd_water_get_time(water, &time));
        ok(cd_water_get_hulls(water, &count, &along, &across));
        ok(cd_water_read_f64(water, CD_DEPTH, 0, 0, 4, 3, depth, 12));
        bool good = std::isfinite(time) && count <= 4096;
        for (double d : depth) good &= !(d < 0);
        for (size_t i = 0; i < count && good; ++i) {
            ok(cd_water_get_hull(water, i, &mass, &length, &width, nullptr, nullptr, 0));
            ok(cd_water_get_hull_force(water, i, force, 6));
            ok(cd_water_get_hull_drag(water, i, &drag[0], &drag[1], &drag[2]));
            ok(cd_water_get_hull_pose(water, i, pose, 7));
            const double ahead = std::hypot(pose[3], pose[4]); // which steps divide by
            good &= ahead == 0 ? mass == 0 : !(std::fabs(ahead - 1) > 1e-6);
            good &= mass == 0 || (mass >= 1e-12 && mass <= 1e15 && length > 0 && width > 0);
            good &= std::isfinite(length) && std::isfinite(width);
            for (double f : force) good &= std::fabs(f) <= 1e30;
            for (double d : drag) good &= d >= 0 && d <= 1e30;
        }
        return good;
    }
};

template <class C> std::vector<unsigned char> saved(const typename C::Handle* object) {
    size_t size = 0;
    ok(C::save_size(object, &size));
    std::vector<unsigned char> bytes(size);
    ok(C::save(object, bytes.data(), size, &size));
    return bytes;
}

// Whether they are loaded: then what is loaded is of use and says what it was loaded from (but for the kind of a NaN,
// unless exactly), else nothing has happened.
template <class C> bool is_loaded(const std::vector<unsigned char>& changed, bool exactly) {
    std::vector<unsigned char> bytes = changed;
    cd::write_header(C::kind, bytes.data(), bytes.size());
    typename C::Handle* const object = C::make();
    const std::vector<unsigned char> before = saved<C>(object);
    const cd_status status = C::load(object, bytes.data(), bytes.size());
    if (status == CD_OK) {
        const std::vector<unsigned char> again = saved<C>(object);
        assert_true(again == bytes || !exactly);
        ok(C::load(object, again.data(), again.size()));
        assert_true(saved<C>(object) == again && C::is_possible(object));
        const cd_status stepped = C::step(object, 0.125, 2);
        assert_true(stepped == CD_OK || stepped == CD_ERROR_DIVERGED || stepped == CD_ERROR_TOLERANCE ||
                    stepped == CD_ERROR_UNSUPPORTED); // which ropes and cloth say that cannot have what was loaded
        assert_true(C::is_possible(object));
    } else {
        assert_true(status == CD_ERROR_FORMAT || status == CD_ERROR_MISMATCH);
        assert_true(saved<C>(object) == before);
    }
    C::destroy(object);
    return status == CD_OK;
}

template <class C> void any_bytes_with_a_good_checksum_are_refused_or_of_use(void**) {
    typename C::Handle* const source = C::make();
    C::fill(source);
    const std::vector<unsigned char> good = saved<C>(source);
    size_t taken = 0, tried = 0;
    const size_t part = is_brief() ? 7 : 2;
    for (size_t i = cd::kHeader; i < good.size(); ++i) {
        size_t way = i; // each byte takes a part of the ways, its neighbours the others
        for (unsigned flip : {0x01u, 0x04u, 0x80u, 0xFFu}) {
            if (!is_taken(way++, part)) continue;
            std::vector<unsigned char> bytes = good;
            bytes[i] = static_cast<unsigned char>(bytes[i] ^ flip);
            ++tried, taken += is_loaded<C>(bytes, true);
        }
        for (double number : {double(NAN), double(INFINITY), -1.0, 1e308, 2.0, 1e-310}) {
            if (!is_taken(way++, part)) continue;
            std::vector<unsigned char> bytes = good;
            const float single = float(number);
            if (i + sizeof number <= good.size()) memcpy(&bytes[i], &number, sizeof number);
            ++tried, taken += is_loaded<C>(bytes, false);
            bytes = good;
            if (i + sizeof single <= good.size()) memcpy(&bytes[i], &single, sizeof single);
            ++tried, taken += is_loaded<C>(bytes, false);
        }
    }
    assert_true(taken > 100 && tried - taken > 100);
    C::destroy(source);
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<ChainCalls>),
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<RopeCalls>),
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<MembraneCalls>),
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<ClothCalls>),
        cmocka_unit_test(any_bytes_with_a_good_checksum_are_refused_or_of_use<WaterCalls>),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
