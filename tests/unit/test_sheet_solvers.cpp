// The solvers of sheets against dense elimination: single lines, the nearest answer in a space, the V-cycle, shifted
// lines, conjugate gradients.
extern "C" {
#include "cmocka_all.h"
}
#include <math.h>
#include <string.h>

#include <initializer_list>
#include <vector>

#include "random.hh"
#include "solve/conjugate_gradients.hh"
#include "solve/shared_lines.hh"

namespace {

using Vector = std::vector<long double>;
using Matrix = std::vector<Vector>;

Vector solve_dense(Matrix a, Vector b) {
    const size_t n = b.size();
    for (size_t k = 0; k < n; ++k) {
        size_t pivot = k;
        for (size_t i = k; i < n; ++i)
            if (fabsl(a[i][k]) > fabsl(a[pivot][k])) pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (size_t i = k + 1; i < n; ++i) {
            const long double f = a[i][k] / a[k][k];
            for (size_t j = k; j < n; ++j) a[i][j] -= f * a[k][j];
            b[i] -= f * b[k];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
    return b;
}

struct Options {
    size_t columns, rows;
    bool ring_u, ring_v, holes, bend;
    double stiffness, decades;
};

// A sheet of random masses and springs with some nodes held, and its memory.
struct Sheet {
    std::vector<double> memory;
    cd::Carver counted{nullptr};
    cd_parallel parallel{};
    cd::SheetSystem system{};
    double *mass, *spring[2], *bend[2], *twist, *inverse_diagonal;
    cd::Preconditioner preconditioner{};
    cd::GradientPlanes gradient;
    double *r, *x, *y;
    std::vector<size_t> free;

    void carve(cd::Carver& carve, const Options& o) {
        assert_true(cd::grid_of(o.columns, o.rows, system.grid) && cd::grid_of(o.rows, o.columns, system.turned));
        const auto plane = [&] { return carve.plane(system.grid); };
        mass = plane();
        for (double*& s : spring) s = plane();
        for (double*& b : bend) b = o.bend ? plane() : nullptr;
        twist = o.bend ? plane() : nullptr;
        system.inverse_diagonal = inverse_diagonal = plane();
        system.kernels = &cd::best_kernels<cd::MembraneKernels>().sheet;
        system.parallel = &parallel;
        system.ring[0] = o.ring_u;
        system.ring[1] = o.ring_v;
        system.sheet = {mass, mass, {spring[0], spring[1]}, {bend[0], bend[1]}, twist, {}};
        for (double*& moment : system.sheet.moment) moment = o.bend ? plane() : nullptr;
        system.sums = carve.numbers(o.rows * cd::kEnergies);
        r = plane();
        x = plane();
        y = plane();
        gradient = cd::GradientPlanes(system, carve);
        preconditioner.first.carve(system, false, carve, carve);
    }

    Sheet(const Options& o, unsigned seed) {
        carve(counted, o);
        assert_true(counted.fits);
        memory.assign(counted.taken + 8, 0);
        double* start = memory.data();
        while (reinterpret_cast<uintptr_t>(start) % 64 != 0) ++start;
        cd::Carver given{start};
        carve(given, o);
        assert_int_equal(given.taken, counted.taken);
        for (size_t v = 0; v < o.rows; ++v)
            for (size_t u = 0; u < o.columns; ++u) {
                const size_t at = place(u, v);
                mass[at] = o.holes && random_number(seed) < 0.2 ? 0 : 0.5 + random_number(seed);
                const auto stiff = [&] { return o.stiffness * pow(10, o.decades * (random_number(seed) - 0.5)); };
                spring[0][at] = u + 1 < o.columns || o.ring_u ? stiff() : 0;
                spring[1][at] = v + 1 < o.rows || o.ring_v ? stiff() : 0;
                if (o.bend) {
                    bend[0][at] = o.ring_u || (u > 0 && u + 1 < o.columns) ? stiff() : 0;
                    bend[1][at] = o.ring_v || (v > 0 && v + 1 < o.rows) ? stiff() : 0;
                    twist[at] = (u + 1 < o.columns || o.ring_u) && (v + 1 < o.rows || o.ring_v) ? stiff() : 0;
                }
                if (mass[at] > 0) free.push_back(at);
            }
        system.wrap(spring[0]);
        const Matrix s = dense();
        for (size_t k = 0; k < free.size(); ++k) inverse_diagonal[free[k]] = double(1 / s[k][k]);
        preconditioner.first.build();
    }
    size_t place(size_t u, size_t v) const { return v * system.grid.pitch + u; }

    // S over the free nodes, from the sums of squares that it is the Hessian of.
    Matrix dense() const {
        std::vector<int> index(system.grid.pitch * system.grid.rows, -1);
        for (size_t k = 0; k < free.size(); ++k) index[free[k]] = int(k);
        Matrix s(free.size(), Vector(free.size(), 0));
        const auto add = [&](double stiffness, std::initializer_list<std::pair<size_t, int>> square) {
            for (auto a : square)
                for (auto b : square)
                    if (index[a.first] >= 0 && index[b.first] >= 0)
                        s[size_t(index[a.first])][size_t(index[b.first])] +=
                            (long double)stiffness * a.second * b.second;
        };
        const cd::Grid& g = system.grid;
        for (size_t v = 0; v < g.rows; ++v)
            for (size_t u = 0; u < g.columns; ++u) {
                const size_t left = (u > 0 ? u : g.columns) - 1, right = u + 1 < g.columns ? u + 1 : 0;
                const size_t at = place(u, v), below = g.below(v);
                add(mass[at], {{at, 1}});
                add(spring[0][at], {{at, -1}, {place(right, v), 1}});
                add(spring[1][at], {{at, -1}, {place(u, below), 1}});
                if (!twist) continue;
                add(bend[0][at], {{place(left, v), 1}, {at, -2}, {place(right, v), 1}});
                add(bend[1][at], {{place(u, g.above(v)), 1}, {at, -2}, {place(u, below), 1}});
                add(twist[at], {{at, 1}, {place(right, v), -1}, {place(u, below), -1}, {place(right, below), 1}});
            }
        return s;
    }
    void fill(double* plane, unsigned seed) const {
        for (size_t at : free) plane[at] = random_number(seed) - 0.5;
    }
    Vector of(const double* plane) const {
        Vector out;
        for (size_t at : free) out.push_back(plane[at]);
        return out;
    }
};

double worst(const Vector& a, const Vector& b) {
    long double most = 0, size = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        most = fmaxl(most, fabsl(a[i] - b[i]));
        size = fmaxl(size, fabsl(b[i]));
    }
    return double(most / size);
}

const Options kSheets[] = {
    {7, 5, false, false, false, false, 3, 0},   {9, 6, true, false, true, false, 40, 2},
    {8, 5, false, true, true, false, 1e4, 4},   {5, 7, true, true, false, false, 1e6, 0},
    {7, 8, false, false, true, true, 30, 2},    {6, 7, true, true, true, true, 30, 2},
    {1, 9, false, false, false, false, 1e3, 1}, {9, 1, false, false, true, false, 1e3, 1},
};

void the_system_and_its_energy_are_the_dense_ones(void**) {
    for (const Options& o : kSheets) {
        Sheet sheet(o, 3);
        const Matrix s = sheet.dense();
        sheet.fill(sheet.x, 5);
        const Vector x = sheet.of(sheet.x);
        Vector wanted(x.size(), 0);
        long double energy = 0;
        for (size_t i = 0; i < x.size(); ++i) {
            for (size_t j = 0; j < x.size(); ++j) wanted[i] += s[i][j] * x[j];
            energy += wanted[i] * x[i];
        }
        const double got = sheet.system.apply(sheet.x, sheet.y);
        assert_true(worst(sheet.of(sheet.y), wanted) < 1e-13);
        assert_true(fabs(double(got / energy - 1)) < 1e-13);
        for (size_t v = 0; v < o.rows; ++v)
            for (size_t u = 0; u < o.columns; ++u)
                if (!(sheet.mass[sheet.place(u, v)] > 0)) assert_true(sheet.y[sheet.place(u, v)] == 0);
    }
}

// Lines alone: the sheet without the springs across them.
void single_lines_are_solved_as_dense_elimination_does(void**) {
    for (const Options& o : kSheets) {
        if (o.bend) continue;
        Sheet sheet(o, 7);
        for (size_t k = 0; k < sheet.system.grid.pitch * o.rows; ++k) sheet.spring[0][k] = 0;
        std::vector<double> numbers(8 * (sheet.system.grid.pitch * o.rows + 64), 0);
        cd::Carver carve{numbers.data()};
        const cd::LineRows rows(carve, sheet.system.grid, o.ring_v);
        cd::factor_lines(
            sheet.system.grid, [&](size_t v, size_t u) { return sheet.mass[sheet.place(u, v)]; },
            [&](size_t v, size_t u) { return sheet.spring[1][sheet.place(u, v)]; }, rows);
        sheet.fill(sheet.r, 11);
        sheet.system.kernels->solve_lines(sheet.system.grid, rows.factors(), sheet.r, sheet.x, 0, o.columns);
        assert_true(worst(sheet.of(sheet.x), solve_dense(sheet.dense(), sheet.of(sheet.r))) < 1e-9);
    }
}

// What is left of the system is orthogonal to every plane of the space, also where one repeats another.
void the_nearest_answer_leaves_nothing_in_the_space(void**) {
    for (const Options& o : kSheets) {
        for (bool repeat : {false, true}) {
            Sheet sheet(o, 13);
            double* const planes[3] = {sheet.x, sheet.y, sheet.gradient.start};
            for (unsigned k = 0; k < 3; ++k) sheet.fill(planes[k], 17 + (repeat && k == 2 ? 1 : k));
            sheet.fill(sheet.r, 23);
            const double taken[3] = {};
            double factor[3];
            sheet.system.project(planes, 3, sheet.r, taken, factor);
            if (repeat) assert_true(factor[2] == 0);
            double* const sum = sheet.gradient.direction;
            sheet.system.clear(sum);
            for (int k = 0; k < 3; ++k) sheet.system.combine(1, sum, factor[k], planes[k]);
            sheet.system.apply(sum, sheet.gradient.applied);
            const double size = sqrt(sheet.system.dot(sheet.gradient.applied, sheet.gradient.applied));
            for (int k = 0; k < 3; ++k) {
                const double left =
                    sheet.system.dot(planes[k], sheet.r) - sheet.system.dot(planes[k], sheet.gradient.applied);
                assert_true(fabs(left) < 1e-10 * size * sqrt(sheet.system.dot(planes[k], planes[k])));
            }
        }
    }
}

void the_v_cycle_is_symmetric_and_close_to_the_inverse(void**) {
    for (const Options& o : kSheets) {
        if (o.bend) continue;
        Sheet sheet(o, 29);
        double *const a = sheet.gradient.start, *const b = sheet.gradient.direction;
        sheet.fill(a, 31);
        sheet.fill(b, 37);
        sheet.preconditioner.first.cycle(a, sheet.x);
        sheet.preconditioner.first.cycle(b, sheet.y); // what the first cycle left behind must not show
        const double one = sheet.system.dot(sheet.x, b), other = sheet.system.dot(sheet.y, a);
        const double size = sqrt(sheet.system.dot(sheet.x, sheet.x) * sheet.system.dot(b, b));
        assert_true(fabs(one - other) < 1e-9 * size);
        assert_true(sheet.system.dot(sheet.x, a) > 0 && sheet.system.dot(sheet.y, b) > 0);
        // the energy of the error against that of the answer
        const Vector exact = solve_dense(sheet.dense(), sheet.of(a));
        for (size_t k = 0; k < sheet.free.size(); ++k) sheet.y[sheet.free[k]] = double(exact[k]);
        const double whole = sheet.system.apply(sheet.y, sheet.gradient.applied);
        sheet.system.combine(1, sheet.y, -1, sheet.x);
        if (o.decades == 0) assert_true(sheet.system.apply(sheet.y, sheet.gradient.applied) < 0.3 * whole);
    }
}

// A sheet of like masses and springs, the first column held.
struct SeparableLine {
    size_t nodes;
    bool held;
    double stiffness, shift;

    double weight(size_t) const { return 1; }
    double ground(size_t i) const { return held && i == 0 ? double(INFINITY) : 0.5 + shift; }
    double spring(size_t i) const { return i + 1 < nodes ? stiffness : 0; }
    bool repeats(size_t) const { return false; }
};

void shifted_lines_are_symmetric_and_leave_next_to_nothing(void**) {
    for (const double stiffness : {0.1, 10.0, 1e4, 1e8}) {
        const Options o{13, 41, false, false, false, false, stiffness, 0};
        Sheet sheet(o, 53);
        const cd::Grid& grid = sheet.system.grid;
        const size_t nodes[2] = {o.columns, o.rows};
        std::vector<double> numbers(32 * grid.pitch * o.rows + 8 * 24 * 64, 0);
        cd::Carver carve{numbers.data()};
        cd::ShiftedLines lines;
        lines.carve(grid, nullptr, carve, carve);
        assert_true(carve.taken <= numbers.size());
        double* ones = carve.numbers(64);
        for (size_t i = 0; i < 64; ++i) ones[i] = 1;
        lines.choose(0.5, 0.5 + 4 * stiffness);
        assert_true(lines.ready());
        for (int d = 0; d < 2; ++d) {
            lines.inverse_mass[d] = ones;
            lines.factor(d, nodes[d], [&](double shift) { return SeparableLine{nodes[d], d == 0, stiffness, shift}; });
        }
        sheet.free.clear();
        for (size_t v = 0; v < o.rows; ++v)
            for (size_t u = 0; u < o.columns; ++u) {
                const size_t at = sheet.place(u, v);
                sheet.mass[at] = u > 0 ? 1 : 0;
                sheet.spring[0][at] = u + 1 < o.columns ? stiffness : 0;
                sheet.spring[1][at] = v + 1 < o.rows ? stiffness : 0;
                if (u > 0) sheet.free.push_back(at);
            }
        double *const a = sheet.gradient.start, *const b = sheet.gradient.direction;
        sheet.fill(a, 59);
        sheet.fill(b, 61);
        const cd::Parts bands(o.rows, o.columns, 8), strips(o.columns, o.rows, 8);
        lines.cycle(sheet.system, bands, strips, a, sheet.x);
        lines.cycle(sheet.system, bands, strips, b, sheet.y);
        const double size = sqrt(sheet.system.dot(sheet.x, sheet.x) * sheet.system.dot(b, b));
        assert_true(fabs(sheet.system.dot(sheet.x, b) - sheet.system.dot(sheet.y, a)) < 1e-9 * size);
        sheet.system.apply(sheet.x, sheet.gradient.applied);
        const double before = sqrt(sheet.system.dot(a, a));
        sheet.system.combine(1, a, -1, sheet.gradient.applied);
        print_message("stiffness %g: %.1e left\n", stiffness, sqrt(sheet.system.dot(a, a)) / before);
        assert_true(sqrt(sheet.system.dot(a, a)) < (stiffness < 1e7 ? 1e-3 : 1e-2) * before);
    }
    cd::Carver counted{nullptr};
    cd::ShiftedLines none;
    none.carve({3, 3, 8}, nullptr, counted, counted);
    double shift[cd::ShiftedLines::kMostShifts + 1];
    none.shift = shift;
    none.choose(1, 1e30); // so far apart that nothing covers them
    assert_true(!none.ready());
}

void conjugate_gradients_reach_the_dense_answer_and_say_how(void**) {
    for (const Options& o : kSheets) {
        Sheet sheet(o, 41);
        sheet.fill(sheet.r, 43);
        const Vector wanted = solve_dense(sheet.dense(), sheet.of(sheet.r));
        const cd::Goal goal{1e-9, 0, 300}, short_goal{1e-9, 0, 1};
        const cd::Convergence full =
            cd::solve_coupled(sheet.system, sheet.preconditioner, goal, sheet.gradient, sheet.r, sheet.x);
        assert_true(full.reached && full.residual <= 1e-9 && full.iterations <= (o.bend ? 200u : 60u));
        assert_true(worst(sheet.of(sheet.x), wanted) < 1e-6);
        sheet.fill(sheet.r, 43);
        const cd::Convergence cut =
            cd::solve_coupled(sheet.system, sheet.preconditioner, short_goal, sheet.gradient, sheet.r, sheet.x);
        assert_int_equal(cut.iterations, 1);
        if (o.columns > 1 && o.rows > 1) assert_true(!cut.reached && cut.residual > 1e-9);
        sheet.system.clear(sheet.r);
        const cd::Convergence rest =
            cd::solve_coupled(sheet.system, sheet.preconditioner, goal, sheet.gradient, sheet.r, sheet.x);
        assert_true(rest.reached && rest.iterations == 0 && rest.residual == 0);
    }
}

// Lines that share their factors, with and without bend and ring, against dense elimination of one of them.
struct UniformLine {
    size_t nodes;
    bool ring, bends;
    double ground(size_t i) const { return i == 2 ? double(INFINITY) : 1 + 0.25 * double(i % 3); }
    double spring(size_t i) const { return ring || i + 1 < nodes ? 7.5 : 0; }
    bool repeats(size_t) const { return false; }
    double bend(size_t i) const { return bends && (ring || (i > 0 && i + 1 < nodes)) ? 3.25 : 0; }
};

void shared_lines_are_solved_as_dense_elimination_does(void**) {
    for (bool ring : {false, true})
        for (bool bend : {false, true}) {
            const UniformLine line{11, ring, bend};
            cd::Grid grid;
            assert_true(cd::grid_of(6, line.nodes, grid));
            std::vector<double> numbers(64 * 1024, 0);
            cd::Carver carve{numbers.data()};
            cd::SharedLines shared(line.nodes, bend, ring, carve);
            shared.factor(line, bend);
            double *const plane = carve.plane(grid), *const slope = carve.plane(grid);
            Matrix s(line.nodes, Vector(line.nodes, 0));
            const auto add = [&](double stiffness, std::initializer_list<std::pair<size_t, int>> square) {
                for (auto a : square)
                    for (auto b : square)
                        s[a.first % line.nodes][b.first % line.nodes] += (long double)stiffness * a.second * b.second;
            };
            for (size_t i = 0; i < line.nodes; ++i) {
                add(i == 2 ? 1e30 : line.ground(i), {{i, 1}});
                add(line.spring(i), {{i, -1}, {i + 1, 1}});
                add(line.bend(i), {{i + line.nodes - 1, 1}, {i, -2}, {i + 1, 1}});
            }
            Vector b[6];
            unsigned seed = 47;
            for (size_t i = 0; i < line.nodes; ++i)
                for (size_t u = 0; u < grid.columns; ++u) {
                    const double wish = i == 2 ? 0 : random_number(seed) - 0.5;
                    plane[i * grid.pitch + u] = wish;
                    b[u].push_back(i == 2 ? 0 : wish * line.ground(i));
                }
            shared.solve(cd::best_kernels<cd::MembraneKernels>(), {}, grid, plane, slope);
            for (size_t u = 0; u < grid.columns; ++u) {
                Vector got;
                for (size_t i = 0; i < line.nodes; ++i) got.push_back(plane[i * grid.pitch + u]);
                assert_true(worst(got, solve_dense(s, b[u])) < 1e-12);
            }
        }
}

} // namespace

int main() {
    const CMUnitTest tests[] = {
        cmocka_unit_test(the_system_and_its_energy_are_the_dense_ones),
        cmocka_unit_test(single_lines_are_solved_as_dense_elimination_does),
        cmocka_unit_test(the_nearest_answer_leaves_nothing_in_the_space),
        cmocka_unit_test(the_v_cycle_is_symmetric_and_close_to_the_inverse),
        cmocka_unit_test(shifted_lines_are_symmetric_and_leave_next_to_nothing),
        cmocka_unit_test(conjugate_gradients_reach_the_dense_answer_and_say_how),
        cmocka_unit_test(shared_lines_are_solved_as_dense_elimination_does),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
