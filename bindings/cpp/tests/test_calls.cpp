// Every function of the library is called by its C++ name, with an answer that is known.
#include "check.hpp"

#include <array>
#include <cmath>
#include <string>

using namespace contdyn;

namespace {

struct vertex {
    float position[3], normal[3], depth;
};

bool near(double a, double b) { return std::fabs(a - b) <= 1e-9 * (1 + std::fabs(b)); }

// Counts the pieces of work that a step is dealt out to.
cd_parallel counting(std::size_t& pieces) {
    return {&pieces, [](void* user, std::size_t count, void (*task)(void*, std::size_t), void* context) {
                *static_cast<std::size_t*>(user) += count;
                for (std::size_t i = 0; i < count; ++i) task(context, i);
            }};
}

// What all three objects have. `f` is a field that is always there, `g` one to switch on.
template <class Object> void common(Object& object, Object& other, field f, field g) {
    OK(object.set_method(method::symplectic_euler));
    CHECK(GET(object.get_method()) == method::symplectic_euler);
    OK(object.set_method(method::implicit));
    OK(object.set_lambda(0.75));
    CHECK(GET(object.get_lambda()) == 0.75);
    OK(object.set_drag(0.5));
    CHECK(GET(object.get_drag()) == 0.5);
    CHECK(GET(object.get_kernels()) == runnable_kernels().back());
    OK(object.set_kernels(kernels::plain));
    CHECK(GET(object.get_kernels()) == kernels::plain);

    const std::size_t before = GET(object.get_memory());
    OK(object.enable_field(g));
    CHECK(GET(object.get_memory()) > before);
    OK(object.disable_field(g));
    CHECK(GET(object.get_memory()) == before);

    const std::size_t size = GET(object.get_size(f));
    std::vector<double> doubles(size, 0.25), back(size);
    OK(object.write_f64(f, doubles));
    CHECK(GET(object.read_f64(f)) == doubles);
    std::vector<float> floats(size, 0.5f);
    OK(object.write_f32(f, floats));
    CHECK(GET(object.read_f32(f)) == floats);

    CHECK(GET(object.stable_dt()) > 0);
    OK(object.step(0.01));
    OK(object.step(0.01, 3));
    CHECK(near(GET(object.get_time()), 0.04) && GET(object.get_steps()) == 4);
    CHECK(GET(object.get_factorizations()) > 0);

    const std::vector<std::byte> saved = GET(object.save());
    CHECK(saved.size() == GET(object.save_size()));
    std::vector<unsigned char> buffer(saved.size() + 1);
    CHECK(GET(object.save(buffer)) == saved.size() && std::memcmp(buffer.data(), saved.data(), saved.size()) == 0);
    const std::uint64_t hash = GET(object.hash());
    OK(other.load(saved));
    CHECK(GET(other.hash()) == hash);
    OK(object.reset());
    CHECK(GET(object.get_steps()) == 0 && GET(object.hash()) != hash);
    OK(object.copy_state(other));
    CHECK(GET(object.hash()) == hash);
    OK(object.reset());
}

// What chains and membranes have.
template <class Object> void body(Object& object) {
    OK(object.set_mass(4));
    CHECK(GET(object.get_mass()) == 4);
    OK(object.set_mass_rule(mass_rule::half_ends));
    CHECK(GET(object.get_mass_rule()) == mass_rule::half_ends);
    OK(object.set_bend(0.125));
    CHECK(GET(object.get_bend()) == 0.125);
    OK(object.set_stiffness_damping(0.25));
    CHECK(GET(object.get_stiffness_damping()) == 0.25);
    OK(object.set_gravity({0, -9.81}));
    std::array<double, 2> numbers{};
    OK(object.get_gravity(numbers));
    CHECK(numbers[0] == 0 && numbers[1] == -9.81);
    OK(object.get_momentum(numbers));
    const auto energy = GET(object.get_energy());
    CHECK(std::isfinite(energy.kinetic) && std::isfinite(energy.elastic) && std::isfinite(energy.gravity));
}

void chains() {
    chain rope = GET(chain::create(2, 6, 2, precision::float64)),
          other = GET(chain::create(2, 6, 2, precision::float64));
    const chain::shape shape = GET(rope.get_shape());
    CHECK(shape.strands == 2 && shape.springs == 6 && shape.components == 2 && shape.precision == precision::float64);
    common(rope, other, field::position, field::force);
    body(rope);
    OK(rope.set_stiffness(3));
    CHECK(GET(rope.get_stiffness()) == 3);
    OK(rope.set_end(end::first, node::pinned));
    CHECK(GET(rope.get_end(end::first)) == node::pinned && GET(rope.get_end(end::last)) == node::free);
    OK(rope.set_ring(true));
    CHECK(GET(rope.get_ring()));
    OK(rope.set_ring(false));

    OK(rope.write_f64(field::position, 1, 1, 2, 2, {1, 2, 3, 4}));
    std::array<float, 4> floats{};
    OK(rope.read_f32(field::position, 1, 1, 2, 2, floats));
    CHECK((floats == std::array<float, 4>{1, 2, 3, 4}));
    OK(rope.write_f32(field::position, 0, 1, 6, 1, {5, 6}));
    std::array<double, 2> pair{};
    OK(rope.read_f64(field::position, 0, 1, 6, 1, pair));
    CHECK(pair[0] == 5 && pair[1] == 6);
    CHECK(GET(rope.view(field::position))(1, 3, 1) == 4);
    OK(rope.sample(1, {2.5}, outside::refused, pair));
    CHECK(pair[0] == 2 && pair[1] == 3);

    OK(rope.reset());
    OK(rope.impulse(0, 3, {1, 2}));
    OK(rope.get_momentum(pair));
    CHECK(near(pair[0], 1) && near(pair[1], 2));
    OK(rope.attach(0, 5, 10, 0.5, {1, 1}));
    OK(rope.attach(0, 4, 7, 0));
    CHECK(GET(rope.get_attachment(0, 5)).stiffness == 10 && GET(rope.get_attachment(0, 5)).damping == 0.5);
    OK(rope.detach(0, 5));
    CHECK(GET(rope.get_attachment(0, 5)).stiffness == 0);
    OK(rope.cut(0, 2));
    OK(rope.weld(0, 4));
    const std::vector<double> springs = GET(rope.read_f64(field::stiffness));
    CHECK(springs.size() == 6 && springs[2] == 0 && std::isinf(springs[4]));
    rope.destroy();
}

// Two strands that hang from their first nodes, in springs that have a length.
void ropes() {
    chain rope = GET(chain::create(2, 4, 3, precision::float32));
    std::vector<double> straight;
    for (int i = 0; i < 10; ++i) straight.insert(straight.end(), {0, 0, -(i % 5) / 4.0});
    OK(rope.write_f64(field::position, straight));
    OK(rope.set_rest_length(1));
    CHECK(GET(rope.get_rest_length()) == 1);
    OK(rope.set_stiffness(HUGE_VAL));
    CHECK(std::isinf(GET(rope.get_stiffness())));
    OK(rope.set_push(true));
    CHECK(GET(rope.get_push()));
    OK(rope.set_push(false));
    chain blade = GET(chain::create(2, 3, 2));
    OK(blade.set_rest_length(1));
    OK(blade.set_rest_angle(1));
    CHECK(GET(blade.get_rest_angle()) == 1);
    OK(blade.enable_field(field::rest_angle));
    CHECK(GET(blade.read_f64(field::rest_angle)) == std::vector<double>(8, 0.5));
    OK(rope.set_tolerance(1e-5));
    OK(rope.set_tolerance(1e-6, 50));
    const stopping limits = GET(rope.get_tolerance());
    CHECK(limits.tolerance == 1e-6 && limits.most_iterations == 50);
    OK(rope.set_gravity({0, 0, -10}));
    OK(rope.set_end(end::first, node::pinned));
    OK(rope.step(1 / 60.0, 60));
    const convergence reached = GET(rope.get_convergence());
    CHECK(reached.iterations > 0 && reached.residual <= 1e-6);

    CHECK(GET(rope.get_size(field::tension)) == 8);
    const std::vector<double> tensions = GET(rope.read_f64(field::tension));
    for (std::size_t i = 0; i < tensions.size(); ++i)
        CHECK(std::fabs(tensions[i] - 2.0 * double(4 - i % 4)) < 1e-4); // what hangs below
    OK(rope.write_f64(field::tension, 1, 1, 2, 2, {1, 2}));
    std::array<double, 2> pair{};
    OK(rope.read_f64(field::tension, 1, 1, 2, 2, pair));
    CHECK(pair[0] == 1 && pair[1] == 2);
    OK(rope.enable_field(field::rest_length));
    CHECK(GET(rope.read_f64(field::rest_length)) == std::vector<double>(8, 0.25)); // two strands have their own
    OK(rope.cut(1, 3));
    const std::vector<double> stiffnesses = GET(rope.read_f64(field::stiffness));
    CHECK(stiffnesses.size() == 8 && stiffnesses[3] > 0 && stiffnesses[7] == 0);

    std::array<double, 3> force{};
    OK(rope.get_reaction(0, 0, force)); // what hangs at its first node
    CHECK(force[0] == 0 && force[1] == 0 && std::fabs(force[2] + 8) < 1e-4);
    CHECK(GET(rope.get_size(field::strain)) == 8);
    for (double strain : GET(rope.read_f64(field::strain))) CHECK(std::fabs(strain) < 1e-5);
    OK(rope.enable_field(field::bend)); // two strands have their own
    CHECK(GET(rope.get_size(field::bend)) == 10 && GET(rope.read_f64(field::bend)) == std::vector<double>(10, 0));
    OK(rope.disable_field(field::bend));
    CHECK(std::isinf(GET(rope.get_strength())) && GET(rope.get_broken()) == 0);
    OK(rope.set_strength(7));
    CHECK(GET(rope.get_strength()) == 7);
    OK(rope.enable_field(field::strength));
    CHECK(GET(rope.read_f64(field::strength)) == std::vector<double>(8, 7));
    OK(rope.write_f64(field::strength, 1, 1, 0, 4, {100, 100, 100, 100}));
    OK(rope.step(1 / 60.0)); // the first spring of the first strand bears 8 N
    CHECK(GET(rope.get_broken()) == 1 && GET(rope.read_f64(field::stiffness))[0] == 0);
    OK(rope.set_strength(HUGE_VAL));
    OK(rope.disable_field(field::strength));

    CHECK(GET(rope.get_sleep()).speed == 0 && GET(rope.get_awake()) == 10);
    OK(rope.set_sleep(0.125, 0.5));
    CHECK(GET(rope.get_sleep()).speed == 0.125 && GET(rope.get_sleep()).seconds == 0.5);
    OK(rope.set_sleep(0, 0));
    OK(rope.set_air(0.25, 2));
    CHECK(GET(rope.get_air()).along == 0.25 && GET(rope.get_air()).across == 2);
    OK(rope.set_wind({1, 0, -1}));
    std::array<double, 3> wind{};
    OK(rope.get_wind(wind));
    CHECK((wind == std::array<double, 3>{1, 0, -1}));
    OK(rope.enable_field(field::wind));
    CHECK(GET(rope.get_size(field::wind)) == 30);
    CHECK(GET(rope.read_f64(field::wind))[27] == 1);
    OK(rope.step(1 / 60.0, 3));
    OK(rope.set_stiffness(1));
    OK(rope.set_rest_length(0));
    OK(rope.step(1 / 60.0));
    CHECK(GET(rope.get_convergence()).iterations == 0 && GET(rope.get_convergence()).residual == 0);
}

// What ropes touch.
void colliders() {
    chain rope = GET(chain::create(1, 4, 2, precision::float64));
    OK(rope.set_rest_length(1));
    OK(rope.set_gravity({0, -10}));
    OK(rope.write_f64(field::position, 0, 1, 0, 5, {0, 0.1, 0.25, 0.1, 0.5, 0.1, 0.75, 0.1, 1, 0.1}));
    CHECK(GET(rope.get_colliders()) == 0 && GET(rope.get_thickness()) == 0);
    OK(rope.set_colliders(2));
    OK(rope.set_thickness(0.0625));
    CHECK(GET(rope.get_colliders()) == 2 && GET(rope.get_thickness()) == 0.0625);
    CHECK(!GET(rope.get_loads()));
    OK(rope.set_loads(true));
    CHECK(GET(rope.get_loads()));
    OK(rope.set_plane(0, {0, -1}, {0, 5}, 0.5));
    OK(rope.set_capsule(1, {7, 8}, {9, 8}, 0.25));
    OK(rope.set_collider_velocity(0, {0.5, 0}));
    OK(rope.step(0.01, 200));
    std::array<double, 2> first{}, second{}, velocity{};
    const collider plane = GET(rope.get_collider(0, first, second, velocity));
    CHECK(plane.shape == contdyn::shape::plane && plane.friction == 0.5);
    CHECK(near(first[0], 1) && second[1] == 1 && velocity[0] == 0.5);
    const collider capsule = GET(rope.get_collider(1, first, second, velocity));
    CHECK(capsule.shape == contdyn::shape::capsule && second[0] == 9 && capsule.radius == 0.25);
    for (std::size_t i = 1; i < 10; i += 2) CHECK(std::fabs(GET(rope.read_f64(field::position))[i] + 0.9375) < 1e-6);
    std::array<double, 6> load{};
    OK(rope.get_collider_load(0, load)); // its weight
    CHECK(std::fabs(load[1] + 10) < 1e-6 && load[2] == 0 && load[3] == 0);
    OK(rope.remove_collider(1));
    CHECK(GET(rope.get_collider(1, first, second, velocity)).shape == contdyn::shape::none);
}

// A floor 1 below, which counts how often it is asked.
void tell_floor(void* user, double, std::size_t count, std::size_t components, const double* positions,
                double* distances, double* normals) {
    ++*static_cast<int*>(user);
    for (std::size_t i = 0; i < count; ++i) {
        distances[i] = positions[i * components + 1] + 1;
        for (std::size_t k = 0; k < components; ++k) normals[i * components + k] = k == 1;
    }
}

// A bed, and a shape by callback: get_bed tells what was set, and they carry what falls on them.
void beds_and_callbacks() {
    int asked = 0;
    const cd_distance floor = {&asked, tell_floor};
    chain rope = GET(chain::create(1, 4, 2, precision::float64));
    OK(rope.set_rest_length(1));
    OK(rope.set_gravity({0, -10}));
    OK(rope.write_f64(field::position, 0, 1, 0, 5, {0, 0.1, 0.25, 0.1, 0.5, 0.1, 0.75, 0.1, 1, 0.1}));
    OK(rope.set_colliders(2));
    OK(rope.set_bed(0, {-1, -2}, 3, 1, 1.5, 0, {0.5, 0.5, 0.5}, 0.25));
    const lattice size = GET(rope.get_bed(0));
    CHECK(size.columns == 3 && size.rows == 1 && GET(rope.get_bed(1)).columns == 0);
    std::array<double, 3> heights{};
    CHECK(GET(rope.get_bed(0, heights)).columns == 3);
    CHECK(heights[0] == 0.5 && heights[2] == 0.5);
    OK(rope.set_callback(1, &floor, {0, 0}, 0.5));
    OK(rope.set_callback(1, &floor, {}));
    std::array<double, 2> first{}, second{}, velocity{};
    const collider bed = GET(rope.get_collider(0, first, second, velocity));
    CHECK(bed.shape == contdyn::shape::bed && bed.friction == 0.25 && first[1] == -2 && second[0] == 1.5);
    CHECK(GET(rope.get_collider(1, first, second, velocity)).shape == contdyn::shape::callback);
    OK(rope.step(0.01, 200));
    CHECK(asked >= 200);
    for (std::size_t i = 1; i < 10; i += 2) CHECK(std::fabs(GET(rope.read_f64(field::position))[i] + 1) < 1e-6);

    membrane rug = GET(membrane::create(2, 2, 3, precision::float64));
    OK(rug.set_rest_length(1, 1));
    for (std::size_t i = 0; i < 9; ++i)
        OK(rug.write_f64(field::position, i % 3, i / 3, 1, 1, {0.5 * double(i % 3), 0, 0.5 * double(i / 3)}));
    OK(rug.set_gravity({0, -10, 0}));
    OK(rug.set_colliders(2));
    OK(rug.set_bed(0, {-1, -2, -3}, 3, 2, 1.5, 2, {0.5, 0.5, 0.5, 0.25, 0.25, 0.25}));
    CHECK(GET(rug.get_bed(0)).columns == 3 && GET(rug.get_bed(0)).rows == 2);
    std::array<double, 6> of_rug{};
    CHECK(GET(rug.get_bed(0, of_rug)).rows == 2);
    CHECK(of_rug[2] == 0.5 && of_rug[5] == 0.25);
    OK(rug.set_callback(1, &floor, {0, 0.5, 0}));
    OK(rug.set_callback(1, &floor, {}));
    asked = 0;
    OK(rug.step(0.01, 200));
    CHECK(asked == 200);
    CHECK(std::fabs(GET(rug.read_f64(field::position))[1] + 0.5) < 1e-3);
}

// A sheet of 20 nodes that hangs from an edge, in springs that have a length; then in the wind, and on what it touches.
void cloth() {
    membrane sheet = GET(membrane::create(4, 3, 3, precision::float64));
    std::vector<double> straight;
    for (int v = 0; v <= 3; ++v) {
        for (int u = 0; u <= 4; ++u) straight.insert(straight.end(), {u / 4.0, 0, -v / 4.0});
    }
    OK(sheet.write_f64(field::position, straight));
    CHECK(GET(sheet.get_rest_length()).along_u == 0 && GET(sheet.get_rest_length()).along_v == 0);
    OK(sheet.set_rest_length(1, 0.75));
    CHECK(GET(sheet.get_rest_length()).along_u == 1 && GET(sheet.get_rest_length()).along_v == 0.75);
    CHECK(GET(sheet.get_lambda()) == 1);
    OK(sheet.set_stiffness(1e4, 1e4));
    OK(sheet.set_shear(0.25));
    CHECK(GET(sheet.get_shear()) == 0.25);
    CHECK(GET(sheet.get_compression()) > 0);
    OK(sheet.set_compression(0.5));
    CHECK(GET(sheet.get_compression()) == 0.5);
    CHECK(GET(sheet.get_effort()).newton == 3 && GET(sheet.get_effort()).gradient == 0);
    OK(sheet.set_effort(8, 60));
    OK(sheet.set_sleep(0.125, 0.5));
    CHECK(GET(sheet.get_sleep()).speed == 0.125 && GET(sheet.get_sleep()).seconds == 0.5);
    CHECK(GET(sheet.get_awake()) == 20);
    OK(sheet.set_sleep(0, 0));
    CHECK(GET(sheet.get_effort()).newton == 8 && GET(sheet.get_effort()).gradient == 60);
    CHECK(std::isinf(GET(sheet.get_breaking_strain())) && GET(sheet.get_broken()) == 0);
    OK(sheet.set_gravity({0, 0, -10}));
    OK(sheet.set_edge(edge::v_first, node::pinned));
    OK(sheet.step(1 / 60.0, 120));
    const convergence reached = GET(sheet.get_convergence());
    CHECK(reached.iterations > 0 && reached.residual >= 0 && reached.residual < 1);

    CHECK(GET(sheet.get_size(field::tension_u)) == 16 && GET(sheet.get_size(field::strain_u)) == 16);
    CHECK(GET(sheet.get_size(field::tension_v)) == 15 && GET(sheet.get_size(field::strain_v)) == 15);
    const std::vector<double> tensions = GET(sheet.read_f64(field::tension_v));
    for (std::size_t i = 0; i < tensions.size(); ++i)
        CHECK(std::fabs(tensions[i] - 0.5 * double(3 - i / 5)) < 1e-2); // what hangs below
    for (double strain : GET(sheet.read_f64(field::strain_v))) CHECK(strain > 0 && strain < 0.006);
    OK(sheet.enable_field(field::rest_length_u));
    OK(sheet.enable_field(field::rest_length_v));
    CHECK(GET(sheet.read_f64(field::rest_length_u)) == std::vector<double>(16, 0.25));
    OK(sheet.write_f64(field::rest_length_v, 4, 2, 1, 1, {0.5}));
    CHECK(GET(sheet.read_f64(field::rest_length_v)).back() == 0.5);

    OK(sheet.set_breaking_strain(0.5));
    CHECK(GET(sheet.get_breaking_strain()) == 0.5);
    OK(sheet.enable_field(field::breaking_strain_u));
    CHECK(GET(sheet.read_f64(field::breaking_strain_u)) == std::vector<double>(16, 0.5));
    OK(sheet.enable_field(field::breaking_strain_v));
    OK(sheet.write_f64(field::breaking_strain_v, 0, 1, 5, 1, {1e-4, 1e-4, 1e-4, 1e-4, 1e-4}));
    OK(sheet.step(1 / 60.0, 2));
    CHECK(GET(sheet.get_broken()) == 5 && GET(sheet.read_f64(field::stiffness_v))[7] == 0); // of a row

    OK(sheet.set_air(0.25, 2));
    CHECK(GET(sheet.get_air()).along == 0.25 && GET(sheet.get_air()).across == 2);
    OK(sheet.set_wind({1, 0, -1}));
    std::array<double, 3> wind{};
    OK(sheet.get_wind(wind));
    CHECK((wind == std::array<double, 3>{1, 0, -1}));
    OK(sheet.enable_field(field::wind));
    CHECK(GET(sheet.get_size(field::wind)) == 60);
    CHECK(GET(sheet.read_f64(field::wind))[57] == 1);
    OK(sheet.step(1 / 60.0, 3));
    CHECK(GET(sheet.get_solver_taken()) == solver::auto_);
    OK(sheet.set_rest_length(0, 0));
    OK(sheet.set_solver(solver::alternating));
    OK(sheet.step(1 / 60.0));
    CHECK(GET(sheet.get_solver_taken()) == solver::alternating);
    CHECK(GET(sheet.get_convergence()).iterations == 0 && GET(sheet.get_convergence()).residual == 0);

    membrane rug = GET(membrane::create(4, 3, 3, precision::float64));
    for (std::size_t i = 1; i < straight.size(); i += 3) straight[i] = 0.1;
    OK(rug.write_f64(field::position, straight));
    OK(rug.set_rest_length(1, 0.75));
    OK(rug.set_gravity({0, -10, 0}));
    CHECK(GET(rug.get_colliders()) == 0 && GET(rug.get_thickness()) == 0);
    OK(rug.set_colliders(2));
    OK(rug.set_thickness(0.0625));
    CHECK(GET(rug.get_colliders()) == 2 && GET(rug.get_thickness()) == 0.0625);
    CHECK(!GET(rug.get_loads()));
    OK(rug.set_loads(true));
    CHECK(GET(rug.get_loads()));
    OK(rug.set_plane(0, {0, -1, 0}, {0, 5, 0}, 0.5));
    OK(rug.set_capsule(1, {7, 8, 9}, {9, 8, 9}, 0.25));
    OK(rug.set_collider_velocity(0, {0.5, 0, 0}));
    OK(rug.step(0.01, 200));
    std::array<double, 3> first{}, second{}, velocity{};
    const collider plane = GET(rug.get_collider(0, first, second, velocity));
    CHECK(plane.shape == contdyn::shape::plane && plane.friction == 0.5);
    CHECK(near(first[0], 1) && second[1] == 1 && velocity[0] == 0.5);
    const collider capsule = GET(rug.get_collider(1, first, second, velocity));
    CHECK(capsule.shape == contdyn::shape::capsule && second[0] == 9 && capsule.radius == 0.25);
    const std::vector<double> lying = GET(rug.read_f64(field::position));
    for (std::size_t i = 1; i < lying.size(); i += 3) CHECK(std::fabs(lying[i] + 0.9375) < 1e-5);
    std::array<double, 6> load{};
    OK(rug.get_collider_load(0, load));
    CHECK(load[1] < 0);
    OK(rug.remove_collider(1));
    CHECK(GET(rug.get_collider(1, first, second, velocity)).shape == contdyn::shape::none);
}

// A strand and a sheet that are led, then put elsewhere; turned by a quarter where there is a rotation.
void posed() {
    chain rope = GET(chain::create(2, 2, 2, precision::float64));
    OK(rope.set_end(end::last, node::posed));
    CHECK(GET(rope.get_end(end::last)) == node::posed);
    OK(rope.write_f64(field::target, 0, 2, 2, 1, {1, 2, 3, 4}));
    OK(rope.step(0.125, 4));
    std::array<double, 2> place{}, other{};
    const auto last = [&](std::size_t strand) { OK(rope.read_f64(field::position, strand, 1, 2, 1, place)); };
    last(1);
    CHECK(near(place[0], 3) && near(place[1], 4));
    OK(rope.teleport(0, {0, -1, 1, 0}, {10, 20}));
    last(0);
    CHECK(near(place[0], 8) && near(place[1], 21));
    last(1);
    CHECK(near(place[0], 3) && near(place[1], 4));
    OK(rope.teleport(1, {}, {10, 20}));
    last(1);
    CHECK(near(place[0], 13) && near(place[1], 24));
    OK(rope.read_f64(field::target, 1, 1, 2, 1, other));
    CHECK(near(other[0], 13) && near(other[1], 24));
    OK(rope.step(0.5));
    last(1);
    CHECK(near(place[0], 13) && near(place[1], 24)); // where it was put it stays

    membrane sheet = GET(membrane::create(2, 1, 2, precision::float64));
    OK(sheet.set_edge(edge::u_last, node::posed));
    CHECK(GET(sheet.get_edge(edge::u_last)) == node::posed);
    OK(sheet.write_f64(field::target, 2, 0, 1, 2, {1, 2, 3, 4}));
    OK(sheet.step(0.125, 4));
    OK(sheet.read_f64(field::position, 2, 1, 1, 1, place));
    CHECK(near(place[0], 3) && near(place[1], 4));
    OK(sheet.teleport({0, -1, 1, 0}, {10, 20}));
    OK(sheet.teleport({}, {0, 1}));
    OK(sheet.read_f64(field::position, 2, 1, 1, 1, place));
    CHECK(near(place[0], 6) && near(place[1], 24));
}

void membranes() {
    membrane sheet = GET(membrane::create(5, 4, 2, precision::float32)), other = GET(membrane::create(5, 4, 2));
    const membrane::shape shape = GET(sheet.get_shape());
    CHECK(shape.nu == 5 && shape.nv == 4 && shape.components == 2 && shape.precision == precision::float32);
    OK(sheet.set_solver(solver::alternating)); // coupled, a sheet with a mask may take less memory
    common(sheet, other, field::position, field::mask);
    body(sheet);
    OK(sheet.set_stiffness(3, 4));
    CHECK(GET(sheet.get_stiffness()).along_u == 3 && GET(sheet.get_stiffness()).along_v == 4);
    OK(sheet.set_ring(true, false));
    CHECK(GET(sheet.get_ring()).along_u && !GET(sheet.get_ring()).along_v);
    OK(sheet.enable_field(field::stiffness_u));
    CHECK(GET(sheet.get_size(field::stiffness_u)) == 30 && GET(sheet.read_f64(field::stiffness_u)).size() == 30);
    OK(sheet.set_ring(false, false));
    CHECK(GET(sheet.get_size(field::stiffness_u)) == 25 && GET(sheet.get_size(field::stiffness_v)) == 24);
    OK(sheet.disable_field(field::stiffness_u));
    OK(sheet.set_edge(edge::v_last, node::driven));
    CHECK(GET(sheet.get_edge(edge::v_last)) == node::driven);

    OK(sheet.write_f64(field::position, 1, 2, 2, 1, {1, 2, 3, 4}));
    std::array<float, 4> floats{};
    OK(sheet.read_f32(field::position, 1, 2, 2, 1, floats));
    CHECK((floats == std::array<float, 4>{1, 2, 3, 4}));
    OK(sheet.write_f32(field::position, 5, 4, 1, 1, {5, 6}));
    std::array<double, 2> pair{};
    OK(sheet.read_f64(field::position, 5, 4, 1, 1, pair));
    CHECK(pair[0] == 5 && pair[1] == 6);
    CHECK(GET(sheet.view(field::position))(2, 2, 1) == 4);
    OK(sheet.sample({1.5, 2}, outside::nearest, pair));
    CHECK(pair[0] == 2 && pair[1] == 3);

    OK(sheet.reset());
    OK(sheet.impulse(2, 1, 0, {1, 2}));
    OK(sheet.get_momentum(pair));
    CHECK(near(pair[0], 1) && near(pair[1], 2));
    OK(sheet.attach(3, 2, 10, 0.5, {1, 1}));
    OK(sheet.attach(2, 2, 7, 0));
    CHECK(GET(sheet.get_attachment(3, 2)).stiffness == 10 && GET(sheet.get_attachment(3, 2)).damping == 0.5);
    OK(sheet.detach(3, 2));
    CHECK(GET(sheet.get_attachment(3, 2)).stiffness == 0);
    OK(sheet.get_reaction(3, 2, pair)); // all lies at the origin, and attachments do not count
    CHECK(near(pair[0], 0) && near(pair[1], 0));
    OK(sheet.set_solver(solver::coupled));
    CHECK(GET(sheet.get_solver()) == solver::coupled);
    OK(sheet.set_tolerance(1e-8, 50));
    const stopping limits = GET(sheet.get_tolerance());
    CHECK(limits.tolerance == 1e-8 && limits.most_iterations == 50);
    OK(sheet.step(0.01, 2));
    CHECK(GET(sheet.get_convergence()).iterations > 0 && GET(sheet.get_convergence()).residual <= 1e-8);

    membrane drum = GET(membrane::create(2, 2, 3));
    OK(drum.set_pressure(5));
    CHECK(GET(drum.get_pressure()) == 5);
    OK(drum.set_pressure(0));
    std::vector<double> square;
    for (int v = 0; v <= 2; ++v) {
        for (int u = 0; u <= 2; ++u) square.insert(square.end(), {u / 2.0, v / 2.0, 3.0});
    }
    OK(drum.write_f64(field::position, square));
    CHECK(near(GET(drum.get_volume()), 1)); // a pyramid of height 3 over the unit square
    std::vector<vertex> vertices(9);
    OK(drum.write_vertices(vertices, sizeof(vertex), offsetof(vertex, position), offsetof(vertex, normal)));
    CHECK(vertices[8].position[0] == 1 && vertices[8].position[2] == 3 && vertices[4].normal[2] == 1);
    OK(drum.write_vertices(vertices, sizeof(vertex), offsetof(vertex, normal)));
    CHECK(vertices[4].normal[0] == 0.5f);
    std::vector<std::uint16_t> indices(GET(drum.get_index_count()));
    OK(drum.write_indices(indices, sizeof indices[0]));
    CHECK(indices.size() == 24 && indices[0] < 9);
    drum.destroy();
}

void waters() {
    water pool = GET(water::create(6, 5, 0.5, 2)), other = GET(water::create(6, 5, 0.5, 2));
    const water::shape shape = GET(pool.get_shape());
    CHECK(shape.nx == 6 && shape.ny == 5 && shape.dx == 0.5 && shape.dy == 2 && shape.precision == precision::float32);
    common(pool, other, field::depth, field::pressure);
    OK(pool.set_gravity(9));
    CHECK(GET(pool.get_gravity()) == 9);
    OK(pool.set_density(900));
    CHECK(GET(pool.get_density()) == 900);
    OK(pool.set_sleep(0.125));
    CHECK(GET(pool.get_sleep()) == 0.125 && GET(pool.get_awake()) == 30);
    OK(pool.set_sleep(0));
    OK(pool.set_manning(0.03));
    CHECK(GET(pool.get_manning()) == 0.03);
    OK(pool.set_momentum(momentum::advected));
    CHECK(GET(pool.get_momentum()) == momentum::advected);
    OK(pool.set_momentum(momentum::linear));
    OK(pool.set_first(true));
    CHECK(GET(pool.get_first()));
    OK(pool.set_side(side::x_first, border::open, 2, -0.5));
    const water::boundary sea = GET(pool.get_side(side::x_first));
    CHECK(sea.kind == border::open && sea.value == 2 && sea.rate == -0.5);
    OK(pool.set_inflow_depth(side::x_first, 0.5));
    CHECK(GET(pool.get_inflow_depth(side::x_first)) == 0.5);
    OK(pool.set_inflow_depth(side::x_first, 0));
    OK(pool.set_side(side::x_first, border::wall));
    OK(pool.set_bed_rule(bed_rule::keeps_surface));
    CHECK(GET(pool.get_bed_rule()) == bed_rule::keeps_surface);
    OK(pool.set_bed_rule(bed_rule::lifts_water));

    OK(pool.write_f64(field::bed, 1, 2, 2, 1, {0.5, 0.25}));
    std::array<float, 2> floats{};
    OK(pool.read_f32(field::bed, 1, 2, 2, 1, floats));
    CHECK(floats[0] == 0.5f && floats[1] == 0.25f);
    OK(pool.write_f32(field::bed, 5, 4, 1, 1, {0.125f}));
    std::array<double, 1> number{};
    OK(pool.read_f64(field::bed, 5, 4, 1, 1, number));
    CHECK(number[0] == 0.125 && GET(pool.view(field::bed))(2, 2) == 0.25);
    CHECK(GET(pool.get_size(field::velocity_x)) == 35 && GET(pool.get_size(field::velocity_y)) == 36);

    OK(pool.write_f64(field::bed, std::vector<double>(30, 0)));
    OK(pool.write_f64(field::depth, std::vector<double>(30, 1)));
    CHECK(near(GET(pool.get_volume()), 30) && near(GET(pool.get_wet_area()), 30));
    CHECK(near(GET(pool.add_volume(1, 5, 1, 2)), 2) && near(GET(pool.add_volume_rectangle(0, 0, 2, 2, -1)), -1));
    const water::account account = GET(pool.get_account());
    CHECK(near(account.initial, 30) && near(account.in, 2) && near(account.out, 1) && near(account.error, 0));
    OK(pool.restart_account());
    CHECK(near(GET(pool.get_account()).initial, 31));
    CHECK(near(GET(pool.get_energy()).kinetic, 0) && GET(pool.get_energy()).potential > 0);
    CHECK(GET(pool.get_courant(0.1)) > 0.5);
    OK(pool.splash(1.5, 5, 1, 0.25));
    OK(pool.impulse(1.5, 5, 1, 100, 0));
    CHECK(GET(pool.get_energy()).kinetic > 0);
    OK(pool.add_source(1, 1, 1, 0.5));
    OK(pool.add_source_rectangle(4, 4, 1, 1, -500)); // more than is there: the drain is held back
    OK(pool.step(0.1, 3));
    const water::limited held = GET(pool.get_limited());
    CHECK(held.volume >= 0);

    water lake = GET(water::create(16, 16, 1, 1, precision::float64));
    OK(lake.add_volume_rectangle(0, 0, 16, 16, 512));
    OK(lake.set_hulls(2, 2, 1));
    CHECK(GET(lake.get_hulls()).count == 2 && GET(lake.get_hulls()).n_along == 2);
    OK(lake.set_hull(0, 1000, 4, 2, {0, 0.25}));
    OK(lake.set_disc(1, 500, 1.5));
    std::array<double, 2> heights{};
    CHECK(GET(lake.get_hull(0, heights)).area == 8 && heights[1] == 0.25 &&
          near(GET(lake.get_hull(1)).area, 7.0685834705770345));
    OK(lake.set_hull(0, 1000, 4, 2));
    OK(lake.set_hull_drag(0, 10, 20, 0.5));
    CHECK(GET(lake.get_hull_drag(0)).across == 20);
    OK(lake.launch_hull(0, 8, 8, 0, 1));
    std::array<double, 7> pose{}, floor{};
    std::array<double, 6> six{};
    OK(lake.get_hull_pose(0, pose));
    OK(lake.get_hull_floor(0, floor));
    CHECK(pose[4] == 1 && std::fabs(floor[2] - (2 + 1.0 / 256 - 0.125)) < 1e-3);
    OK(lake.set_hull_pose(0, pose));
    OK(lake.set_hull_force(0, {100, 0, 0, 0, 0, 0}));
    OK(lake.set_hull_velocity(0, {0, 0.5, 0, 0, 0, 0}));
    OK(lake.step(0.1));
    OK(lake.get_hull_force(0, six));
    CHECK(six[0] == 100);
    OK(lake.get_hull_velocity(0, six));
    CHECK(six[1] > 0.4);
    OK(lake.get_hull_load(0, six));
    CHECK(six[2] > 0);
    CHECK(GET(lake.get_hull_energy()).kinetic > 100);
    const double under[] = {8, 8};
    double head[1];
    OK(lake.sample_heads(under, outside::refused, head));
    CHECK(head[0] > 1.9);
    OK(lake.remove_hull(0));

    water still = GET(water::create(4, 4, 1, 1));
    OK(still.add_volume_rectangle(0, 0, 4, 4, 32));
    const double at[] = {1, 1, 2.5, 2};
    double surface[2], depth[2], normal[6], velocity[4];
    OK(still.sample(at, outside::refused, surface));
    OK(still.sample(at, outside::refused, surface, depth, normal, velocity));
    CHECK(near(surface[1], 2) && near(depth[0], 2) && near(normal[5], 1) && velocity[3] == 0);
    std::vector<vertex> vertices(16);
    OK(still.write_vertices(vertices, sizeof(vertex), offsetof(vertex, position), offsetof(vertex, normal),
                            offsetof(vertex, depth)));
    CHECK(vertices[5].position[0] == 1.5f && vertices[5].position[2] == 2 && vertices[5].depth == 2);
    std::vector<std::uint32_t> indices(GET(still.get_index_count(false)));
    OK(still.write_indices(false, indices, sizeof indices[0]));
    CHECK(indices.size() == 54 && GET(still.get_index_count(true)) == 54);
    still.destroy();

    water drained = GET(water::create(16, 3, 0.5, 0.5, precision::float64));
    OK(drained.write_f64(field::depth, std::vector<double>(48, 1)));
    OK(drained.set_side(side::x_last, border::level, 0.5));
    CHECK(GET(drained.get_side(side::x_last)).kind == border::level);
    OK(drained.set_drag(0.5));
    OK(drained.step(0.05, 4000));
    for (const double left : GET(drained.read_f64(field::depth))) CHECK(near(left, 0.5)); // as high as the side holds
    const water::account drain = GET(drained.get_account());
    CHECK(near(drain.out - drain.in, 6)); // half a metre of 8 m x 1.5 m
}

// Spread over the caller's threads a step gives the same bits.
template <class Object> void threads(Object spread, Object alone) {
    std::size_t pieces = 0;
    {
        const cd_parallel table = counting(pieces); // copied
        OK(spread.set_parallel(&table));
    }
    for (int i = 0; i < 3; ++i) {
        OK(spread.step(0.01));
        OK(alone.step(0.01));
    }
    CHECK(pieces > 0);
    CHECK(GET(spread.hash()) == GET(alone.hash()));
    const std::size_t before = pieces;
    OK(spread.set_parallel(nullptr));
    OK(spread.step(0.01));
    CHECK(pieces == before);
}

chain hair() {
    chain made = GET(chain::create(64, 40, 3));
    OK(made.set_gravity({0, -9.81, 0}));
    OK(made.impulse(7, 5, {1, 2, 3}));
    return made;
}
membrane drum() {
    membrane made = GET(membrane::create(200, 150, 1));
    OK(made.impulse(40, 40, 8, {1}));
    return made;
}
water pond() {
    water made = GET(water::create(90, 80, 1, 1));
    OK(made.add_volume(40, 40, 20, 100));
    return made;
}

} // namespace

int main() {
    CHECK(version() == CD_VERSION_MAJOR * 1000000 + CD_VERSION_MINOR * 1000 + CD_VERSION_PATCH);
    CHECK(std::string(version_string()) == std::to_string(CD_VERSION_MAJOR) + "." + std::to_string(CD_VERSION_MINOR) +
                                               "." + std::to_string(CD_VERSION_PATCH));
    CHECK(std::strlen(build_info()) > 10 && std::string(error_message()).empty());
    CHECK(runnable_kernels().front() == kernels::plain && std::string(kernels_name(kernels::avx512)) == "AVX-512");
    CHECK(std::string(status_name(status::error_value)) == "CD_ERROR_VALUE");
    const membrane sheet = GET(membrane::create(7, 4, 2, precision::float64));
    const saved_object of = GET(saved_shape(GET(sheet.save())));
    CHECK(of.kind == kind::membrane && of.first == 7 && of.second == 4 && of.components == 2);
    CHECK(of.precision == precision::float64);
    chains();
    ropes();
    colliders();
    beds_and_callbacks();
    cloth();
    posed();
    membranes();
    waters();
    threads(hair(), hair());
    threads(drum(), drum());
    threads(pond(), pond());
}
