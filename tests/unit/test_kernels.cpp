// The kernels of every instruction set this processor has give the same bits as the plain ones.
extern "C" {
#include "cmocka_all.h"
}
#include <string.h>

#include <initializer_list>

#include "contdyn/base.h"
#include "kernel/kernels.hh"
#include "kernels.h"
#include "random.hh"
#include "solve/rod_line.hh"
#include "solve/segment_line.hh"
#include "solve/segment_rod.hh"
#include "solve/spring_line.hh"

namespace {

constexpr size_t kNodes = 37, kLines = 61;

struct Line {
    double ground(size_t i) const { return 1 + 0.1 * double(i % 7); }
    double spring(size_t i) const { return i % 5 == 0 ? 1e9 : 0.3 * double(1 + i % 3); }
    bool repeats(size_t) const { return false; }
    double bend(size_t i) const { return i > 0 && i + 1 < kNodes ? 0.7 * double(i % 4) : 0; }
};

template <class T> cd::StateNumbers numbers(T* data) { return {data, sizeof(T) == sizeof(double)}; }

template <class T> struct State {
    T position[kNodes][kLines], velocity[kNodes][kLines];

    explicit State(unsigned seed) {
        for (auto* field : {&position, &velocity})
            for (auto& row : *field)
                for (T& number : row) number = T(random_number(seed) - 0.5);
        position[3][5] = T(1e-30); // settles in float32
    }
    cd::Lines lines() { return {kNodes, kLines, 3, numbers(position[0]), numbers(velocity[0]), {}, {}}; }
};

const cd::ChainKernels& chains_of(cd_kernels set) { return *cd::kernels_of<cd::ChainKernels>(set); }

// Steps of every kind through one set of kernels.
template <class T> void step_all(const cd::ChainKernels& kernels, State<T>& state) {
    static double rows[12][kNodes], y[kNodes][kLines], slope[kNodes][kLines];
    static unsigned char pin[kNodes];
    const Line line;
    for (size_t i = 0; i < kNodes; ++i)
        rows[0][i] = 0.01 * double(i), rows[10][i] = i > 0 && i + 1 < kNodes, rows[11][i] = 0.02;
    const cd::NodeGains gains{rows[0], nullptr, rows[11], nullptr};
    const cd::Stage stage{7, 1, 0.1, {1, -2, 3}, 0}, change{7, 1, 0.1, {1, -2, 3}, 1};
    cd::factor_spring_line(kNodes, line, rows[1], rows[2]);
    for (const cd::NodeGains& g : {gains, cd::NodeGains{rows[0], nullptr, nullptr, nullptr}}) {
        const cd::SpringCoefficients springs{rows[1], rows[2], nullptr, g};
        for (const cd::Stage& s : {stage, change})
            assert_true(kernels.spring_sweep(state.lines(), springs, s, {}, y[0], false, 0, kLines));
    }
    const cd::RodRows rod{rows[3], rows[4], rows[5], rows[6], rows[7], rows[8], rows[9]};
    cd::factor_rod_line(kNodes, line, rod);
    const cd::RodCoefficients rods{rows[3], rows[4], rows[5],  rows[6], rows[7], rows[8],
                                   rows[9], nullptr, rows[10], gains,   pin};
    kernels.rod_sweep(state.lines(), rods, stage, {}, y[0], slope[0], 0, kLines);
    static State<T> at_once(1);
    at_once = state;
    assert_true(kernels.advance(state.lines(), stage, {}, {}, y[0], false, 0, kLines));
    assert_true(kernels.rod_step(at_once.lines(), rods, stage, {}, y[0], slope[0], false, 0, kLines));
    assert_memory_equal(&at_once, &state, sizeof state);
    const cd::ExplicitCoefficients explicits{rows[11], rows[0], rows[11], gains, 0.01, false};
    const double gravity[4] = {0.1, 0.2, 0.3, 0};
    assert_true(kernels.explicit_sweep(state.lines(), explicits, 0.1, gravity, cd::Carrier::kOldVelocity, 0, kLines));
    kernels.drift(state.lines(), 0.1, 0, kLines);
}

// Long lines in segments, with and without what else acts: one to four of them.
template <class T> void step_segments(const cd::ChainKernels& kernels, State<T>& state) {
    static double rows[5][kNodes * kLines], y[kNodes * kLines], reply[cd::kSegments], pass[cd::kSegments];
    static double rod[11][kNodes * kLines], slope[kNodes * kLines], hold[kNodes * kLines];
    static cd::RodSegment segment[cd::kSegments];
    for (size_t lines = 1; lines <= 4; ++lines) {
        const size_t nodes = kNodes * kLines / lines;
        for (double& row : rows[4]) row = 0.02;
        cd::factor_segment_line(nodes, Line{}, {rows[0], rows[1], rows[2], rows[3], reply, pass},
                                [](size_t, double, size_t, bool) {});
        cd::factor_segment_rod(
            nodes, Line{},
            {{rod[0], rod[1], rod[2], rod[3], rod[4], rod[5], rod[6]}, {rod[7], rod[8], rod[9], rod[10]}, segment});
        const cd::Lines all{nodes, lines, lines, numbers(state.position[0]), numbers(state.velocity[0]), {}, {}};
        for (const double* drag : {(const double*)nullptr, (const double*)rows[4]}) {
            const cd::SegmentCoefficients c{
                rows[0], rows[1], rows[2], rows[3], reply, pass, {rows[4], nullptr, drag, nullptr}};
            const cd::Stage stage{7, 1, 0.1, {1, -2, 3}, 0};
            assert_true(kernels.segment_sweep(all, c, stage, {}, y, false));
            const cd::SegmentRodCoefficients r{rod[0],  rod[1], rod[2], rod[3],
                                               rod[4],  rod[5], rod[6], {rod[7], rod[8], rod[9], rod[10]},
                                               segment, c.gains};
            assert_true(kernels.segment_rod_step(all, r, stage, {}, {}, y, slope, hold, false));
        }
    }
}

// Explicit steps of `count` like lines side by side. One alone takes its nodes side by side, and so do up to four of
// which all springs and nodes are alike.
template <class T>
void step_explicitly(const cd::ChainKernels& kernels, T* x, T* v, size_t count, bool uniform = false) {
    double stiffness[kNodes], inertia[kNodes], weight[kNodes];
    for (size_t i = 0; i < kNodes; ++i) {
        const bool end = i == 0 || i + 1 == kNodes;
        stiffness[i] = uniform ? 2 : 1 + double(i % 3);
        inertia[i] = uniform ? (end ? 0 : 0.02) : 0.01 * double(1 + i % 2);
        weight[i] = uniform && end ? 0.5 : 1;
    }
    const cd::NodeGains gains{weight, nullptr, nullptr, nullptr};
    const cd::ExplicitCoefficients c{stiffness, nullptr, inertia, gains, 0, false, uniform};
    const double gravity[4] = {-0.3, -0.3, -0.3, -0.3};
    for (int step = 0; step < 20; ++step)
        assert_true(kernels.explicit_sweep({kNodes, count, count < 4 ? count : 4, numbers(x), numbers(v), {}, {}}, c,
                                           0.1, gravity, cd::Carrier::kNewVelocity, 0, count));
}

template <class T> void check_sets() {
    static State<T> plain(1);
    plain = State<T>(1);
    step_all(chains_of(CD_KERNELS_PLAIN), plain);
    step_segments(chains_of(CD_KERNELS_PLAIN), plain);
    FOR_RUNNABLE(set) {
        static State<T> state(1);
        state = State<T>(1);
        step_all(chains_of(set), state);
        step_segments(chains_of(set), state);
        if (memcmp(&state, &plain, sizeof plain) != 0) fail_msg("%s differs", cd_kernels_name(set));
    }
}

void every_instruction_set_gives_the_same_bits(void**) {
    check_sets<float>();
    check_sets<double>();
}

// Nodes side by side round as one after the other do: compared with three lines at once, which go another way.
template <class T> void check_alone() {
    FOR_RUNNABLE(set) {
        State<T> start(9);
        T x[kNodes], v[kNodes], x3[kNodes][3], v3[kNodes][3];
        for (size_t i = 0; i < kNodes; ++i) {
            x[i] = start.position[i][0];
            v[i] = start.velocity[i][0];
            for (size_t j = 0; j < 3; ++j) x3[i][j] = x[i], v3[i][j] = v[i];
        }
        step_explicitly<T>(chains_of(set), x, v, 1);
        step_explicitly<T>(chains_of(set), x3[0], v3[0], 3);
        for (size_t i = 0; i < kNodes; ++i)
            for (size_t j = 0; j < 3; ++j) assert_true(x3[i][j] == x[i] && v3[i][j] == v[i]);

        // six lines are swept from node to node, few go along all numbers
        T x6[kNodes][6], v6[kNodes][6];
        const auto fill = [&](T* to_x, T* to_v, size_t lines) {
            for (size_t m = 0; m < kNodes * lines; ++m) {
                to_x[m] = start.position[m / lines][m % lines];
                to_v[m] = start.velocity[m / lines][m % lines];
            }
        };
        fill(x6[0], v6[0], 6);
        step_explicitly<T>(chains_of(set), x6[0], v6[0], 6, true);
        for (size_t lines = 1; lines <= 4; ++lines) {
            T few_x[kNodes * 4], few_v[kNodes * 4];
            fill(few_x, few_v, lines);
            step_explicitly<T>(chains_of(set), few_x, few_v, lines, true);
            for (size_t m = 0; m < kNodes * lines; ++m)
                assert_true(few_x[m] == x6[m / lines][m % lines] && few_v[m] == v6[m / lines][m % lines]);
        }
    }
}

void explicit_steps_of_a_line_alone_round_as_among_others(void**) {
    check_alone<float>();
    check_alone<double>();
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(every_instruction_set_gives_the_same_bits),
        cmocka_unit_test(explicit_steps_of_a_line_alone_round_as_among_others),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
