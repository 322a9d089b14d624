/* CD_SOLVER_AUTO: which solver a step takes, and that it then is that solver's step to the bit. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "check.h"

static const double kMostExtraMass = 0.05; /* of a motion of half a wave along each direction: membrane.h */
static const double kPi = 3.14159265358979323846;

/* A sheet of nu by nv springs, mass and stiffnesses as given. */
struct sheet_case {
    size_t nu, nv;
    double mass, along_u, along_v, damping, bend;
    int32_t ring_u, ring_v;
    cd_method method;
    double lambda;
    cd_mass_rule rule;
    enum { PLAIN, TORN, HELD } kind;
};

/* HELD: single nodes are pinned, inside, on an edge and at a corner. TORN: one inside, and beside it an absent node and
 * a tie: the directions do not separate. */
static const size_t pinned_inside[2] = {4, 5};
static const double tie = 20;

static const struct sheet_case cases[] = {
    {8, 8, 1, 1, 1, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, PLAIN},
    {40, 12, 0.2, 300, 5, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 1, CD_MASS_EQUAL, PLAIN},
    {16, 24, 3, 20, 2000, 0.01, 0, 0, 0, CD_METHOD_IMPLICIT, 0.55, CD_MASS_HALF_ENDS, PLAIN},
    {12, 9, 1, 50, 70, 0, 0, 1, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, PLAIN},
    {12, 9, 1, 50, 70, 0, 0, 1, 1, CD_METHOD_STIFF_SECOND, 0.5, CD_MASS_HALF_ENDS, PLAIN},
    {10, 14, 2, 10, 10, 0, 3, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, PLAIN},
    {20, 1, 1, 100, 100, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, PLAIN},
    {11, 13, 1, 30, 40, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, TORN},
    {9, 14, 1, 30, 40, 0.01, 0, 0, 1, CD_METHOD_STIFF_SECOND, 0.5, CD_MASS_EQUAL, TORN},
    {11, 13, 1, 30, 40, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, HELD},
    {16, 9, 1, 30, 400, 0.01, 0, 0, 1, CD_METHOD_IMPLICIT, 1, CD_MASS_HALF_ENDS, HELD},
    {9, 30, 1, 500, 40, 0, 0, 1, 0, CD_METHOD_STIFF_SECOND, 0.5, CD_MASS_EQUAL, HELD},
};

static cd_membrane* sheet_of(const struct sheet_case* c, cd_solver solver) {
    cd_membrane* m = NULL;
    ok(cd_membrane_create(c->nu, c->nv, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_mass(m, c->mass));
    ok(cd_membrane_set_mass_rule(m, c->rule));
    ok(cd_membrane_set_stiffness(m, c->along_u, c->along_v));
    ok(cd_membrane_set_stiffness_damping(m, c->damping));
    ok(cd_membrane_set_bend(m, c->bend));
    ok(cd_membrane_set_ring(m, c->ring_u, c->ring_v));
    ok(cd_membrane_set_method(m, c->method));
    if (c->method == CD_METHOD_IMPLICIT) ok(cd_membrane_set_lambda(m, c->lambda));
    ok(cd_membrane_set_edge(m, CD_EDGE_U_FIRST, CD_NODE_PINNED));
    ok(cd_membrane_set_solver(m, solver));
    const double kind = CD_NODE_PINNED, absent = 0;
    if (c->kind != PLAIN) {
        ok(cd_membrane_enable_field(m, CD_PIN));
        ok(cd_membrane_write_f64(m, CD_PIN, pinned_inside[0], pinned_inside[1], 1, 1, &kind, 1));
    }
    if (c->kind == HELD) {
        ok(cd_membrane_write_f64(m, CD_PIN, c->nu, pinned_inside[1], 1, 1, &kind, 1));
        ok(cd_membrane_write_f64(m, CD_PIN, c->nu, c->nv, 1, 1, &kind, 1));
    }
    if (c->kind == TORN) {
        ok(cd_membrane_enable_field(m, CD_MASK));
        ok(cd_membrane_write_f64(m, CD_MASK, 6, 3, 1, 1, &absent, 1));
        ok(cd_membrane_attach(m, 2, 8, tie, 0.1, NULL, 0));
    }
    const size_t count = (c->nu + 1) * (c->nv + 1);
    double* const x = calloc(count, sizeof *x);
    assert_non_null(x);
    for (size_t i = 0; i < count; ++i) x[i] = 0.1 * sin(1.7 * (double)i);
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, c->nu + 1, c->nv + 1, x, count));
    free(x);
    return m;
}

/* Along a direction of n springs, of which the whole sheet has `stiffness` and, with springs parallel to these on
 * `lines` lines, `node` is a node's mass. */
struct rates {
    double spring; /* h (h + damping) times a spring's stiffness over a node's mass */
    double motion; /* (w h)^2 of half a wave, round a ring of a whole one */
};
static struct rates rates_of(size_t n, bool ring, double stiffness, double bend, double lines, double node,
                             double sigma) {
    const double springs = (double)n + ring, phase = (ring ? 2 : 1) * kPi / springs, square = phase * phase;
    const double spring = stiffness * springs / lines, stiff = bend * springs * springs * springs / lines;
    const double rate = sigma * (spring + 2 * stiff * square) / node;
    return (struct rates){rate, rate * square};
}

/* A held node with four springs to nodes that move counts as one, with three as an eighth, round a corner as a 64th; a tied
 * one by its tie's share beside a spring of each direction. */
static double kinks(const struct sheet_case* c, double springs) {
    if (c->kind == PLAIN) return 0;
    if (c->kind == TORN) return 1 + tie / (tie + springs);
    return 1 + 0.125 + (c->ring_v ? 0.125 : 1.0 / 64); /* round a ring along u the next column is held */
}

static double extra_mass(const struct sheet_case* c, double dt) {
    const double share = c->method == CD_METHOD_IMPLICIT ? c->lambda : 1 - sqrt(0.5);
    const double h = share * dt, sigma = h * (h + c->damping);
    const double half = c->rule == CD_MASS_HALF_ENDS ? 0 : 1;
    const double lines_u = (double)c->nu + (c->ring_u ? 1 : half), lines_v = (double)c->nv + (c->ring_v ? 1 : half);
    const double node = c->mass / (lines_u * lines_v);
    const double nodes = ((double)c->nu + 1) * ((double)c->nv + 1);
    const struct rates u = rates_of(c->nu, c->ring_u, c->along_u, c->bend, lines_v, node, sigma);
    const struct rates v = rates_of(c->nv, c->ring_v, c->along_v, c->bend, lines_u, node, sigma);
    const double springs = (u.spring + v.spring) * node / sigma;
    return u.motion * v.motion + 4 * kinks(c, springs) / nodes * u.spring * v.spring;
}

static double dt_at(const struct sheet_case* c, double extra) {
    double low = 1e-9, high = 1e9;
    for (int i = 0; i < 200; ++i) {
        const double middle = sqrt(low * high);
        if (extra_mass(c, middle) < extra) low = middle;
        else high = middle;
    }
    return low;
}

static cd_solver taken(const cd_membrane* m) {
    cd_solver solver = -1;
    ok(cd_membrane_get_solver_taken(m, &solver));
    return solver;
}

static void same_states(const cd_membrane* a, const cd_membrane* b, const struct sheet_case* c) {
    double x[2][1100];
    const size_t count = (c->nu + 1) * (c->nv + 1);
    assert_true(count <= COUNT(x[0]));
    for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
        ok(cd_membrane_read_f64(a, field, 0, 0, c->nu + 1, c->nv + 1, x[0], count));
        ok(cd_membrane_read_f64(b, field, 0, 0, c->nu + 1, c->nv + 1, x[1], count));
        assert_memory_equal(x[0], x[1], count * sizeof x[0][0]);
    }
}

/* With bend not all of these are held at both edges of each direction. */
static bool separates(const struct sheet_case* c) { return c->kind != TORN && c->bend == 0; }

static void a_step_alternates_up_to_its_bound(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        const struct sheet_case* const c = &cases[i];
        if (!separates(c)) continue;
        const double bound = dt_at(c, kMostExtraMass),
                     dts[] = {0.01 * bound, 0.999 * bound, 1.001 * bound, 100 * bound};
        cd_membrane* const m = sheet_of(c, CD_SOLVER_AUTO);
        ok(cd_membrane_set_tolerance(m, 1e-3, 1000));
        assert_int_equal(taken(m), CD_SOLVER_AUTO);
        for (int round = 0; round < 2; ++round)
            for (size_t k = 0; k < COUNT(dts); ++k) {
                ok(cd_membrane_reset(m)); /* or the change of dt would count */
                ok(cd_membrane_step(m, dts[k], 1));
                assert_int_equal(taken(m), k < 2 ? CD_SOLVER_ALTERNATING : CD_SOLVER_COUPLED);
            }
        cd_membrane_destroy(m);
    }
}

static void the_step_is_that_of_the_solver_taken(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(cases); ++i) {
        const struct sheet_case* const c = &cases[i];
        const double bound = dt_at(c, kMostExtraMass);
        cd_membrane* const m = sheet_of(c, CD_SOLVER_AUTO);
        cd_membrane* const other = sheet_of(c, CD_SOLVER_COUPLED);
        /* From one to the other, and not back; where the directions do not separate the other all the time. */
        for (int step = 0; step < 9; ++step) {
            const int alternates = separates(c) && step / 3 == 0;
            const double dt = (step / 3 == 1 ? 3 : 0.5) * bound;
            ok(cd_membrane_set_solver(other, alternates ? CD_SOLVER_ALTERNATING : CD_SOLVER_COUPLED));
            ok(cd_membrane_step(m, dt, 1));
            ok(cd_membrane_step(other, dt, 1));
            assert_int_equal(taken(m), taken(other));
            same_states(m, other, c);
        }
        cd_membrane_destroy(m);
        cd_membrane_destroy(other);
    }
}

/* Sheets of one piece whose lines differ, pinned by an edge, and one that is tied in 17 places. */
enum differing { HOLE, CORNER_GONE, LUMP, SOFT_HALF, TIED, PLATE, DIFFERING };

static cd_membrane* differing_sheet(enum differing which, double bend, cd_solver solver) {
    enum { N = 16, NODES = (N + 1) * (N + 1) };
    cd_membrane* m = NULL;
    double x[NODES], values[NODES];
    ok(cd_membrane_create(N, N, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
    ok(cd_membrane_set_bend(m, bend));
    ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_PINNED));
    ok(cd_membrane_set_solver(m, solver));
    for (size_t i = 0; i < NODES; ++i) {
        const double u = (double)(i % (N + 1)) / N, v = (double)(i / (N + 1)) / N,
                     from_middle = hypot(u - 0.5, v - 0.5);
        x[i] = sin(kPi / 2 * v);
        values[i] = which == HOLE          ? from_middle > 0.2
                    : which == CORNER_GONE ? u < 0.5 || v < 0.5
                    : which == LUMP        ? (from_middle < 0.15 ? 30 : 1) / (double)NODES
                                           : (v < 0.5 ? 1 : 0.1);
    }
    const cd_field field = which == LUMP ? CD_MASS : which == SOFT_HALF ? CD_STIFFNESS_U : CD_MASK;
    if (which < TIED) {
        ok(cd_membrane_enable_field(m, field));
        ok(cd_membrane_write_f64(m, field, 0, 0, N + (field != CD_STIFFNESS_U), N + 1, values,
                                 (N + (field != CD_STIFFNESS_U)) * (N + 1)));
    }
    for (size_t i = 0; i < 17 && which == TIED; ++i)
        ok(cd_membrane_attach(m, i, (5 * i + 3) % N + 1, 0.01, 0, NULL, 0));
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, N + 1, N + 1, x, NODES));
    return m;
}

/* Of lines that differ the best answers that they have leave slow motions anywhere: half a second and more of these
 * went by as if plates stood still. */
static void sheets_whose_lines_differ_keep_their_time_by_default(void** state) {
    (void)state;
    static const double bends[] = {0, 0.1, 1};
    for (size_t b = 0; b < COUNT(bends); ++b)
        for (enum differing which = HOLE; which < DIFFERING; ++which) {
            if (which == PLATE && bends[b] == 0) continue; /* which separates */
            cd_membrane* const m = differing_sheet(which, bends[b], CD_SOLVER_AUTO);
            cd_membrane* const exact = differing_sheet(which, bends[b], CD_SOLVER_COUPLED);
            ok(cd_membrane_set_tolerance(exact, 1e-11, 10000));
            double worst = 0;
            for (int step = 0; step < 120; ++step) {
                double x[17 * 17], right[17 * 17];
                ok(cd_membrane_step(m, 1.0 / 60, 1));
                ok(cd_membrane_step(exact, 1.0 / 60, 1));
                assert_int_equal(taken(m), CD_SOLVER_COUPLED);
                ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, 17, 17, x, COUNT(x)));
                ok(cd_membrane_read_f64(exact, CD_POSITION, 0, 0, 17, 17, right, COUNT(x)));
                for (size_t i = 0; i < COUNT(x); ++i) worst = fmax(worst, fabs(x[i] - right[i]));
            }
            print_message("sheet %d, bend %g: off by %.1e\n", (int)which, bends[b], worst);
            assert_true(worst < 1e-4);
            cd_membrane_destroy(m);
            cd_membrane_destroy(exact);
        }
}

static void what_has_no_such_system_takes_none(void** state) {
    (void)state;
    cd_membrane* m = NULL;
    ok(cd_membrane_create(4, 4, 3, CD_FLOAT32, NULL, &m));
    ok(cd_membrane_step(m, 1e-3, 1));
    assert_int_equal(taken(m), CD_SOLVER_ALTERNATING);
    ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_membrane_step(m, 1e-3, 1));
    assert_int_equal(taken(m), CD_SOLVER_AUTO);
    ok(cd_membrane_set_method(m, CD_METHOD_IMPLICIT));
    ok(cd_membrane_step(m, 1e3, 1));
    assert_int_equal(taken(m), CD_SOLVER_COUPLED);
    ok(cd_membrane_set_rest_length(m, 1, 1)); /* cloth */
    ok(cd_membrane_step(m, 1e-3, 1));
    assert_int_equal(taken(m), CD_SOLVER_AUTO);
    cd_membrane_destroy(m);
    ok(cd_membrane_create(20, 0, 1, CD_FLOAT32, NULL, &m)); /* one line: nothing to couple */
    ok(cd_membrane_step(m, 1e3, 1));
    assert_int_equal(taken(m), CD_SOLVER_ALTERNATING);
    cd_membrane_destroy(m);
}

/* How long a drum's slowest motion takes: steps until its middle has gone down and come back, counted in fractions. */
static double period_of(const struct sheet_case* c, cd_solver solver, double dt) {
    cd_membrane* const m = sheet_of(c, solver);
    double x[33 * 33], before = 0, after = 1, time = 0, crossings[2] = {0, 0};
    int crossed = 0;
    const size_t n = c->nu + 1;
    ok(cd_membrane_set_tolerance(m, 1e-10, 1000));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED));
    for (size_t i = 0; i < n * n; ++i)
        x[i] = sin(kPi * (double)(i % n) / (double)c->nu) * sin(kPi * (double)(i / n) / (double)c->nu);
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, n, n, x, n * n));
    for (int step = 0; step < 400 && crossed < 2; ++step, time += dt) {
        ok(cd_membrane_step(m, dt, 1));
        before = after;
        ok(cd_membrane_read_f64(m, CD_POSITION, c->nu / 2, c->nu / 2, 1, 1, &after, 1));
        if (before * after < 0) crossings[crossed++] = time + dt * before / (before - after);
    }
    assert_int_equal(crossed, 2);
    cd_membrane_destroy(m);
    return 2 * (crossings[1] - crossings[0]);
}

static void what_is_heavier_by_a_twentieth_swings_by_a_fortieth_slower(void** state) {
    (void)state;
    const struct sheet_case c = {32, 32, 1, 1000, 1000, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, 0};
    for (double extra = 1e-4; extra < 100; extra *= 7) {
        const double dt = dt_at(&c, extra);
        const double exact = period_of(&c, CD_SOLVER_COUPLED, dt), found = period_of(&c, CD_SOLVER_AUTO, dt);
        assert_true(found < 1.03 * exact && found > 0.999 * exact);
    }
    const double dt = dt_at(&c, 0.9 * kMostExtraMass); /* and the bound is what it says */
    assert_true(period_of(&c, CD_SOLVER_AUTO, dt) > 1.01 * period_of(&c, CD_SOLVER_COUPLED, dt));
}

/* The figures of membrane.h: at the bound a kick goes further, alternating, than it should; how many times. */
static double reach_of(cd_solver solver, double radius) {
    const struct sheet_case c = {32, 32, 1, 1000, 1000, 0, 0, 0, 0, CD_METHOD_IMPLICIT, 0.5, CD_MASS_EQUAL, 0};
    const double kick = 1, dt = dt_at(&c, 0.99 * kMostExtraMass);
    double x[33 * 33], highest = 0;
    cd_membrane* const m = sheet_of(&c, solver);
    ok(cd_membrane_set_tolerance(m, 1e-10, 1000));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED));
    ok(cd_membrane_reset(m));
    ok(cd_membrane_impulse(m, 16, 16, radius, &kick, 1));
    for (int step = 0; step < 60; ++step) {
        ok(cd_membrane_step(m, dt, 1));
        ok(cd_membrane_read_f64(m, CD_POSITION, 0, 0, 33, 33, x, 33 * 33));
        for (size_t i = 0; i < COUNT(x); ++i) highest = fmax(highest, fabs(x[i]));
    }
    assert_int_equal(taken(m), solver == CD_SOLVER_AUTO ? CD_SOLVER_ALTERNATING : CD_SOLVER_COUPLED);
    cd_membrane_destroy(m);
    return highest;
}
static void short_kicks_go_too_far(void** state) {
    (void)state;
    static const double radii[] = {0, 4, 8}, told[] = {31, 3.5, 1.4};
    for (size_t i = 0; i < COUNT(radii); ++i) {
        const double times = reach_of(CD_SOLVER_AUTO, radii[i]) / reach_of(CD_SOLVER_COUPLED, radii[i]);
        print_message("a kick of radius %g goes %.3f times as far\n", radii[i], times);
        assert_true(fabs(times / told[i] - 1) < 0.03);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_step_alternates_up_to_its_bound),
        cmocka_unit_test(the_step_is_that_of_the_solver_taken),
        cmocka_unit_test(sheets_whose_lines_differ_keep_their_time_by_default),
        cmocka_unit_test(what_has_no_such_system_takes_none),
        cmocka_unit_test(what_is_heavier_by_a_twentieth_swings_by_a_fortieth_slower),
        cmocka_unit_test(short_kicks_go_too_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
