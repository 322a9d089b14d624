// Every error of every call on a chain arrives with its status and the library's message, and changes nothing.
#include "check.hpp"

#include <array>
#include <cmath>
#include <limits>

using namespace contdyn;

namespace {

// Refuses, and leaves the chain as it was.
#define KEPT(rope, ...)                               \
    do {                                              \
        const std::uint64_t was = GET((rope).hash()); \
        REFUSED(__VA_ARGS__);                         \
        CHECK(GET((rope).hash()) == was);             \
    } while (0)

const double nan_value = std::numeric_limits<double>::quiet_NaN();

void numbers(chain& rope) {
    for (double bad : {-1.0, nan_value, HUGE_VAL}) {
        KEPT(rope, status::error_value, "lambda", rope.set_lambda(bad));
        KEPT(rope, status::error_value, "mass", rope.set_mass(bad));
        KEPT(rope, status::error_value, "stiffness", rope.set_stiffness(bad));
        KEPT(rope, status::error_value, "bend", rope.set_bend(bad));
        KEPT(rope, status::error_value, "drag", rope.set_drag(bad));
        KEPT(rope, status::error_value, "seconds", rope.set_stiffness_damping(bad));
        KEPT(rope, status::error_value, "dt", rope.step(bad));
        KEPT(rope, status::error_value, "stiffness", rope.attach(0, 1, bad, 0));
        KEPT(rope, status::error_value, "damping", rope.attach(0, 1, 1, bad));
    }
    KEPT(rope, status::error_value, "gravity", rope.set_gravity({0, nan_value}));
    KEPT(rope, status::error_value, "impulse", rope.impulse(0, 1, {0, nan_value}));
    KEPT(rope, status::error_value, "offset", rope.teleport(0, {}, {0, nan_value}));
    KEPT(rope, status::error_value, "rotation", rope.teleport(0, {1, 0, 0, 2}, {0, 0}));
    KEPT(rope, status::error_value, "rotation", rope.teleport(0, {1, 0, 0, nan_value}, {0, 0}));
    KEPT(rope, status::error_value, "target", rope.attach(0, 1, 1, 1, {0, nan_value}));
    KEPT(rope, status::error_value, "values", rope.write_f64(field::position, 0, 1, 0, 1, {0, nan_value}));
    KEPT(rope, status::error_value, "values", rope.write_f32(field::position, 0, 1, 0, 1, {0, NAN}));
    double out[2];
    KEPT(rope, status::error_value, "at", rope.sample(0, {nan_value}, outside::refused, out));
}

void enumerators(chain& rope) {
    KEPT(rope, status::error_enum, "method", rope.set_method(static_cast<method>(9)));
    KEPT(rope, status::error_enum, "kernels", rope.set_kernels(static_cast<kernels>(9)));
    KEPT(rope, status::error_enum, "rule", rope.set_mass_rule(static_cast<mass_rule>(9)));
    KEPT(rope, status::error_enum, "end", rope.set_end(static_cast<end>(9), node::free));
    KEPT(rope, status::error_enum, "kind", rope.set_end(end::first, static_cast<node>(9)));
    KEPT(rope, status::error_enum, "end", rope.get_end(static_cast<end>(9)));
    KEPT(rope, status::error_enum, "field", rope.enable_field(static_cast<field>(99)));
    KEPT(rope, status::error_enum, "field", rope.disable_field(static_cast<field>(99)));
    KEPT(rope, status::error_enum, "field", rope.view(static_cast<field>(99)));
    KEPT(rope, status::error_enum, "field", rope.read_f64(static_cast<field>(99)));
    KEPT(rope, status::error_enum, "field", rope.write_f32(static_cast<field>(99), 0, 1, 0, 1, {1}));
}

void ranges(chain& rope) {
    std::array<double, 3> three{};
    std::array<float, 3> floats{};
    KEPT(rope, status::error_range, "count", rope.set_gravity(three));
    KEPT(rope, status::error_range, "count", rope.get_gravity(three));
    KEPT(rope, status::error_range, "count", rope.get_momentum(three));
    KEPT(rope, status::error_range, "count", rope.write_f64(field::position, 0, 1, 0, 1, three));
    KEPT(rope, status::error_range, "count", rope.read_f64(field::position, 0, 1, 0, 1, three));
    KEPT(rope, status::error_range, "count", rope.write_f32(field::position, 0, 1, 0, 1, floats));
    KEPT(rope, status::error_range, "count", rope.read_f32(field::position, 0, 1, 0, 1, floats));
    KEPT(rope, status::error_range, "count", rope.write_f64(field::position, three));
    KEPT(rope, status::error_range, "count", rope.write_f32(field::position, floats));
    KEPT(rope, status::error_range, "nodes", rope.write_f64(field::position, 0, 1, 6, 1, {1, 2}));
    KEPT(rope, status::error_range, "strand", rope.write_f64(field::position, 2, 1, 0, 1, {1, 2}));
    KEPT(rope, status::error_range, "strand", rope.impulse(2, 0, {1, 2}));
    KEPT(rope, status::error_range, "node", rope.impulse(0, 6, {1, 2}));
    KEPT(rope, status::error_range, "count", rope.impulse(0, 0, {1, 2, 3}));
    KEPT(rope, status::error_range, "strand", rope.teleport(2, {}, {1, 2}));
    KEPT(rope, status::error_range, "count", rope.teleport(0, {}, {1}));
    KEPT(rope, status::error_range, "count", rope.teleport(0, {1, 0, 0, 0, 1, 0, 0, 0, 1}, three));
    KEPT(rope, status::error_range, "chain::teleport", rope.teleport(0, {1, 0, 0}, {1, 2}));
    KEPT(rope, status::error_range, "chain::teleport", rope.teleport(0, {1}, {}));
    KEPT(rope, status::error_range, "node", rope.attach(0, 6, 1, 1));
    KEPT(rope, status::error_range, "count", rope.attach(0, 1, 1, 1, {1}));
    KEPT(rope, status::error_range, "node", rope.detach(0, 6));
    KEPT(rope, status::error_range, "node", rope.get_attachment(0, 6));
    KEPT(rope, status::error_range, "spring", rope.cut(0, 5));
    KEPT(rope, status::error_range, "spring", rope.weld(0, 5));
    KEPT(rope, status::error_value, "at", rope.sample(0, {5.5}, outside::refused, span<double>(three.data(), 2)));
    KEPT(rope, status::error_range, "out_count", rope.sample(0, {1}, outside::refused, three));
    KEPT(rope, status::error_range, "strand", rope.sample(2, {1}, outside::refused, span<double>(three.data(), 2)));
    unsigned char little[8];
    KEPT(rope, status::error_range, "size", rope.save(little));
}

void fields(chain& rope) {
    for (field f : {field::force, field::target, field::mass, field::stiffness, field::bend}) {
        KEPT(rope, status::error_disabled, "field", rope.read_f64(f));
        KEPT(rope, status::error_disabled, "field", rope.write_f64(f, 0, 1, 0, 1, {1}));
    }
    KEPT(rope, status::error_disabled, "field", rope.view(field::force));
    KEPT(rope, status::error_unsupported, "field", rope.view(field::pin));
    KEPT(rope, status::error_unsupported, "field", rope.disable_field(field::position));
    REFUSED(status::error_enum, "field", rope.enable_field(field::depth));
}

void combinations(chain& rope) {
    OK(rope.set_end(end::last, node::matched));
    KEPT(rope, status::error_unsupported, "", rope.set_ring(true));
    OK(rope.set_end(end::last, node::pinned));
    OK(rope.set_end(end::first, node::pinned));
    chain pair = GET(chain::create(1, 1, 2));
    OK(pair.set_end(end::first, node::pinned));
    OK(pair.set_end(end::last, node::driven));
    KEPT(pair, status::error_unsupported, "", pair.weld(0, 0));
    KEPT(pair, status::error_unsupported, "", pair.set_ring(true));
}

void lengths() {
    chain rope = GET(chain::create(2, 5, 2, precision::float64));
    for (double bad : {-1.0, nan_value, HUGE_VAL}) KEPT(rope, status::error_value, "length", rope.set_rest_length(bad));
    for (double bad : {0.0, 1.0, nan_value}) KEPT(rope, status::error_value, "tolerance", rope.set_tolerance(bad));
    KEPT(rope, status::error_value, "most_iterations", rope.set_tolerance(1e-6, 0));
    KEPT(rope, status::error_unsupported, "air", rope.set_air(0, 1));
    KEPT(rope, status::error_unsupported, "air", rope.set_wind({1, 1}));
    KEPT(rope, status::error_unsupported, "break", rope.set_strength(1));
    KEPT(rope, status::error_unsupported, "touch", rope.set_colliders(1));
    KEPT(rope, status::error_unsupported, "touch", rope.set_thickness(1));
    double two[2];
    KEPT(rope, status::error_unsupported, "tensions", rope.get_reaction(0, 0, two));
    for (field f : {field::rest_length, field::tension, field::strength, field::strain}) {
        KEPT(rope, status::error_unsupported, "field", rope.enable_field(f));
        KEPT(rope, status::error_unsupported, "field", rope.read_f64(f));
        KEPT(rope, status::error_unsupported, "field", rope.write_f64(f, 0, 1, 0, 1, {1}));
    }
    chain four = GET(chain::create(1, 5, 4)), single = GET(chain::create(1, 0, 2));
    KEPT(four, status::error_unsupported, "components", four.set_rest_length(1));
    KEPT(four, status::error_unsupported, "rest angles", four.set_rest_angle(1));
    for (double bad : {nan_value, HUGE_VAL, -12.6}) KEPT(rope, status::error_value, "angle", rope.set_rest_angle(bad));
    KEPT(single, status::error_unsupported, "springs", single.set_rest_length(1));

    OK(rope.set_rest_length(1));
    OK(rope.set_stiffness(HUGE_VAL));
    KEPT(rope, status::error_unsupported, "length", rope.set_rest_length(0));
    KEPT(rope, status::error_unsupported, "length", rope.stable_dt());
    KEPT(rope, status::error_unsupported, "field", rope.view(field::tension));
    KEPT(rope, status::error_unsupported, "field", rope.disable_field(field::tension));
    KEPT(rope, status::error_disabled, "field", rope.read_f64(field::rest_length));
    KEPT(rope, status::error_value, "values", rope.write_f64(field::tension, 0, 1, 0, 1, {nan_value}));
    for (double bad : {-1.0, 0.0, nan_value, -HUGE_VAL})
        KEPT(rope, status::error_value, "strength", rope.set_strength(bad));
    KEPT(rope, status::error_disabled, "field", rope.read_f64(field::strength));
    KEPT(rope, status::error_unsupported, "STRAIN", rope.write_f64(field::strain, 0, 1, 0, 1, {0}));
    KEPT(rope, status::error_unsupported, "field", rope.disable_field(field::strain));
    OK(rope.set_strength(1e9));
    KEPT(rope, status::error_unsupported, "STIFFNESS", rope.disable_field(field::stiffness));
    KEPT(rope, status::error_range, "strand", rope.get_reaction(2, 0, two));
    KEPT(rope, status::error_range, "node", rope.get_reaction(0, 6, two));
    KEPT(rope, status::error_range, "count", rope.get_reaction(0, 0, span<double>(two, 1)));
    KEPT(rope, status::error_value, "count", rope.set_colliders(4097));
    KEPT(rope, status::error_range, "index", rope.set_plane(0, {0, 0}, {0, 1}));
    KEPT(rope, status::error_range, "index", rope.get_collider(0, two, two, two));
    OK(rope.set_colliders(1));
    KEPT(rope, status::error_range, "count", rope.get_collider(0, {}, two, two));
    KEPT(rope, status::error_value, "normal", rope.set_plane(0, {0, 0}, {0, 0}));
    KEPT(rope, status::error_value, "friction", rope.set_plane(0, {0, 0}, {0, 1}, -1));
    KEPT(rope, status::error_range, "chain::set_plane", rope.set_plane(0, {0}, {0, 1}));
    KEPT(rope, status::error_range, "chain::set_capsule", rope.set_capsule(0, {0}, {0, 1}, 1));
    KEPT(rope, status::error_value, "radius", rope.set_capsule(0, {0, 0}, {0, 1}, 0));
    KEPT(rope, status::error_value, "columns", rope.set_bed(0, {0, 0}, 1, 1, 1, 0, {0}));
    KEPT(rope, status::error_range, "height_count", rope.set_bed(0, {0, 0}, 2, 1, 1, 0, {0}));
    KEPT(rope, status::error_range, "height_count", rope.get_bed(0, two));
    KEPT(rope, status::error_range, "index", rope.get_bed(1));
    KEPT(rope, status::error_null, "distance", rope.set_callback(0, nullptr, {0, 0}));
    const cd_distance no_function{};
    KEPT(rope, status::error_null, "distance", rope.set_callback(0, &no_function, {}));
    KEPT(rope, status::error_value, "velocity", rope.set_collider_velocity(0, {0, nan_value}));
    KEPT(rope, status::error_value, "radius", rope.set_thickness(-1));
    KEPT(rope, status::error_range, "index", rope.remove_collider(1));
    KEPT(rope, status::error_value, "along", rope.set_air(nan_value, 1));
    KEPT(rope, status::error_value, "across", rope.set_air(1, -1));
    KEPT(rope, status::error_value, "velocity", rope.set_wind({1, nan_value}));
    KEPT(rope, status::error_range, "count", rope.set_wind({1}));
    std::array<double, 3> three{};
    KEPT(rope, status::error_range, "count", rope.get_wind(three));
    OK(rope.set_lambda(0.25));
    KEPT(rope, status::error_unsupported, "lambda", rope.step(0.01));
    OK(rope.set_lambda(0.5));
    for (std::size_t i = 0; i < 6; ++i)
        OK(rope.write_f64(field::position, 0, 2, i, 1, {double(i) / 5, 0, double(i) / 5, 0}));
    OK(rope.set_end(end::first, node::pinned));
    OK(rope.set_gravity({0, -9.81}));
    OK(rope.set_tolerance(1e-14, 1));
    REFUSED(status::error_tolerance, "length", rope.step(0.5, 3));
    CHECK(GET(rope.get_steps()) == 3 && GET(rope.get_convergence()).residual > 1e-14);
}

void keeping(chain& rope) {
    std::vector<std::byte> saved = GET(rope.save());
    chain other = GET(chain::create(1, 5, 2)), sheetless;
    KEPT(other, status::error_mismatch, "", other.load(saved));
    KEPT(other, status::error_mismatch, "", other.copy_state(rope));
    KEPT(rope, status::error_format, "", rope.load(bytes(saved.data(), saved.size() - 1)));
    saved[saved.size() / 2] ^= std::byte{1};
    KEPT(rope, status::error_format, "", rope.load(saved));
    KEPT(rope, status::error_null, "source", rope.copy_state(sheetless));
}

void memory() {
    static bool empty;
    const cd_allocator allocator = {
        nullptr, [](void*, std::size_t size, std::size_t) { return empty ? nullptr : std::malloc(size); },
        [](void*, void* pointer, std::size_t, std::size_t) { std::free(pointer); }};
    empty = false;
    chain rope = GET(chain::create(2, 5, 2, precision::float64, &allocator));
    chain full = GET(chain::create(2, 5, 2, precision::float64));
    OK(full.enable_field(field::force));
    const std::vector<std::byte> saved = GET(full.save());
    empty = true;
    KEPT(rope, status::error_memory, "", rope.enable_field(field::force));
    KEPT(rope, status::error_memory, "", rope.set_bend(1));
    KEPT(rope, status::error_memory, "", rope.set_rest_length(1));
    KEPT(rope, status::error_memory, "", rope.attach(0, 0, 1, 1));
    KEPT(rope, status::error_memory, "", rope.cut(0, 0));
    KEPT(rope, status::error_memory, "", rope.weld(0, 0));
    KEPT(rope, status::error_memory, "", rope.load(saved));
    KEPT(rope, status::error_memory, "", rope.copy_state(full));
    REFUSED(status::error_memory, "", chain::create(1, 5, 2, precision::float64, &allocator));
}

void parallel_and_diverged() {
    chain rope = GET(chain::create(1, 20, 1, precision::float32));
    const cd_parallel none = {nullptr, nullptr};
    KEPT(rope, status::error_null, "run", rope.set_parallel(&none));
    OK(rope.set_method(method::forward_euler));
    OK(rope.impulse(0, 3, {1}));
    REFUSED(status::error_diverged, "", rope.step(100, 200));
    KEPT(rope, status::error_diverged, "", rope.teleport(0, {}, {1}));
    KEPT(rope, status::error_diverged, "", rope.set_end(end::first, node::posed));
    OK(rope.reset());
    OK(rope.step(0.001));
}

} // namespace

int main() {
    chain rope = GET(chain::create(2, 5, 2, precision::float64));
    numbers(rope);
    enumerators(rope);
    ranges(rope);
    fields(rope);
    combinations(rope);
    lengths();
    keeping(rope);
    memory();
    parallel_and_diverged();
    REFUSED(status::error_value, "strands", chain::create(0, 5, 2));
    REFUSED(status::error_size, "", chain::create(SIZE_MAX / 2, 5, 4));
    water pool = GET(water::create(2, 2, 1, 1));
    chain no_chain(reinterpret_cast<cd_chain*>(pool.handle()));
    REFUSED(status::error_handle, "chain", no_chain.get_mass());
    CHECK(no_chain.release() != nullptr);
    REFUSED(status::error_null, "chain", no_chain.get_mass());
}
