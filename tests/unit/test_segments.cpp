// Long lines in segments solve what one sweep from end to end does.
extern "C" {
#include "cmocka_all.h"
}
#include <math.h>

#include "contdyn/base.h"
#include "kernel/kernels.hh"
#include "random.hh"
#include "solve/ring_closure.hh"
#include "solve/segment_line.hh"
#include "solve/segment_rod.hh"

namespace {

constexpr size_t kMost = 300, kMostLines = 4;

// One to four lines of one system, twice, [0] in the order of the nodes and [1] in segments.
struct Scene {
    size_t nodes, lines;
    double mass[kMost], stiffness[kMost], turning[kMost];
    double x[2][kMost * kMostLines], v[2][kMost * kMostLines], force[kMost * kMostLines], target[kMost * kMostLines];
    double gain[2][4][kMost];
    bool acts;
    cd::Stage stage;

    double ground(size_t i) const { return mass[i]; }
    double spring(size_t i) const { return stiffness[i]; }
    double bend(size_t i) const { return turning[i]; }
    bool repeats(size_t i) const { return mass[i] == mass[i - 1] && stiffness[i] == stiffness[i - 1]; }

    // spring and bend: about which stiffnesses they vary. 0 decades: all alike.
    void make(unsigned seed, double decades, double spring, double bend) {
        unsigned random = seed;
        const auto about = [&](double centre) { return centre * pow(10, decades * (random_number(random) - 0.5)); };
        lines = 1 + seed % 4, nodes = 64 + 7 * seed % 230, acts = seed % 2 == 0;
        for (size_t i = 0; i < nodes; ++i) {
            mass[i] = decades > 0 ? 0.5 + random_number(random) : 1;
            stiffness[i] = about(spring);
            turning[i] = about(bend);
        }
        if (seed % 3 == 0) mass[seed % nodes] = INFINITY;
        if (seed % 5 == 0) stiffness[seed % (nodes - 1)] = 0;
        if (seed % 7 == 0) turning[seed % nodes] = 0;
        for (size_t k = 0; k < nodes * lines; ++k) {
            x[0][k] = x[1][k] = random_number(random) - 0.5;
            v[0][k] = v[1][k] = isinf(mass[k / lines]) ? 0.25 : random_number(random) - 0.5;
            force[k] = random_number(random) - 0.5, target[k] = random_number(random) - 0.5;
        }
        const cd::Segments segments(nodes);
        for (size_t i = 0; i < nodes; ++i)
            for (int g = 0; g < 4; ++g)
                gain[0][g][i] = gain[1][g][segments.place(i)] = isinf(mass[i]) ? 0 : 0.1 * random_number(random);
        stage = {3, 1, 0.1, {0.1, -0.2, 0.3, 0}, seed % 8 == 0 ? 1.0 : 0.0};
    }
    cd::NodeGains gains(int k) const {
        if (!acts) return {gain[k][0], nullptr, nullptr, nullptr};
        return {gain[k][0], gain[k][1], gain[k][2], gain[k][3]};
    }
    cd::Lines state(int k) { return {nodes, lines, lines, {x[k], true}, {v[k], true}, {force, true}, {target, true}}; }
    double difference() const {
        double size = 0, most = 0;
        for (size_t k = 0; k < nodes * lines; ++k) size = fmax(size, fabs(v[0][k]));
        for (size_t k = 0; k < nodes * lines; ++k)
            most = fmax(most, fmax(fabs(v[1][k] - v[0][k]) / size, fabs(x[1][k] - x[0][k]) / (1 + size)));
        return most;
    }
};

Scene scene;

void springs_in_segments_solve_what_one_sweep_does(void**) {
    static double rows[6][kMost], y[kMost * kMostLines];
    for (unsigned seed = 1; seed < 120; ++seed) {
        scene.make(seed, seed % 4 == 0 ? 30 : seed % 4 == 1 ? 0 : 6, pow(10, 4 * double(seed % 7) - 12), 0);
        const size_t n = scene.nodes;
        cd::factor_spring_line(n, scene, rows[0], rows[1]);
        const cd::SpringCoefficients whole{rows[0], rows[1], nullptr, scene.gains(0)};
        assert_true(cd::spring_sweep(scene.state(0), whole, scene.stage, {}, y, false, 0, scene.lines));

        double reply[cd::kSegments], pass[cd::kSegments];
        cd::factor_segment_line(n, scene, {rows[2], rows[3], rows[4], rows[5], reply, pass},
                                [](size_t, double, size_t, bool) {});
        const cd::SegmentCoefficients parts{rows[2], rows[3], rows[4], rows[5], reply, pass, scene.gains(1)};
        assert_true(cd::segment_sweep(scene.state(1), parts, scene.stage, {}, y, false));
        assert_true(scene.difference() < 1e-13);
    }
}

// A uniform line in which some nodes are held.
struct Uniform {
    double spring_, bend_;
    size_t nodes, every; // so many nodes one is held
    bool tells;          // what repeats
    double ground(size_t i) const { return i % every == 0 ? double(INFINITY) : 0.7; }
    double spring(size_t) const { return spring_; }
    double bend(size_t i) const { return i > 0 && i + 1 < nodes ? bend_ : 0; }
    bool repeats(size_t i) const { return tells && i > 1 && i + 1 < nodes && ground(i) == ground(i - 1); }
};

void what_repeats_along_a_line_is_computed_once(void**) {
    constexpr size_t kLong = 1200, kRows = 11;
    static double rows[2][kRows][kLong], grounded_by[2][kLong], reply[2][cd::kSegments], pass[2][cd::kSegments];
    static cd::RodSegment segment[2][cd::kSegments];
    for (unsigned seed = 0; seed < 60; ++seed) {
        const size_t nodes = kLong - seed % 17, every = seed % 3 == 0 ? 5000 : 300;
        const double stiff = pow(10, double(seed % 12) - 4);
        size_t computed[2] = {};
        for (int told = 0; told < 2; ++told) {
            const Uniform line{stiff, 0, nodes, every, told == 1};
            double(*const row)[kLong] = rows[told];
            cd::factor_segment_line(nodes, line, {row[0], row[1], row[2], row[3], reply[told], pass[told]},
                                    [&](size_t, double grounded, size_t at, bool repeated) {
                                        grounded_by[told][at] = grounded;
                                        computed[told] += !repeated;
                                    });
        }
        for (int r = 0; r < 4; ++r) assert_memory_equal(rows[0][r], rows[1][r], nodes * sizeof(double));
        assert_memory_equal(grounded_by[0], grounded_by[1], nodes * sizeof(double));
        assert_memory_equal(reply[0], reply[1], sizeof reply[0]);
        assert_memory_equal(pass[0], pass[1], sizeof pass[0]);
        assert_int_equal(computed[0], nodes);
        // the factors settle within 20 times the root of stiffness over ground, from every held node on
        if (20 * sqrt(stiff / 0.7) < 100) assert_true(computed[1] < 110 * (1 + nodes / every));

        for (int told = 0; told < 2; ++told) {
            const Uniform line{seed % 5 == 0 ? 0 : stiff, pow(10, double(seed % 7) - 3), nodes, every, told == 1};
            double(*const row)[kLong] = rows[told];
            cd::factor_segment_rod(nodes, line,
                                   {{row[0], row[1], row[2], row[3], row[4], row[5], row[6]},
                                    {row[7], row[8], row[9], row[10]},
                                    segment[told]});
        }
        for (size_t r = 0; r < kRows; ++r) assert_memory_equal(rows[0][r], rows[1][r], nodes * sizeof(double));
        assert_memory_equal(segment[0], segment[1], sizeof segment[0]);
    }
}

// Runs solve(start, row, keep) for one stage, or for two.
template <class Solve> void run_stages(int count, const cd::Stage& stage, Solve solve) {
    static double rows[2][kMost * kMostLines];
    if (count == 2) solve(cd::Start{}, rows[0], true);
    const cd::Start second{rows[0], stage.overshoot, stage.move};
    solve(count == 2 ? second : cd::Start{}, rows[1], false);
}

// Open or closed, of bend, springs or both, in one stage or two.
void rods_in_segments_solve_what_one_sweep_does(void**) {
    static double rows[12][kMost], has_bend[kMost], response[4][kMost];
    static double slope[kMost * kMostLines], hold[kMost * kMostLines];
    static unsigned char pin[kMost];
    double* const responses[3] = {response[0], response[1], response[2]};
    for (unsigned seed = 1; seed < 800; ++seed) {
        const bool ring = seed % 6 == 1, straight = seed % 12 == 7, limp = seed % 11 == 0;
        const double centre = pow(10, 2 * double(seed % 7) - 6);
        scene.make(seed, seed % 4 == 0 ? 12 : 2, limp ? 0 : centre, straight ? 0 : centre);
        const size_t n = scene.nodes;
        if (!ring) scene.turning[0] = scene.turning[n - 1] = 0;
        for (size_t i = 0; i < n; ++i) {
            has_bend[i] = scene.turning[i] > 0;
            pin[i] = isinf(scene.mass[i]) ? CD_NODE_PINNED : CD_NODE_FREE;
        }
        const int stages = seed % 9 == 0 ? 2 : 1;
        const cd::RodRows rod{rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6]};
        const double ends[3] = {scene.stiffness[n - 1], scene.turning[n - 1], scene.turning[0]};
        cd::RingClosure closure{};
        const auto close = [&](auto place) {
            if (!ring) return;
            cd::factor_ring(n, scene, rod, straight ? 1 : 3, ends, responses, response[3], closure, place);
            closure.closing_rate = scene.stage.closing_rate;
        };

        cd::factor_rod_line(n, scene, rod);
        close(cd::InOrder());
        const cd::RodCoefficients whole{rows[0], rows[1], rows[2],  rows[3],        rows[4], rows[5],
                                        rows[6], nullptr, has_bend, scene.gains(0), pin};
        run_stages(stages, scene.stage, [&](const cd::Start& start, double* row, bool keep) {
            cd::rod_sweep(scene.state(0), whole, scene.stage, start, row, slope, 0, scene.lines);
            assert_true(cd::advance(scene.state(0), scene.stage, start, closure, row, keep, 0, scene.lines));
        });

        static cd::RodSegment segment[cd::kSegments];
        const cd::Segments segments(n);
        cd::factor_segment_rod(n, scene, {rod, {rows[7], rows[8], rows[9], rows[10]}, segment});
        close([&](size_t i) { return segments.place(i); });
        const cd::SegmentRodCoefficients parts{rows[0], rows[1],       rows[2], rows[3],
                                               rows[4], rows[5],       rows[6], {rows[7], rows[8], rows[9], rows[10]},
                                               segment, scene.gains(1)};
        run_stages(stages, scene.stage, [&](const cd::Start& start, double* row, bool keep) {
            assert_true(
                cd::segment_rod_step(scene.state(1), parts, scene.stage, start, closure, row, slope, hold, keep));
        });
        assert_true(scene.difference() < 2e-13);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(what_repeats_along_a_line_is_computed_once),
        cmocka_unit_test(springs_in_segments_solve_what_one_sweep_does),
        cmocka_unit_test(rods_in_segments_solve_what_one_sweep_does),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
