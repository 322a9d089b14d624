/* Nodes that are held one by one in a uniform sheet: what the steps of both solvers make of them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "grid.h"
#include "reference.h"
#include "sheet.h"

enum { MOST_NODES = 120, MOST_HELD = 16 }; /* so many single ones are held by impulses: membrane.h */

/* A sheet with single nodes held, some of them driven. */
struct scene {
    cd_membrane* m;
    struct grid *all, *lines, *bend; /* lines, bend: as if only whole rows and columns were held */
    size_t columns, rows, components, nodes;
    double h, dt, lambda;
    long double matched[MOST_NODES];   /* impedance of matched edges */
    long double slowed[2][MOST_NODES]; /* per line: 1 + h drag and what its matched edge adds */
};

static size_t below(uint64_t* seed, size_t n) {
    const double part = (random_number(seed) + 1) / 2;
    return (size_t)(part * (double)n) % n;
}

/* Frees the nodes that are not held with their whole row or column. */
static void keep_whole_lines(struct grid* g) {
    unsigned char* const was = malloc(g->nodes);
    assert_non_null(was);
    memcpy(was, g->held, g->nodes);
    for (size_t i = 0; i < g->nodes; ++i) {
        int row = 1, column = 1;
        for (size_t u = 0; u < g->columns; ++u) row &= was[i / g->columns * g->columns + u];
        for (size_t v = 0; v < g->rows; ++v) column &= was[v * g->columns + i % g->columns];
        g->held[i] = row || column;
    }
    free(was);
}

/* A matched edge adds the impedance that sends no echo back: of a spring that ends there and the node inside. */
static void match(struct scene* s, const struct sheet* of, cd_edge edge) {
    struct grid* const g = s->all;
    const int d = edge / 2;
    const size_t step = d == 0 ? 1 : g->columns, across = d == 0 ? g->rows : g->columns;
    const size_t last = edge % 2 ? (d == 0 ? g->columns : g->rows) - 1 : 0;
    for (size_t k = 0; k < across; ++k) {
        const size_t end = (d == 0 ? k * g->columns : k) + last * step;
        const long double weight = g->mass[last ? end - step : end + step] / sheet_node_mass(of);
        const long double impedance = weight * sqrtl(sheet_spring(of, d) * sheet_node_mass(of));
        g->impedance[end] += impedance;
        s->matched[end] += impedance;
        s->slowed[d][last] = 1 + s->h * (g->drag + impedance / g->mass[end]);
    }
}

/* held: so many single nodes at the most; ties: some of them tied instead. */
static struct scene random_scene(size_t held, int ties, uint64_t seed) {
    static const enum sheet_ends ends[] = {SHEET_FREE, SHEET_FIXED, SHEET_FIXED_FREE, SHEET_RING};
    struct scene s = {.columns = 4 + below(&seed, 9), .rows = 4 + below(&seed, 6)};
    struct sheet of = {.nodes = {s.columns, s.rows}, .mass = 1 + below(&seed, 3)};
    const int bends = below(&seed, 4) == 0;
    for (int d = 0; d < 2; ++d) of.ends[d] = bends ? SHEET_FIXED : ends[below(&seed, 4)];
    if (bends && below(&seed, 2)) of.ends[below(&seed, 2)] = SHEET_RING;
    of.rule = below(&seed, 2) ? CD_MASS_HALF_ENDS : CD_MASS_EQUAL;
    s.dt = 0.1;
    const double stiff = of.mass / (double)(s.columns * s.rows) / (s.dt * s.dt);
    for (int d = 0; d < 2; ++d) of.stiffness[d] = stiff * pow(10, 1.5 * random_number(&seed));
    if (bends) of.bend = 0.01 * stiff / (double)(s.columns * s.rows) * pow(10, random_number(&seed));
    if (below(&seed, 2)) of.drag = 3 / s.dt;
    if (below(&seed, 2)) of.damping = 2 * s.dt;
    s.components = 1 + below(&seed, 3);
    s.m = sheet_membrane(&of, s.components, CD_FLOAT64);
    int matched[4];
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge) {
        matched[edge] = !bends && of.ends[edge / 2] == SHEET_FREE && below(&seed, 3) == 0;
        if (matched[edge]) ok(cd_membrane_set_edge(s.m, edge, CD_NODE_MATCHED));
    }
    s.lambda = below(&seed, 2) ? 0.5 : 0.3 + 0.7 * (random_number(&seed) + 1) / 2;
    s.h = s.lambda * s.dt;
    ok(cd_membrane_set_lambda(s.m, s.lambda));
    const double gravity[4] = {1, -9.81, 3, 0.5};
    ok(cd_membrane_set_gravity(s.m, gravity, s.components));
    s.nodes = s.columns * s.rows;
    double *const x = calloc(s.nodes * s.components, sizeof *x), *const v = calloc(s.nodes * s.components, sizeof *v);
    assert_non_null(x);
    assert_non_null(v);
    for (size_t i = 0; i < s.nodes * s.components; ++i) x[i] = random_number(&seed), v[i] = random_number(&seed);
    ok(cd_membrane_enable_field(s.m, CD_PIN));
    ok(cd_membrane_enable_field(s.m, CD_FORCE));
    if (below(&seed, 4) == 0) /* a whole row, by its nodes */
        for (size_t u = 0, row = below(&seed, s.rows); u < s.columns; ++u)
            sheet_set(s.m, CD_PIN, u, row, CD_NODE_PINNED);
    for (size_t k = 0; k < held; ++k) {
        const size_t u = below(&seed, s.columns), row = below(&seed, s.rows);
        const double force[4] = {1e300, -1e300, 1e200, 7}, target[4] = {0.3, -2, 1, 5};
        if (ties && below(&seed, 2)) {
            const double tie = stiff * pow(10, 4 * random_number(&seed)), damping = below(&seed, 2) ? tie * s.dt : 0;
            ok(cd_membrane_attach(s.m, u, row, below(&seed, 3) ? tie : 0, damping, target, s.components));
            continue;
        }
        sheet_set(s.m, CD_PIN, u, row, below(&seed, 2) ? CD_NODE_PINNED : CD_NODE_DRIVEN);
        ok(cd_membrane_write_f64(s.m, CD_FORCE, u, row, 1, 1, force, s.components)); /* does nothing there */
    }
    for (size_t i = 0; i < s.nodes * s.components; ++i) {
        const size_t node = i / s.components;
        if (sheet_get(s.m, CD_PIN, node % s.columns, node / s.columns) == CD_NODE_PINNED) v[i] = 0;
    }
    sheet_write(s.m, CD_POSITION, x);
    sheet_write(s.m, CD_VELOCITY, v);
    free(x);
    free(v);
    s.all = grid_of(s.m), s.lines = grid_of(s.m), s.bend = grid_of_bend(s.m);
    for (int d = 0; d < 2; ++d)
        for (size_t i = 0; i < (d ? s.rows : s.columns); ++i) s.slowed[d][i] = 1 + s.h * s.all->drag;
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        if (matched[edge]) match(&s, &of, edge);
    keep_whole_lines(s.lines);
    memcpy(s.bend->held, s.lines->held, s.nodes);
    return s;
}

static void done(struct scene* s) {
    grid_destroy(s->all), grid_destroy(s->lines), grid_destroy(s->bend);
    cd_membrane_destroy(s->m);
}

/* out = A_d x, the bend counted twice; of a sheet along one direction alone it is not. */
static void along(const struct scene* s, enum grid_kind d, const long double* x, long double* out) {
    const long double square = s->h * (s->h + s->all->damping);
    long double bend[MOST_NODES];
    grid_stiffness(s->lines, d, x, out);
    grid_stiffness(s->bend, d, x, bend);
    for (size_t i = 0; i < s->nodes; ++i) out[i] = square * (out[i] + bend[i]);
}

/* out = (M_u + A_u) M'^-1 (M_v + A_v) x between the nodes that whole lines leave free, M_d = M slowed_d,
 * M' = M (1 + h drag); without matched edges all three are one. */
static void factored(const struct scene* s, const long double* x, long double* out) {
    long double between[MOST_NODES];
    const long double resist = 1 + s->h * s->all->drag;
    along(s, GRID_ALONG_V, x, between);
    for (size_t i = 0; i < s->nodes; ++i)
        between[i] = x[i] + between[i] / (s->all->mass[i] * s->slowed[1][i / s->columns]);
    along(s, GRID_ALONG_U, between, out);
    for (size_t i = 0; i < s->nodes; ++i) {
        const long double across = s->slowed[1][i / s->columns] / resist;
        out[i] =
            s->lines->held[i] ? 0 : across * (out[i] + s->all->mass[i] * s->slowed[0][i % s->columns] * between[i]);
    }
}

/* Solves by Gauss and Jordan's elimination, the largest pivot of a column first. */
static void solve_dense(size_t n, long double (*a)[MOST_NODES + 1]) {
    for (size_t k = 0; k < n; ++k) {
        size_t pivot = k;
        for (size_t i = k; i < n; ++i)
            if (fabsl(a[i][k]) > fabsl(a[pivot][k])) pivot = i;
        for (size_t j = k; j <= n; ++j) {
            const long double other = a[k][j];
            a[k][j] = a[pivot][j], a[pivot][j] = other;
        }
        for (size_t i = 0; i < n; ++i)
            for (size_t j = n + 1; i != k && j-- > k;) a[i][j] -= a[i][k] / a[k][k] * a[k][j];
    }
    for (size_t k = 0; k < n; ++k) a[k][n] /= a[k][k];
}

/* The step B dw = b - S v of component c between free nodes, into x and v, which are all components. */
static void step_between_free_nodes(const struct scene* s, size_t c, double* x, double* v) {
    static long double a[MOST_NODES][MOST_NODES + 1];
    size_t free_node[MOST_NODES], n = 0;
    long double side[MOST_NODES], mine[MOST_NODES], pull[MOST_NODES], unit[MOST_NODES];
    for (size_t i = 0; i < s->nodes; ++i) mine[i] = v[i * s->components + c];
    grid_right_side(s->all, c, s->h, x, v, side);
    grid_system(s->all, s->h, mine, pull);
    for (size_t i = 0; i < s->nodes; ++i)
        if (!s->all->held[i]) free_node[n++] = i;
    for (size_t j = 0; j < n; ++j) {
        for (size_t i = 0; i < s->nodes; ++i) unit[i] = i == free_node[j];
        long double column[MOST_NODES], pull_of_ties[MOST_NODES];
        factored(s, unit, column);
        grid_stiffness(s->all, GRID_TIE, unit, pull_of_ties);
        for (size_t i = 0; i < n; ++i) a[i][j] = column[free_node[i]] + s->h * s->h * pull_of_ties[free_node[i]];
        a[j][j] += s->h * (s->all->impedance[free_node[j]] - s->matched[free_node[j]]);
    }
    for (size_t i = 0; i < n; ++i) a[i][n] = side[free_node[i]] - pull[free_node[i]];
    solve_dense(n, a);
    for (size_t i = 0; i < s->nodes; ++i) x[i * s->components + c] += s->dt * v[i * s->components + c];
    for (size_t i = 0; i < n; ++i) {
        const size_t at = free_node[i] * s->components + c;
        x[at] += (double)(s->dt * a[i][n]);
        v[at] += (double)(a[i][n] / s->lambda);
    }
}

/* Held nodes also move by their own velocities to the bit, whatever pushes them. */
static void an_alternating_step_is_the_factored_one_between_free_nodes(void** state) {
    (void)state;
    double worst = 0;
    for (uint64_t seed = 1; seed <= 300; ++seed) {
        struct scene s = random_scene(1 + seed % MOST_HELD, seed % 2 == 0, seed);
        const size_t count = s.nodes * s.components;
        double *const x = malloc(count * sizeof *x), *const v = malloc(count * sizeof *v);
        double *const lx = malloc(count * sizeof *x), *const lv = malloc(count * sizeof *v);
        double size = 0, off = 0;
        assert_true(x && v && lx && lv);
        ok(cd_membrane_set_solver(s.m, CD_SOLVER_ALTERNATING));
        sheet_read(s.m, CD_POSITION, x);
        sheet_read(s.m, CD_VELOCITY, v);
        for (int step = 0; step < 3; ++step) {
            sheet_read(s.m, CD_POSITION, lx);
            sheet_read(s.m, CD_VELOCITY, lv);
            double *const to_x = malloc(count * sizeof *x), *const to_v = malloc(count * sizeof *v);
            ok(cd_membrane_step(s.m, s.dt, 1));
            sheet_read(s.m, CD_POSITION, to_x);
            sheet_read(s.m, CD_VELOCITY, to_v);
            for (size_t i = 0; i < count; ++i)
                if (s.all->held[i / s.components]) {
                    assert_true(to_x[i] == lx[i] + s.dt * lv[i]);
                    assert_true(to_v[i] == lv[i]);
                }
            free(to_x);
            free(to_v);
            for (size_t c = 0; c < s.components; ++c) step_between_free_nodes(&s, c, x, v);
        }
        sheet_read(s.m, CD_POSITION, lx);
        sheet_read(s.m, CD_VELOCITY, lv);
        for (size_t i = 0; i < count; ++i) {
            size = fmax(size, fmax(fabs(x[i]), s.dt * fabs(v[i])));
            off = fmax(off, fmax(fabs(x[i] - lx[i]), s.dt * fabs(v[i] - lv[i])));
        }
        if (!(off <= 1e-12 * size)) print_message("scene %d: off by %.1e of %g\n", (int)seed, off, size);
        worst = fmax(worst, off / size);
        free(x), free(v), free(lx), free(lv);
        done(&s);
    }
    print_message("300 sheets with held nodes: apart from the factored step by %.1e\n", worst);
    assert_true(worst <= 1e-12);
}

/* A sheet of 33 x 33 nodes, free or held by its edges, and `held` nodes. rate: a spring's stiffness times h^2 over a
 * node's mass, for lambda 1/2. */
static cd_membrane* pinned_sheet(int drum, size_t (*at)[2], size_t held, double rate, double dt) {
    const double spring = 4 * rate / (dt * dt), total = spring * 33 / 32; /* 33 lines of 32 springs */
    const enum sheet_ends ends = drum ? SHEET_FIXED : SHEET_FREE;
    const struct sheet of = {.ends = {ends, ends}, .nodes = {33, 33}, .mass = 33 * 33, .stiffness = {total, total}};
    cd_membrane* const m = sheet_membrane(&of, 1, CD_FLOAT64);
    ok(cd_membrane_enable_field(m, CD_PIN));
    for (size_t k = 0; k < held; ++k) sheet_set(m, CD_PIN, at[k][0], at[k][1], CD_NODE_PINNED);
    ok(cd_membrane_set_solver(m, CD_SOLVER_AUTO));
    return m;
}

/* Steps until it has swung through `turns` times; the time of that, between steps by a straight line. It starts from
 * where it hangs under a push of all nodes alike. */
static double time_of_swings(cd_membrane* m, double dt, int turns) {
    enum { NODES = 33 * 33 };
    static double start[NODES], x[NODES];
    const double gravity = 1, none = 0;
    ok(cd_membrane_set_gravity(m, &gravity, 1));
    struct grid* const g = grid_of(m);
    grid_rest(g, start);
    grid_destroy(g);
    ok(cd_membrane_set_gravity(m, &none, 1));
    sheet_write(m, CD_POSITION, start);
    double before = 0, time = 0;
    for (int step = 0; turns > 0; ++step) {
        double now = 0;
        assert_true(step < 10000);
        ok(cd_membrane_step(m, dt, 1));
        sheet_read(m, CD_POSITION, x);
        for (size_t i = 0; i < NODES; ++i) now += start[i] * x[i];
        if (step > 0 && (now > 0) != (before > 0)) {
            time = (step + before / (before - now)) * dt;
            --turns;
        }
        before = now;
    }
    return time;
}

static void a_sheet_with_held_nodes_keeps_its_time_by_default(void** state) {
    (void)state;
    static size_t centre[][2] = {{16, 16}}, four[][2] = {{10, 10}, {22, 10}, {10, 22}, {22, 22}};
    static size_t corners[][2] = {{0, 0}, {32, 0}, {0, 32}, {32, 32}}, edge[][2] = {{16, 0}};
    static const struct {
        const char* name;
        int drum;
        size_t (*at)[2];
        size_t held;
    } kinds[] = {
        {"centre", 1, centre, 1}, {"four inside", 1, four, 4}, {"corners", 0, corners, 4}, {"edge", 0, edge, 1}};
    const double dt = 0.1;
    for (size_t k = 0; k < COUNT(kinds); ++k) {
        /* the largest rate at which a step alternates */
        double low = 1e-3, high = 1e3;
        cd_solver taken;
        while (high / low > 1.001) {
            const double rate = sqrt(low * high);
            cd_membrane* const m = pinned_sheet(kinds[k].drum, kinds[k].at, kinds[k].held, rate, dt);
            ok(cd_membrane_step(m, dt, 1));
            ok(cd_membrane_get_solver_taken(m, &taken));
            *(taken == CD_SOLVER_ALTERNATING ? &low : &high) = rate;
            cd_membrane_destroy(m);
        }
        double time[2];
        for (int solver = 0; solver < 2; ++solver) {
            cd_membrane* const m = pinned_sheet(kinds[k].drum, kinds[k].at, kinds[k].held, low, dt);
            ok(cd_membrane_set_solver(m, solver ? CD_SOLVER_COUPLED : CD_SOLVER_AUTO));
            time[solver] = time_of_swings(m, dt, 7);
            cd_membrane_destroy(m);
        }
        print_message("%s: alternating up to a rate of %.2f, where a swing takes %.4f times as long\n", kinds[k].name,
                      low, time[0] / time[1]);
        assert_true(low > 1);
        assert_true(fabs(time[0] / time[1] - 1) < 0.025);
    }
}

/* An iteration or two whatever the stiffness, where V-cycles take up to eight. */
static void a_coupled_solve_with_held_nodes_takes_an_iteration_or_two(void** state) {
    (void)state;
    uint64_t seed = 5;
    for (double rate = 0.1; rate < 1e9; rate *= 10)
        for (size_t held = 1; held <= MOST_HELD; held += 5) {
            size_t at[MOST_HELD][2], iterations;
            double residual, v[33 * 33];
            for (size_t k = 0; k < held; ++k) at[k][0] = below(&seed, 33), at[k][1] = below(&seed, 33);
            cd_membrane* const m = pinned_sheet(0, at, held, rate, 0.1);
            ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED));
            ok(cd_membrane_set_tolerance(m, 1e-4, 100));
            for (size_t i = 0; i < COUNT(v); ++i) v[i] = random_number(&seed);
            for (size_t k = 0; k < held; ++k) {
                v[at[k][1] * 33 + at[k][0]] = 0;
                if (k % 3 != 1) continue; /* tied instead */
                sheet_set(m, CD_PIN, at[k][0], at[k][1], CD_NODE_FREE);
                ok(cd_membrane_attach(m, at[k][0], at[k][1], rate * pow(10, 6 * random_number(&seed)), 0, NULL, 0));
            }
            sheet_write(m, CD_VELOCITY, v);
            for (int step = 0; step < 10; ++step) {
                ok(cd_membrane_step(m, 0.1, 1));
                ok(cd_membrane_get_convergence(m, &iterations, &residual));
                if (iterations > 2) print_message("rate %g, %zu held: %zu iterations\n", rate, held, iterations);
                assert_true(iterations <= 2);
            }
            cd_membrane_destroy(m);
        }
}

/* However stiff a tie is it keeps its digits: like a pin in the end. And the softest is like none. A coupled solve
 * measures the residual of all nodes alike, and so what a very stiff tie makes of rounding. */
static void ties_go_from_none_to_pins(void** state) {
    (void)state;
    static size_t at[][2] = {{9, 20}};
    static const double ties[] = {0, 1e-320, 1e-150, 1e-60, 1e15, 1e30, 1e60};
    for (int solver = 0; solver < 2; ++solver)
        for (size_t k = 0; k < COUNT(ties); ++k) {
            const int like_a_pin = ties[k] > 1;
            if (solver == 1 && like_a_pin) continue;
            cd_membrane* const m = pinned_sheet(0, at, 0, 3, 0.1);
            cd_membrane* const other = pinned_sheet(0, at, like_a_pin, 3, 0.1);
            static double x[2][33 * 33];
            uint64_t seed = 7;
            double off = 0;
            for (size_t i = 0; i < COUNT(x[0]); ++i) x[0][i] = random_number(&seed);
            const double target = x[0][20 * 33 + 9] + (like_a_pin ? 0 : 1);
            ok(cd_membrane_attach(m, 9, 20, ties[k], 0, &target, 1));
            for (int i = 0; i < 2; ++i) {
                cd_membrane* const which = i ? other : m;
                ok(cd_membrane_set_solver(which, solver ? CD_SOLVER_COUPLED : CD_SOLVER_ALTERNATING));
                ok(cd_membrane_set_tolerance(which, 1e-13, 1000));
                sheet_write(which, CD_POSITION, x[0]);
            }
            for (int step = 0; step < 20; ++step) ok(cd_membrane_step(m, 0.1, 1)), ok(cd_membrane_step(other, 0.1, 1));
            sheet_read(m, CD_POSITION, x[0]);
            sheet_read(other, CD_POSITION, x[1]);
            for (size_t i = 0; i < COUNT(x[0]); ++i) off = fmax(off, fabs(x[0][i] - x[1][i]));
            if (solver == 0 && ties[k] > 0 && ties[k] < 1e-100) off = 0; /* solved otherwise, so soft are they */
            if (!(off < 1e-10)) print_message("solver %d, a tie of %g N/m: off by %.1e\n", solver, ties[k], off);
            assert_true(off < 1e-10);
            cd_membrane_destroy(m);
            cd_membrane_destroy(other);
        }
}

/* More of them, or springs so stiff that the impulses would be lost in rounding: the energy itself is kept then. */
static void more_of_them_or_stiffer_springs_are_solved_otherwise(void** state) {
    (void)state;
    static const struct {
        size_t held;
        double rate, bend; /* both of a node */
        int factored;
    } cases[] = {{MOST_HELD, 10, 0, 1},   {MOST_HELD + 1, 10, 0, 0}, {MOST_HELD, 4990, 0, 1},
                 {MOST_HELD, 5010, 0, 0}, {MOST_HELD, 1, 623, 1},    {MOST_HELD, 1, 626, 0}};
    for (size_t k = 0; k < COUNT(cases); ++k) {
        size_t at[MOST_HELD + 1][2];
        const size_t held = cases[k].held;
        const double rate = cases[k].rate;
        for (size_t i = 0; i < held; ++i) at[i][0] = 3 + i % 6 * 4, at[i][1] = 3 + i / 6 * 7;
        cd_membrane* const m = pinned_sheet(cases[k].bend > 0, at, held, rate, 0.1);
        ok(cd_membrane_set_bend(m, cases[k].bend * 4 / (0.1 * 0.1) * 33 / (32.0 * 32 * 32)));
        double x[33 * 33], least = INFINITY;
        uint64_t seed = 3;
        for (size_t i = 0; i < COUNT(x); ++i) x[i] = random_number(&seed);
        sheet_write(m, CD_POSITION, x);
        ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
        const double start = sheet_swing_energy(m);
        for (int step = 0; step < 20; ++step) {
            sheet_step(m, 0.1, 1);
            least = fmin(least, sheet_swing_energy(m) / start);
        }
        print_message("%zu held, rate %g, of bend %g: energy down to %.12g\n", held, rate, cases[k].bend, least);
        if (cases[k].factored) assert_true(least < 0.99); /* some of it is in the extra mass */
        else assert_true(least > 1 - 1e-9);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_alternating_step_is_the_factored_one_between_free_nodes),
        cmocka_unit_test(a_sheet_with_held_nodes_keeps_its_time_by_default),
        cmocka_unit_test(a_coupled_solve_with_held_nodes_takes_an_iteration_or_two),
        cmocka_unit_test(ties_go_from_none_to_pins),
        cmocka_unit_test(more_of_them_or_stiffer_springs_are_solved_otherwise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
