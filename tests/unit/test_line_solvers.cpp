// The two eliminations and their sweeps, against dense elimination in long double, and at the limits of stiffness.
extern "C" {
#include "cmocka_all.h"
}
#include <math.h>
#include <string.h>

#include <initializer_list>

#include "contdyn/base.h"
#include "kernel/advance.hh"
#include "kernel/rod_sweep.hh"
#include "kernel/spring_sweep.hh"
#include "random.hh"
#include "solve/ring_closure.hh"
#include "solve/rod_line.hh"
#include "solve/spring_line.hh"

namespace {

constexpr size_t kNodes = 13;

// A line whose numbers can be set one by one.
struct Line {
    double mass[kNodes], stiffness[kNodes], turning[kNodes];
    double ground(size_t i) const { return mass[i]; }
    double spring(size_t i) const { return stiffness[i]; }
    double bend(size_t i) const { return turning[i]; }
    bool repeats(size_t i) const { return mass[i] == mass[i - 1] && stiffness[i] == stiffness[i - 1]; }
};

Line random_line(unsigned seed, double decades, bool bend) {
    Line line{};
    for (size_t i = 0; i < kNodes; ++i) {
        line.mass[i] = 0.5 + random_number(seed);
        line.stiffness[i] = pow(10, decades * (random_number(seed) - 0.5));
        line.turning[i] = bend && i > 0 && i + 1 < kNodes ? pow(10, decades * (random_number(seed) - 0.5)) : 0;
    }
    return line;
}

// w of (M + K) w = M v + what the springs wish, by Gauss with long doubles. Held nodes have infinite mass.
void solve_dense(const Line& line, const double* x, const double* v, double rate, bool ring, long double* w) {
    static long double a[kNodes][kNodes + 1];
    memset(a, 0, sizeof a);
    const auto add = [&](const size_t* nodes, const int* weights, int count, long double stiffness) {
        long double wish = 0;
        for (int p = 0; p < count; ++p) wish -= (long double)rate * weights[p] * x[nodes[p]];
        for (int p = 0; p < count; ++p) {
            for (int q = 0; q < count; ++q) a[nodes[p]][nodes[q]] += stiffness * weights[p] * weights[q];
            a[nodes[p]][kNodes] += stiffness * weights[p] * wish;
        }
    };
    const int stretch[2] = {-1, 1}, turn[3] = {1, -2, 1};
    for (size_t i = 0; i < kNodes - (ring ? 0 : 1); ++i) {
        const size_t nodes[2] = {i, (i + 1) % kNodes};
        add(nodes, stretch, 2, line.stiffness[i]);
    }
    for (size_t i = 0; i < kNodes; ++i) {
        const size_t nodes[3] = {(i + kNodes - 1) % kNodes, i, (i + 1) % kNodes};
        if (line.turning[i] > 0) add(nodes, turn, 3, line.turning[i]);
    }
    for (size_t i = 0; i < kNodes; ++i) {
        if (isinf(line.mass[i])) memset(a[i], 0, sizeof a[i]), a[i][i] = 1, a[i][kNodes] = v[i];
        else a[i][i] += line.mass[i], a[i][kNodes] += (long double)line.mass[i] * v[i];
    }
    for (size_t p = 0; p < kNodes; ++p) {
        size_t best = p;
        for (size_t i = p; i < kNodes; ++i)
            if (fabsl(a[i][p]) > fabsl(a[best][p])) best = i;
        for (size_t j = 0; j <= kNodes; ++j) {
            const long double other = a[p][j];
            a[p][j] = a[best][j], a[best][j] = other;
        }
        for (size_t i = 0; i < kNodes; ++i) {
            if (i == p) continue;
            const long double factor = a[i][p] / a[p][p];
            for (size_t j = p; j <= kNodes; ++j) a[i][j] -= factor * a[p][j];
        }
    }
    for (size_t i = 0; i < kNodes; ++i) w[i] = a[i][kNodes] / a[i][i];
}

// A stage without gravity or drag that turns v into w, with every number of the line at hand.
struct Problem {
    double x[kNodes], v[kNodes], gravity[kNodes] = {}, rate = 3;

    explicit Problem(unsigned seed, const Line& line) {
        for (size_t i = 0; i < kNodes; ++i) {
            x[i] = random_number(seed) - 0.5;
            v[i] = isinf(line.mass[i]) ? 0.25 : random_number(seed) - 0.5;
        }
    }
    cd::Stage stage(double of_change) const { return {rate, 0, 1, {}, of_change}; }
};

using cd::Lines;
using cd::Stage;

void solve_springs(const Line& line, Problem& p, double of_change) {
    double carry[kNodes], pull[kNodes], scratch[kNodes];
    cd::factor_spring_line(kNodes, line, carry, pull);
    const cd::SpringCoefficients c{carry, pull, nullptr, {p.gravity, nullptr, nullptr, nullptr}};
    assert_true(cd::spring_sweep({kNodes, 1, 1, {p.x, true}, {p.v, true}, {}, {}}, c, p.stage(of_change), {}, scratch,
                                 false, 0, 1));
}

void solve_rod(const Line& line, Problem& p, bool ring, double of_change) {
    double rows[7][kNodes] = {}, has_bend[kNodes], value[kNodes], slope[kNodes], response[4][kNodes];
    unsigned char held[kNodes];
    const cd::RodRows rod{rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6]};
    cd::factor_rod_line(kNodes, line, rod);
    for (size_t i = 0; i < kNodes; ++i) {
        has_bend[i] = line.turning[i] > 0;
        held[i] = isinf(line.mass[i]) ? CD_NODE_PINNED : CD_NODE_FREE;
    }
    cd::RingClosure closure;
    if (ring) {
        const double stiffness[3] = {line.stiffness[kNodes - 1], line.turning[kNodes - 1], line.turning[0]};
        double* const responses[3] = {response[0], response[1], response[2]};
        cd::factor_ring(kNodes, line, rod, line.turning[1] > 0 ? 3 : 1, stiffness, responses, response[3], closure);
        closure.closing_rate = p.rate;
    }
    const Lines lines{kNodes, 1, 1, {p.x, true}, {p.v, true}, {}, {}};
    const cd::RodCoefficients c{rows[0], rows[1], rows[2], rows[3],  rows[4],
                                rows[5], rows[6], nullptr, has_bend, {p.gravity, nullptr, nullptr, nullptr},
                                held};
    cd::rod_sweep(lines, c, p.stage(of_change), {}, value, slope, 0, 1);
    assert_true(cd::advance(lines, p.stage(of_change), {}, closure, value, false, 0, 1));
}

double error_against(const long double* exact, const double* w) {
    long double error = 0, size = 0;
    for (size_t i = 0; i < kNodes; ++i) {
        error = fmaxl(error, fabsl(w[i] - exact[i]));
        size = fmaxl(size, fabsl(exact[i]));
    }
    return double(error / size);
}

void springs_solve_the_dense_system(void**) {
    for (unsigned seed = 1; seed < 200; ++seed) {
        Line line = random_line(seed, 8, false);
        if (seed % 3 == 0) line.mass[seed % kNodes] = INFINITY;
        if (seed % 5 == 0) line.stiffness[seed % (kNodes - 1)] = 0;
        Problem p(seed + 1000, line);
        long double exact[kNodes];
        solve_dense(line, p.x, p.v, p.rate, false, exact);
        solve_springs(line, p, seed % 2);
        assert_true(error_against(exact, p.v) < 1e-14);
    }
}

void rods_and_rings_solve_the_dense_system(void**) {
    for (unsigned seed = 1; seed < 400; ++seed) {
        const bool ring = seed % 2 == 0, bend = seed % 4 < 2;
        Line line = random_line(seed, 6, bend);
        if (bend && ring) line.turning[0] = 0.7, line.turning[kNodes - 1] = 40;
        if (seed % 3 == 0) line.mass[seed % kNodes] = INFINITY;
        if (seed % 9 == 0) line.mass[(seed + 1) % kNodes] = INFINITY;
        if (seed % 5 == 0) line.stiffness[seed % (kNodes - 1)] = 0;
        Problem p(seed + 1000, line);
        long double exact[kNodes];
        solve_dense(line, p.x, p.v, p.rate, ring, exact);
        solve_rod(line, p, ring, seed % 7 < 3 ? 1 : 0);
        assert_true(error_against(exact, p.v) < 2e-12);
    }
}

// However stiff, a free line without wishes moves on with its mean velocity (springs) and its mean rotation (bend).
void infinitely_stiff_lines_move_as_rigid_bodies(void**) {
    for (double stiffness : {1e16, 1e30, 1e100, double(INFINITY)}) {
        Line line = random_line(7, 0, false);
        for (double& s : line.stiffness) s = stiffness;
        Problem p(11, line);
        double momentum = 0, mass = 0;
        for (size_t i = 0; i < kNodes; ++i) {
            momentum += line.mass[i] * p.v[i];
            mass += line.mass[i];
            p.x[i] = 0;
        }
        solve_springs(line, p, 0);
        for (size_t i = 0; i < kNodes; ++i) assert_true(fabs(p.v[i] - momentum / mass) < 1e-14);
    }
    for (double bend : {1e16, 1e30, 1e100}) {
        Line line = random_line(8, 0, true);
        for (size_t i = 0; i < kNodes; ++i) {
            line.stiffness[i] = 0;
            line.turning[i] = i > 0 && i + 1 < kNodes ? bend : 0;
        }
        Problem p(12, line);
        double sums[5] = {}; // of m, m i, m i^2, m v, m i v
        for (size_t i = 0; i < kNodes; ++i) {
            const double m = line.mass[i], at = double(i);
            sums[0] += m, sums[1] += m * at, sums[2] += m * at * at, sums[3] += m * p.v[i], sums[4] += m * at * p.v[i];
            p.x[i] = 0;
        }
        const double det = sums[0] * sums[2] - sums[1] * sums[1];
        const double slope = (sums[0] * sums[4] - sums[1] * sums[3]) / det;
        const double start = (sums[3] - slope * sums[1]) / sums[0];
        solve_rod(line, p, false, 0);
        for (size_t i = 0; i < kNodes; ++i) assert_true(fabs(p.v[i] - (start + slope * double(i))) < 1e-13);
    }
}

void shares_are_right_from_zero_to_infinity(void**) {
    const double infinity = double(INFINITY), tiny = 1e-300, huge = 1e300;
    assert_true(cd::share(1, 3) == 0.25 && cd::share(3, 1) == 0.75 && cd::share(2, 2) == 0.5);
    assert_true(cd::share(0, 1) == 0 && cd::share(1, 0) == 1 && cd::share(0, 0) == 0);
    assert_true(cd::share(infinity, 1) == 1 && cd::share(1, infinity) == 0 && cd::share(infinity, infinity) == 0);
    assert_true(cd::share(tiny, huge) == 0 && cd::share(huge, tiny) == 1);
    assert_true(cd::series(infinity, 5) == 5 && cd::series(5, infinity) == 5 && cd::series(0, 5) == 0);
    assert_true(cd::series(infinity, infinity) == infinity && cd::series(0, 0) == 0 && cd::series(4, 4) == 2);
    assert_true(cd::series(huge, huge) == huge / 2 && cd::series(tiny, huge) == tiny);
}

// Of lanes they are the same to the bit.
void shares_of_lanes_are_those_of_numbers(void**) {
    constexpr int kPairs = 4;
    const double infinity = double(INFINITY);
    const double edges[] = {0, -0.0, 5e-324, 1e-310, 2e-308, 1, 1.7e308, infinity};
    constexpr size_t kEdges = sizeof edges / sizeof edges[0];
    unsigned seed = 7;
    for (size_t round = 0; round < 20000; ++round) {
        double a[kPairs], b[kPairs], share[kPairs], fraction[kPairs];
        for (int k = 0; k < kPairs; ++k) {
            const size_t pair = kPairs * round + size_t(k);
            a[k] = pow(10, 40 * random_number(seed) - 20), b[k] = a[k] * pow(10, 36 * random_number(seed) - 18);
            if (pair < kEdges * kEdges) a[k] = edges[pair / kEdges], b[k] = edges[pair % kEdges];
            else if (pair % 7 == 0) b[k] = pair % 2 ? a[k] : edges[pair % kEdges];
        }
        const cd::Beside<kPairs> beside(cd::Lanes<kPairs>::load(a), cd::Lanes<kPairs>::load(b));
        beside.share().store(share);
        beside.fraction().store(fraction);
        for (int k = 0; k < kPairs; ++k) {
            const double alone[4] = {cd::share(a[k], b[k]), cd::fraction(a[k], b[k]), cd::share(a[k], b[k]),
                                     cd::series(a[k], b[k])};
            const cd::ShareAndSeries both = cd::share_and_series(a[k], b[k]);
            const double found[4] = {share[k], fraction[k], both.share, both.series};
            assert_memory_equal(found, alone, sizeof found);
        }
    }
}

// A fraction close to 1 is kept by its distance from 1.
void fractions_keep_their_digits_at_both_ends(void**) {
    using L = cd::Lanes<1>;
    const double near_one = cd::fraction(1e22, 1), near_zero = cd::fraction(1, 1e22);
    assert_true(fabs(cd::between(L{5e21}, L{0}, L{0}, near_one).v - 0.5) < 1e-12);
    assert_true(fabs(cd::between(L{0}, L{5e21}, L{0}, near_zero).v - 0.5) < 1e-12);
    assert_true(cd::between(L{5e30}, L{1}, L{0}, cd::fraction(INFINITY, 1)).v == 1);
    assert_true(cd::between(L{1}, L{5e30}, L{0}, cd::fraction(0, 1)).v == 1);
    assert_true(cd::between(L{0.1}, L{0.1}, L{0}, 0.3).v == 0.1);
}

// A line's result does not depend on how many lines it shares a register with.
void lanes_do_not_mix(void**) {
    constexpr size_t kLines = 61;
    static float x[kNodes][kLines], v[kNodes][kLines], alone[2][kNodes];
    static double scratch[kNodes][kLines], carry[kNodes], pull[kNodes], gravity[kNodes];
    const Line line = random_line(3, 6, false);
    cd::factor_spring_line(kNodes, line, carry, pull);
    const cd::SpringCoefficients c{carry, pull, nullptr, {gravity, nullptr, nullptr, nullptr}};
    const Stage stage{3, 1, 0.5, {}, 0};
    unsigned seed = 5;
    for (auto* field : {&x, &v})
        for (auto& row : *field)
            for (float& number : row) number = float(random_number(seed)) - 0.5f;
    static float x0[kNodes][kLines], v0[kNodes][kLines];
    memcpy(x0, x, sizeof x), memcpy(v0, v, sizeof v);
    cd::spring_sweep({kNodes, kLines, 1, {x[0], false}, {v[0], false}, {}, {}}, c, stage, {}, scratch[0], false, 0,
                     kLines);
    for (size_t l = 0; l < kLines; ++l) {
        for (size_t i = 0; i < kNodes; ++i) alone[0][i] = x0[i][l], alone[1][i] = v0[i][l];
        cd::spring_sweep({kNodes, 1, 1, {alone[0], false}, {alone[1], false}, {}, {}}, c, stage, {}, scratch[0], false,
                         0, 1);
        for (size_t i = 0; i < kNodes; ++i) assert_true(alone[0][i] == x[i][l] && alone[1][i] == v[i][l]);
    }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(springs_solve_the_dense_system),
        cmocka_unit_test(rods_and_rings_solve_the_dense_system),
        cmocka_unit_test(infinitely_stiff_lines_move_as_rigid_bodies),
        cmocka_unit_test(shares_are_right_from_zero_to_infinity),
        cmocka_unit_test(shares_of_lanes_are_those_of_numbers),
        cmocka_unit_test(fractions_keep_their_digits_at_both_ends),
        cmocka_unit_test(lanes_do_not_mix),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
