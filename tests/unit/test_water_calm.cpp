// A calm line of water makes the same step, to the bit, by its own way as by the one for all lines; and what is not calm
// does not take it.
extern "C" {
#include "cmocka_all.h"
}
#include <string.h>

#include <vector>

#include "kernel/water_line.hh"

namespace {

constexpr int kN = 4;
using Line = cd::WaterLine<kN>;

double random(unsigned& seed) {
    seed = seed * 1664525u + 1013904223u;
    return double(seed >> 8) / double(1u << 24);
}

// A line with panels of its own, and numbers that depend on nothing but the seed.
struct Own {
    std::vector<std::vector<double>> panels;
    Line line;

    Own(const cd::WaterAxis& axis, unsigned seed, double bed, double depth, double speed)
        : line{axis, axis.cells, false} {
        double** const all[] = {&line.bed,    &line.depth,  &line.velocity,   &line.face,
                                &line.share,  &line.stream, &line.start_face, &line.guess,
                                &line.gain,   &line.spring, &line.transfer,   &line.after,
                                &line.ground, &line.x,      &line.pull,       &line.rest};
        for (size_t k = 0; k < sizeof all / sizeof *all; ++k) panels.emplace_back((axis.cells + 1) * kN);
        for (size_t k = 0; k < panels.size(); ++k) *all[k] = panels[k].data();
        for (size_t k = 0; k < axis.cells * kN; ++k) {
            line.bed[k] = bed * random(seed);
            line.depth[k] = depth * (0.9 + 0.2 * random(seed));
            line.velocity[k] = k < kN ? 0 : speed * (random(seed) - 0.5);
        }
    }
};

cd::WaterAxis axis_of(size_t cells, double courant, double lambda) {
    cd::WaterAxis axis{};
    axis.cells = cells;
    axis.courant = courant;
    axis.lambda = axis.push_after = lambda;
    axis.gravity = 9.81;
    return axis;
}

bool same(const double* a, const double* b, size_t count) { return memcmp(a, b, count * sizeof(double)) == 0; }

void a_calm_line_steps_to_the_same_bits(void**) {
    for (size_t cells : {1, 2, 3, 31, 32, 33, 100})
        for (double courant : {0.01, 0.2, 0.7})
            for (double lambda : {0.5, 0.55, 1.0})
                for (unsigned seed = 1; seed <= 5; ++seed) {
                    const cd::WaterAxis axis = axis_of(cells, courant, lambda);
                    Own calm(axis, seed, 0.2, 1, 0.3), other(axis, seed, 0.2, 1, 0.3);
                    std::vector<double> open((cells + 1) * kN, 1); // which the calm way knows nothing of
                    other.line.open = open.data();
                    assert_true(calm.line.step_calm());
                    assert_false(other.line.step_calm());
                    other.line.step();
                    assert_true(same(calm.line.after, other.line.after, cells * kN));
                    assert_true(same(calm.line.velocity, other.line.velocity, (cells + 1) * kN));
                    assert_memory_equal(calm.line.tally, other.line.tally, sizeof calm.line.tally);
                }
}

void what_is_not_calm_is_left_as_it_was(void**) {
    struct {
        const char* what;
        double courant, bed, depth, speed;
    } const wild[] = {{"dry land", 0.1, 0, 0, 0},
                      {"films above their neighbours", 0.1, 3, 1, 0},
                      {"streams", 0.1, 0, 1, 60},
                      {"long steps", 1, 0, 1, 0}};
    for (const auto& w : wild) {
        const cd::WaterAxis axis = axis_of(40, w.courant, 0.5);
        Own line(axis, 3, w.bed, w.depth, w.speed), before(axis, 3, w.bed, w.depth, w.speed);
        print_message("%s\n", w.what);
        assert_false(line.line.step_calm());
        assert_true(same(line.line.depth, before.line.depth, 40 * kN));
        assert_true(same(line.line.velocity, before.line.velocity, 41 * kN));
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(a_calm_line_steps_to_the_same_bits),
        cmocka_unit_test(what_is_not_calm_is_left_as_it_was),
    };
    return cmocka_run_group_tests_name("water calm", tests, nullptr, nullptr);
}
