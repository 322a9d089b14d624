// An explicit step of calm water gives the same bits as the one for all water, with the kernels of every instruction
// set; and water that is not calm does not take it.
extern "C" {
#include "cmocka_all.h"
}
#include <math.h>

#include <vector>

#include "contdyn/water.h"
#include "model/water.hh"
#include "random.hh"

namespace {

size_t leaps, tries;
cd::Kernels with_leap, without;

template <class T>
bool counted(const cd::WaterAxis* axis, const cd::WaterGrid<T>& grid, double* work, size_t first, size_t count) {
    bool leapt;
    if constexpr (sizeof(T) == sizeof(float)) leapt = without.water32.leap(axis, grid, work, first, count);
    else leapt = without.water64.leap(axis, grid, work, first, count);
    ++tries, leaps += leapt;
    return leapt;
}
template <class T> bool never(const cd::WaterAxis*, const cd::WaterGrid<T>&, double*, size_t, size_t) { return false; }

struct Shape {
    size_t nx, ny;
};

struct Scene {
    const char* name;
    double bed, depth, waves, dt; // bed: its height; waves: of the depth
    bool calm;
};

cd_water* water_of(const Scene& scene, const Shape& shape, cd_precision precision, const cd::Kernels* kernels) {
    cd_water* water = nullptr;
    assert_int_equal(cd_water_create(shape.nx, shape.ny, 0.5, 0.4, precision, nullptr, &water), CD_OK);
    assert_int_equal(cd_water_set_method(water, CD_METHOD_SYMPLECTIC_EULER), CD_OK);
    assert_int_equal(cd_water_set_drag(water, shape.nx % 2 == 0 ? 0.5 : 0), CD_OK);
    std::vector<double> bed, depth;
    for (size_t j = 0; j < shape.ny; ++j)
        for (size_t i = 0; i < shape.nx; ++i) {
            const double x = double(i) / double(shape.nx), y = double(j) / double(shape.ny);
            bed.push_back(scene.bed * (x + 0.5 * y * y));
            const double surface = scene.depth * (1 + scene.waves * sin(9 * x + 3) * cos(7 * y)) - bed.back();
            depth.push_back(surface > 0 ? surface : 0);
        }
    assert_int_equal(cd_water_write_f64(water, CD_BED, 0, 0, shape.nx, shape.ny, bed.data(), bed.size()), CD_OK);
    assert_int_equal(cd_water_write_f64(water, CD_DEPTH, 0, 0, shape.nx, shape.ny, depth.data(), depth.size()), CD_OK);
    reinterpret_cast<cd::Water*>(water)->kernels = kernels;
    return water;
}

// A parallel-for that works through the last task first.
void backwards(void*, size_t count, void (*task)(void*, size_t), void* context) {
    while (count > 0) task(context, --count);
}

uint64_t run(const Scene& scene, const Shape& shape, cd_precision precision, const cd::Kernels* kernels,
             bool in_parts = false) {
    const cd_parallel parallel{nullptr, backwards};
    cd_water* const water = water_of(scene, shape, precision, kernels);
    if (in_parts) assert_int_equal(cd_water_set_parallel(water, &parallel), CD_OK);
    assert_int_equal(cd_water_step(water, scene.dt, 50), CD_OK);
    uint64_t hash = 0;
    assert_int_equal(cd_water_hash(water, &hash), CD_OK);
    cd_water_destroy(water);
    return hash;
}

// One step of a few cells in which often but one thing is not as calm water has it.
uint64_t run_any(unsigned seed, cd_precision precision, const cd::Kernels* kernels) {
    const Shape shape{size_t(any_of({1, 2, 3, 5}, seed)), size_t(any_of({1, 2, 4}, seed))};
    const double waves = any_of({0.05, 0.5, 0.9, 1.1, 1.6}, seed), dt = waves / sqrt(9.81); // cells of 1 m, 1 m deep
    const double swing = any_of({0.02, 0.5, 1}, seed), dry = any_of({0, 0, 0.3}, seed), film = any_of({0, 1e-26}, seed);
    const double runs = any_of({0, 0.3, 0.6, 0.95, 1.5}, seed) / dt, bed = any_of({0, 0, 0.3, 2}, seed);
    cd_water* water = nullptr;
    assert_int_equal(cd_water_create(shape.nx, shape.ny, 1, 1, precision, nullptr, &water), CD_OK);
    assert_int_equal(cd_water_set_method(water, CD_METHOD_SYMPLECTIC_EULER), CD_OK);
    assert_int_equal(cd_water_set_drag(water, any_of({0, 0, 0.3, 3}, seed) / dt), CD_OK);
    for (size_t j = 0; j < shape.ny; ++j)
        for (size_t i = 0; i < shape.nx; ++i) {
            const double floor = bed * random_number(seed),
                         depth = random_number(seed) < dry ? film : 1 - swing * random_number(seed);
            const double u = runs * (2 * random_number(seed) - 1), v = runs * (2 * random_number(seed) - 1);
            assert_int_equal(cd_water_write_f64(water, CD_BED, i, j, 1, 1, &floor, 1), CD_OK);
            assert_int_equal(cd_water_write_f64(water, CD_DEPTH, i, j, 1, 1, &depth, 1), CD_OK);
            if (i > 0) assert_int_equal(cd_water_write_f64(water, CD_VELOCITY_X, i, j, 1, 1, &u, 1), CD_OK);
            if (j > 0) assert_int_equal(cd_water_write_f64(water, CD_VELOCITY_Y, i, j, 1, 1, &v, 1), CD_OK);
        }
    reinterpret_cast<cd::Water*>(water)->kernels = kernels;
    cd_water_step(water, dt, 1);
    uint64_t hash = 0;
    assert_int_equal(cd_water_hash(water, &hash), CD_OK);
    cd_water_destroy(water);
    return hash;
}

void nothing_that_is_not_calm_goes_unseen(void**) {
    const unsigned scenes = 40000;
    without = with_leap = cd::best_kernels();
    with_leap.water32.leap = counted<float>, with_leap.water64.leap = counted<double>;
    cd::Kernels other = without;
    other.water32.leap = never<float>, other.water64.leap = never<double>;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        tries = leaps = 0;
        for (unsigned k = 0; k < scenes; ++k) {
            const unsigned seed = k * 2654435761u + 1;
            if (run_any(seed, precision, &with_leap) != run_any(seed, precision, &other)) fail_msg("scene %u", k);
        }
        print_message("%zu leaps of %zu\n", leaps, tries);
        assert_true(leaps > scenes / 20 && leaps < scenes - scenes / 20);
    }
}

void an_explicit_step_has_the_same_bits_either_way(void**) {
    static const Shape shapes[] = {{1, 1}, {1, 7}, {7, 1}, {2, 2}, {31, 17}, {64, 9}, {300, 20}, {523, 3}, {9, 50}};
    static const Scene scenes[] = {{"waves", 0.5, 1, 0.05, 0.03, true},
                                   {"a steeper bed", 0.9, 1.5, 0.02, 0.02, true},
                                   {"a beach", 2, 1, 0.05, 0.02, false},
                                   {"too long a step", 0, 10, 0.01, 0.06, false}};
    for (cd_kernels set = CD_KERNELS_PLAIN; set <= CD_KERNELS_AVX512; ++set)
        for (const Scene& scene : scenes) {
            const cd::Kernels* const kernels = cd::kernels_of(set);
            if (!kernels) continue;
            tries = leaps = 0;
            for (const Shape& shape : shapes)
                for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                    without = with_leap = *kernels;
                    with_leap.water32.leap = counted<float>, with_leap.water64.leap = counted<double>;
                    const uint64_t leapt = run(scene, shape, precision, &with_leap);
                    cd::Kernels other = *kernels;
                    other.water32.leap = never<float>, other.water64.leap = never<double>;
                    if (run(scene, shape, precision, &other) != leapt ||
                        run(scene, shape, precision, &with_leap, true) != leapt)
                        fail_msg("%s, %s, %zu x %zu, precision %d", cd_kernels_name(set), scene.name, shape.nx,
                                 shape.ny, int(precision));
                }
            print_message("%s, %s: %zu leaps of %zu\n", cd_kernels_name(set), scene.name, leaps, tries);
            if (scene.calm) assert_true(leaps == tries);
            else assert_true(leaps < tries);
        }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(an_explicit_step_has_the_same_bits_either_way),
        cmocka_unit_test(nothing_that_is_not_calm_goes_unseen),
    };
    return cmocka_run_group_tests_name("water leap", tests, nullptr, nullptr);
}
