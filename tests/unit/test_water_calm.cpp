// A bundle of calm lines of water makes the same step, to the bit, by its own way as by the one for all lines; and what
// is not calm does not take it.
extern "C" {
#include "cmocka_all.h"
}
#include <string.h>

#include <vector>

#include "kernel/water_calm.hh"
#include "random.hh"

namespace {

constexpr size_t kLines = 19; // a bundle, and what is left of another
constexpr int kN = 8;

struct Scene {
    double courant, bed, depth, speed, swing = 0.2, deepens = 0; // from line to line
};

// Lines that lie along memory, or across it, with numbers that depend on nothing but the seed.
template <class T> struct Own {
    cd::WaterAxis axis{};
    size_t along, across;
    std::vector<T> bed, depth, velocity;
    std::vector<double> tally, work;
    std::vector<uint8_t> wall;
    size_t swept = kLines;

    Own(const Scene& scene, size_t cells, double lambda, bool along_memory, unsigned seed) {
        const size_t pitch = (along_memory ? cells + 1 : kLines) + 5;
        const size_t size = pitch * (along_memory ? kLines : cells + 1);
        along = along_memory ? 1 : pitch, across = along_memory ? pitch : 1;
        axis.cells = cells;
        axis.courant = scene.courant;
        axis.lambda = axis.push_after = lambda;
        axis.gravity = 9.81;
        axis.drag = seed % 2 == 0 ? 0.1 : 0;
        bed.resize(size), depth.resize(size), velocity.resize(size), wall.resize(size);
        tally.resize(kLines * cd::kTallies), work.resize(cd::kWaterPanels * (cells + 2) * cd::kWaterLanes);
        for (size_t line = 0; line < kLines; ++line)
            for (size_t i = 0; i < cells; ++i) {
                const size_t at = i * along + line * across;
                bed[at] = T(scene.bed * random_number(seed));
                depth[at] =
                    T((scene.depth + scene.deepens * double(line)) * (1 + scene.swing * (random_number(seed) - 0.5)));
                velocity[at] = T(i == 0 ? 0 : scene.speed * (random_number(seed) - 0.5));
            }
    }
    cd::WaterLines<T> lines() {
        cd::WaterLines<T> all{};
        all.lines = swept, all.along = all.byte_along = along, all.across = all.byte_across = across;
        all.bed = bed.data(), all.depth = depth.data(), all.velocity = velocity.data(), all.tally = tally.data();
        return all;
    }
    bool step_calm(size_t count = kN) {
        const cd::WaterLines<T> all = lines();
        return cd::CalmLines<kN, T>(axis, all, 0, count, work.data()).step();
    }
    // By the way for all lines: of walls, which stand nowhere, the calm way knows nothing.
    bool step(bool as_any) {
        cd::WaterLines<T> all = lines();
        if (as_any) all.wall = wall.data();
        return cd::sweep_water(axis, all, work.data(), 0, cd::water_packs(swept));
    }
};

template <class T> bool same(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class T> void check_same_bits() {
    size_t calm_ones = 0, scenes = 0;
    for (size_t cells : {1, 2, 3, 31, 32, 33, 100})
        for (double courant : {0.01, 0.2, 0.45, 1.0, 3.0, 30.0})
            for (double lambda : {0.5, 0.55, 1.0})
                for (bool along : {false, true})
                    for (double speed : {0.3, 2.0, 6.0})
                        for (unsigned seed = 1; seed <= 3; ++seed) {
                            /* in long steps what runs a cell is slow, and depths of every third scene are uneven */
                            const double runs = courant < 0.5 ? speed : 0.1 * speed / courant;
                            Own<T> one({courant, 0.2, 1, runs, seed == 3 ? 0.5 : 0.04}, cells, lambda, along, seed),
                                other(one), calm(one);
                            one.swept = other.swept = kLines - scenes % 12;
                            ++scenes, calm_ones += calm.step_calm();
                            assert_true(one.step(false) && other.step(true));
                            assert_true(same(one.depth, other.depth));
                            assert_true(same(one.velocity, other.velocity));
                            assert_true(same(one.tally, other.tally));
                        }
    print_message("%zu of %zu scenes calm\n", calm_ones, scenes);
    assert_true(calm_ones > scenes / 2 && calm_ones < scenes);
}

void calm_lines_step_to_the_same_bits(void**) {
#if CD_WITH_FLOAT32
    check_same_bits<float>();
#endif
#if CD_WITH_FLOAT64
    check_same_bits<double>();
#endif
}

// Short lines, all alike, in which often but one thing is not as calm water has it: none of what tells may be missing.
template <class T> void check_what_tells() {
    size_t calm_ones = 0;
    const size_t scenes = 60000;
    for (unsigned k = 0; k < scenes; ++k) {
        unsigned seed = k * 2654435761u;
        random_number(seed);
        const size_t cells = size_t(any_of({1, 2, 3, 4, 6}, seed));
        const double courant = any_of({0.02, 0.1, 0.3, 0.4, 0.5, 0.7, 0.9, 1.5, 4, 40, 1e6, 1e8}, seed),
                     swing = any_of({0, 0.02, 0.5, 1}, seed), level = any_of({0, 0, 1}, seed);
        const double runs = any_of({0, 0.3, 0.95, 1.5}, seed) / courant, dry = any_of({0, 0, 0.3}, seed);
        const double bed = any_of({0, 0, 0.3, 0.9, 2}, seed), film = any_of({0, 1e-26, 1e-3}, seed);
        const double base = any_of({0, 0, 0, 0, 1e16}, seed); // so far up that no depth shows in the surface
        Own<T> one({courant, 0, 1, 0}, cells, any_of({0.1, 0.5, 0.5, 0.55, 1}, seed), k % 2 == 0, 1);
        one.axis.drag = any_of({0, 0, 0.3, 3}, seed);
        for (size_t i = 0; i < cells; ++i) {
            const double rise = bed * random_number(seed), floor = base + rise;
            const double speed = runs * (2 * random_number(seed) - 1), wet = 1 - swing * random_number(seed);
            const double depth = random_number(seed) < dry ? film : level && rise < wet ? wet - rise : wet;
            for (size_t line = 0; line < kLines; ++line) {
                const size_t at = i * one.along + line * one.across;
                one.bed[at] = T(floor), one.depth[at] = T(depth), one.velocity[at] = T(i == 0 ? 0 : speed);
            }
        }
        Own<T> other(one), calm(one);
        calm_ones += calm.step_calm();
        assert_true(one.step(false) == other.step(true));
        assert_true(same(one.depth, other.depth));
        assert_true(same(one.velocity, other.velocity));
        assert_true(same(one.tally, other.tally));
    }
    print_message("%zu of %zu scenes calm\n", calm_ones, scenes);
    assert_true(calm_ones > scenes / 20 && calm_ones < scenes - scenes / 20);
}

void nothing_that_is_not_calm_goes_unseen(void**) {
#if CD_WITH_FLOAT32
    check_what_tells<float>();
#endif
#if CD_WITH_FLOAT64
    check_what_tells<double>();
#endif
}

template <class T> void check_left_alone() {
    struct {
        const char* what;
        Scene scene;
    } const wild[] = {{"dry land", {0.1, 0, 0, 0}},
                      {"films above their neighbours", {0.1, 3, 1, 0}},
                      {"streams", {0.1, 0, 1, 60}},
                      {"streams in long steps", {2, 0, 1, 3}},
                      {"long steps and shorter ones", {1, 0, 0.9, 0, 0.01, -0.1}}};
    for (const auto& w : wild)
        for (bool along : {false, true}) {
            Own<T> line(w.scene, 40, 0.5, along, 3), before(line);
            print_message("%s\n", w.what);
            for (size_t count = kN / 2 + 1; count <= kN; ++count) assert_false(line.step_calm(count));
            assert_true(same(line.depth, before.depth));
            assert_true(same(line.velocity, before.velocity));
        }
}

void what_is_not_calm_is_left_as_it_was(void**) {
#if CD_WITH_FLOAT32
    check_left_alone<float>();
#endif
#if CD_WITH_FLOAT64
    check_left_alone<double>();
#endif
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(calm_lines_step_to_the_same_bits),
        cmocka_unit_test(nothing_that_is_not_calm_goes_unseen),
        cmocka_unit_test(what_is_not_calm_is_left_as_it_was),
    };
    return cmocka_run_group_tests_name("water calm", tests, nullptr, nullptr);
}
