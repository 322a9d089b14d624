/* A sheet far too stiff for its step is one body under the coupled solver; the alternating one makes it heavy, by as
 * much as its closed form says. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "reference.h"
#include "sheet.h"

enum { SIDE = 33, NODES = SIDE * SIDE };
static const double dt = 1.0 / 60, stiff = 1e8;
static const char* const solver_names[] = {"alternating", "coupled"};
static const size_t damped_ways[] = {LAMBDA_1, STIFF_SECOND};

static cd_membrane* make_stiff(cd_mass_rule rule, cd_solver solver, cd_precision precision) {
    const struct sheet s = {.nodes = {SIDE, SIDE}, .rule = rule, .mass = 2, .stiffness = {2 * stiff, 2 * stiff}};
    cd_membrane* m = sheet_membrane(&s, 1, precision);
    ok(cd_membrane_set_solver(m, solver));
    return m;
}

/* Slowest and fastest node. */
static void speeds(const cd_membrane* m, double* out_least, double* out_most) {
    double v[NODES];
    sheet_read(m, CD_VELOCITY, v);
    *out_least = INFINITY, *out_most = -INFINITY;
    for (size_t i = 0; i < NODES; ++i) *out_least = fmin(*out_least, v[i]), *out_most = fmax(*out_most, v[i]);
}

/* Kicked at a corner, the whole sheet flies off at impulse / mass. */
static void a_stiff_sheet_kicked_at_a_corner_moves_as_one_body_when_coupled(void** state) {
    (void)state;
    const double impulse = 3, speed = impulse / 2;
    for (int rule = 0; rule < 2; ++rule)
        for (int p = 0; p < 2; ++p)
            for (size_t w = 0; w < COUNT(damped_ways); ++w) {
                cd_membrane* m = make_stiff(rule, CD_SOLVER_COUPLED, p ? CD_FLOAT64 : CD_FLOAT32);
                double least, most, momentum;
                sheet_set_time_step(m, &time_steps[damped_ways[w]]);
                ok(cd_membrane_impulse(m, 0, 0, 0, &impulse, 1));
                ok(cd_membrane_step(m, dt, 1));
                speeds(m, &least, &most);
                ok(cd_membrane_get_momentum(m, &momentum, 1));
                print_message(
                    "%s, %s, float%d: after one step speeds from %.6f to %.6f of impulse / mass, momentum off "
                    "by %.1e\n",
                    rule ? "half edges" : "equal masses", time_steps[damped_ways[w]].name, p ? 64 : 32, least / speed,
                    most / speed, fabs(momentum / impulse - 1));
                assert_near(momentum, impulse, p ? 1e-7 : 1e-6, 0);
                assert_near(least, speed, damped_ways[w] == LAMBDA_1 ? 1e-3 : 0.5, 0);
                assert_near(most, speed, damped_ways[w] == LAMBDA_1 ? 1e-3 : 0.5, 0);
                ok(cd_membrane_step(m, dt, 60));
                speeds(m, &least, &most);
                assert_near(least, speed, 1e-5, 0);
                assert_near(most, speed, 1e-5, 0);
                cd_membrane_destroy(m);
            }
}

/* What the corner keeps of its kick after a step with lambda 1, over the speed of one body: per mode (1 + a b) / ((1 +
 * a) (1 + b)), summed over all modes. Nearly all of the kick, and the sheet is (springs + 1)^2 nodes. */
static void an_alternating_step_leaves_the_kick_where_it_was(void** state) {
    (void)state;
    const struct sheet s = {.nodes = {SIDE, SIDE}, .mass = 2, .stiffness = {2 * stiff, 2 * stiff}};
    const double impulse = 3, speed = impulse / 2;
    long double kept = 0;
    for (size_t p = 0; p < SIDE; ++p)
        for (size_t q = 0; q < SIDE; ++q) {
            const struct sheet_mode mode = sheet_mode(&s, p, q);
            const long double a = dt * dt * mode.along[0], b = dt * dt * mode.along[1];
            const long double shape = sheet_shape(&s, p, q, 0, 0);
            kept += (p ? 2 : 1) * (q ? 2 : 1) * shape * shape * (1 + a * b) / ((1 + a) * (1 + b));
        }
    cd_membrane* m = make_stiff(CD_MASS_EQUAL, CD_SOLVER_ALTERNATING, CD_FLOAT64);
    double v, momentum;
    ok(cd_membrane_set_lambda(m, 1));
    ok(cd_membrane_impulse(m, 0, 0, 0, &impulse, 1));
    ok(cd_membrane_step(m, dt, 1));
    ok(cd_membrane_read_f64(m, CD_VELOCITY, 0, 0, 1, 1, &v, 1));
    ok(cd_membrane_get_momentum(m, &momentum, 1));
    print_message("alternating: the corner keeps %.1f times the speed of one body, by the closed form %.1f\n",
                  v / speed, (double)kept);
    assert_near(v / speed, (double)kept, 1e-6, 0);
    assert_true(v / speed > 500);
    assert_near(momentum, impulse, 1e-6, 0);
    cd_membrane_destroy(m);
}

/* ---- swinging ---------------------------------------------------------------------------------------------------- */

/* Tied by one soft spring at its middle, a sheet set moving swings as one body: sqrt(k / m). Returns omega over that,
 * from the zero crossings of the mean. */
static double swing(cd_solver solver, double ratio) {
    const struct sheet s = {
        .nodes = {SIDE, SIDE}, .rule = CD_MASS_HALF_ENDS, .mass = 2, .stiffness = {2 * ratio, 2 * ratio}};
    const double tie = 50, omega = sqrt(tie / s.mass);
    cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
    double x[NODES], first = 0, last = 0, before = 0;
    int crossings = 0;
    ok(cd_membrane_set_solver(m, solver));
    ok(cd_membrane_attach(m, SIDE / 2, SIDE / 2, tie, 0, NULL, 0));
    for (size_t i = 0; i < NODES; ++i) x[i] = 1;
    sheet_write(m, CD_POSITION, x);
    for (int step = 1; step < 1200 && crossings < 9; ++step) {
        const double t = step * dt;
        ok(cd_membrane_step(m, dt, 1));
        sheet_read(m, CD_POSITION, x);
        double mean = 0;
        for (size_t i = 0; i < NODES; ++i) mean += x[i] / NODES;
        if (step > 1 && (mean < 0) != (before < 0)) {
            last = t - dt * mean / (mean - before);
            if (crossings++ == 0) first = last;
        }
        before = mean;
    }
    cd_membrane_destroy(m);
    return crossings > 1 ? (double)PI * (crossings - 1) / (last - first) / omega : 0;
}

static void a_stiff_sheet_on_a_soft_spring_swings_as_one_body_when_coupled(void** state) {
    (void)state;
    for (double ratio = 1e4; ratio < 2e8; ratio *= 100) {
        const double coupled = swing(CD_SOLVER_COUPLED, ratio), alternating = swing(CD_SOLVER_ALTERNATING, ratio);
        print_message(
            "stiffness over mass %.0e: swings at %.4f (coupled), %.4f (alternating) of the speed of one body\n", ratio,
            coupled, alternating);
        assert_near(coupled, 1, 5e-3, 0); /* lambda 1/2 itself is 1e-3 slow, and a soft sheet a little more */
    }
}

/* ---- yielding ---------------------------------------------------------------------------------------------------- */

/* A drum head in its lowest mode under a load of that shape, with lambda 1: how much of the way to its rest it goes in
 * the first step, 1 - 1 / (1 + a + b) coupled and (a + b) / ((1 + a) (1 + b)) alternating, and when it gets there. */
static void a_stiff_drum_yields_at_once_when_coupled_and_slowly_when_alternating(void** state) {
    (void)state;
    const struct sheet s = {
        .ends = {SHEET_FIXED, SHEET_FIXED}, .nodes = {SIDE, SIDE}, .mass = 2, .stiffness = {2 * stiff, 2 * stiff}};
    const struct sheet_mode mode = sheet_mode(&s, 1, 1);
    const double a = dt * dt * (double)mode.along[0], b = dt * dt * (double)mode.along[1];
    const double rest = 1 / (double)(mode.along[0] + mode.along[1]);
    size_t steps[2];
    for (int solver = 0; solver < 2; ++solver) {
        cd_membrane* m = sheet_membrane(&s, 1, CD_FLOAT64);
        double force[NODES], x, first = 0;
        for (size_t i = 0; i < NODES; ++i)
            force[i] = (double)(sheet_node_mass(&s) * sheet_shape(&s, 1, 1, i % SIDE, i / SIDE));
        ok(cd_membrane_set_lambda(m, 1));
        ok(cd_membrane_set_solver(m, solver));
        ok(cd_membrane_set_tolerance(m, 1e-10, 100));
        ok(cd_membrane_enable_field(m, CD_FORCE));
        sheet_write(m, CD_FORCE, force);
        for (steps[solver] = 0, x = 0; x < rest * 0.999 && steps[solver] < 100000;) {
            sheet_step(m, dt, 1);
            x = sheet_get(m, CD_POSITION, SIDE / 2, SIDE / 2);
            if (++steps[solver] == 1) first = x / rest;
        }
        const double expected = solver ? 1 - 1 / (1 + a + b) : (a + b) / ((1 + a) * (1 + b));
        print_message("a stiff drum goes %.3g of its way in the first step (%s) and is there after %zu\n", first,
                      solver_names[solver], steps[solver]);
        assert_near(first, expected, 1e-6, 0);
        cd_membrane_destroy(m);
    }
    /* the mass seems 1 + a b as large: a quarter of its period is pi / 2 sqrt(a b / (a + b)) steps */
    const double quarter = (double)PI / 2 * sqrt(a * b / (a + b));
    assert_true(steps[1] == 1);
    assert_true((double)steps[0] > 0.5 * quarter && (double)steps[0] < 2 * quarter);
    assert_true(quarter > 300);
}

/* ---- single lines ------------------------------------------------------------------------------------------------ */

enum { ROD = 15 };
static const struct rod {
    const char* name;
    cd_node first, last, middle, aside; /* aside: the edge across, which is the whole line */
    int ring;
} rods[] = {
    {.name = "free"},
    {.name = "held at its first end", .first = CD_NODE_PINNED},
    {.name = "held at its last end", .last = CD_NODE_PINNED},
    {.name = "hinged", .first = CD_NODE_PINNED, .last = CD_NODE_PINNED},
    {.name = "held at its middle", .middle = CD_NODE_PINNED},
    {.name = "driven and matched", .first = CD_NODE_DRIVEN, .last = CD_NODE_MATCHED},
    {.name = "ring", .ring = 1},
    {.name = "held as a whole", .aside = CD_NODE_PINNED},
};

/* A line of nodes of mass 1 along u or along v with bend alone, for steps of 1 s; ratio: h (h + damping) times the bend
 * over the mass. */
static cd_membrane* make_rod(const struct rod* r, int along, cd_precision precision, double h, double ratio) {
    cd_membrane* m;
    const double springs = r->ring ? ROD : ROD - 1, pinned = CD_NODE_PINNED;
    double x[ROD];
    ok(cd_membrane_create(along ? 0 : ROD - 1, along ? ROD - 1 : 0, 1, precision, NULL, &m));
    ok(cd_membrane_set_mass(m, ROD));
    ok(cd_membrane_set_ring(m, r->ring && !along, r->ring && along));
    ok(cd_membrane_set_stiffness(m, 0, 0));
    ok(cd_membrane_set_bend(m, ratio / (h * h) / (springs * springs * springs)));
    ok(cd_membrane_set_edge(m, 2 * along, r->first));
    ok(cd_membrane_set_edge(m, 2 * along + 1, r->last));
    ok(cd_membrane_set_edge(m, 2 * !along, r->aside));
    if (r->middle) {
        ok(cd_membrane_enable_field(m, CD_PIN));
        sheet_set(m, CD_PIN, along ? 0 : ROD / 2, along ? ROD / 2 : 0, pinned);
    }
    for (size_t i = 0; i < ROD; ++i) x[i] = sin(0.37 * (double)i);
    sheet_write(m, CD_POSITION, x);
    return m;
}

/* However stiff its bend: a step solves such a line exactly, and rounding gives it no energy. */
static void a_single_stiff_line_keeps_its_energy(void** state) {
    (void)state;
    static const double ratios[] = {1e5, 1e8, 1e10, 1e12, 1e16, 1e20, 1e24};
    static const size_t all_ways[] = {LAMBDA_1_2, LAMBDA_1, STIFF_SECOND};
    double worst[2] = {0};
    for (size_t k = 0; k < COUNT(rods); ++k)
        for (size_t n = 0; n < COUNT(ratios) * COUNT(all_ways); ++n)
            for (int along = 0; along < 2; ++along)
                for (int p = 0; p < 2; ++p) {
                    const struct time_step* way = &time_steps[all_ways[n % COUNT(all_ways)]];
                    cd_membrane* m =
                        make_rod(&rods[k], along, p ? CD_FLOAT64 : CD_FLOAT32, 0.5, ratios[n / COUNT(all_ways)]);
                    double gain = 0, start[ROD], end[ROD];
                    sheet_read(m, CD_POSITION, start);
                    sheet_set_time_step(m, way);
                    const double energy = sheet_swing_energy(m);
                    for (int step = 0; step < 200; ++step) {
                        sheet_step(m, 1, 1);
                        gain = fmax(gain, sheet_swing_energy(m) / energy - 1);
                    }
                    sheet_read(m, CD_POSITION, end);
                    for (size_t i = 0; i < ROD && rods[k].aside; ++i) assert_true(end[i] == start[i]);
                    worst[p] = fmax(worst[p], gain);
                    if (!(gain <= (p ? 1e-8 : 1e-4)))
                        fail_msg("%s, along %c, %s, float%d, bend over mass %.0e: energy gains %.3g", rods[k].name,
                                 along ? 'v' : 'u', way->name, p ? 64 : 32, ratios[n / COUNT(all_ways)], gain);
                    cd_membrane_destroy(m);
                }
    print_message("single lines gain at most %.1e of their energy in float64, %.1e in float32\n", worst[1], worst[0]);
}

/* As a chain does, whose steps are exact too. */
static void a_single_stiff_line_moves_as_a_chain(void** state) {
    (void)state;
    double worst = 0;
    for (size_t k = 0; k < COUNT(rods); ++k)
        for (int along = 0; along < 2 && !rods[k].aside; ++along)
            for (double ratio = 1e5; ratio < 2e13; ratio *= 100) {
                const struct rod* r = &rods[k];
                const double springs = r->ring ? ROD : ROD - 1, pinned = CD_NODE_PINNED;
                double x[ROD], of_chain[ROD], off = 0, most = 1;
                cd_membrane* m = make_rod(r, along, CD_FLOAT64, 0.5, ratio);
                cd_chain* chain;
                ok(cd_chain_create(1, ROD - 1, 1, CD_FLOAT64, NULL, &chain));
                ok(cd_chain_set_ring(chain, r->ring));
                ok(cd_chain_set_mass(chain, ROD));
                ok(cd_chain_set_stiffness(chain, 0));
                ok(cd_chain_set_bend(chain, ratio * 4 / (springs * springs * springs)));
                ok(cd_chain_set_end(chain, CD_END_FIRST, r->first));
                ok(cd_chain_set_end(chain, CD_END_LAST, r->last));
                if (r->middle) {
                    ok(cd_chain_enable_field(chain, CD_PIN));
                    ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, ROD / 2, 1, &pinned, 1));
                }
                sheet_read(m, CD_POSITION, x);
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, ROD, x, ROD));
                for (int step = 0; step < 50; ++step) {
                    sheet_step(m, 1, 1);
                    ok(cd_chain_step(chain, 1, 1));
                    sheet_read(m, CD_POSITION, x);
                    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, ROD, of_chain, ROD));
                    for (size_t i = 0; i < ROD; ++i)
                        off = fmax(off, fabs(x[i] - of_chain[i])), most = fmax(most, fabs(of_chain[i]));
                }
                worst = fmax(worst, off / most);
                if (!(off <= 1e-8 * most))
                    fail_msg("%s, along %c, bend over mass %.0e: moves wrongly by %.3g of %.3g", r->name,
                             along ? 'v' : 'u', ratio, off, most);
                cd_membrane_destroy(m);
                cd_chain_destroy(chain);
            }
    print_message("single lines are off by at most %.1e of the way of a chain\n", worst);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stiff_sheet_kicked_at_a_corner_moves_as_one_body_when_coupled),
        cmocka_unit_test(an_alternating_step_leaves_the_kick_where_it_was),
        cmocka_unit_test(a_stiff_sheet_on_a_soft_spring_swings_as_one_body_when_coupled),
        cmocka_unit_test(a_single_stiff_line_keeps_its_energy),
        cmocka_unit_test(a_single_stiff_line_moves_as_a_chain),
        cmocka_unit_test(a_stiff_drum_yields_at_once_when_coupled_and_slowly_when_alternating),
    };
    return cmocka_run_group_tests_name("membrane rigid", tests, NULL, NULL);
}
