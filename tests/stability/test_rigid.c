/* The stiff limit: a textbook elimination loses the chain, and a chain welded throughout is one body. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NODES = 1001, SPRINGS = NODES - 1 };

/* One lambda step as most codes make it, in float32: forms the diagonal m + h^2 (k_left + k_right), which forgets m,
 * and eliminates by L D L^T. */
static void textbook_step(const float* mass, const float* spring, float* x, float* v, float dt, float lambda) {
    static float diagonal[NODES], side[NODES];
    const float h = lambda * dt, h2 = h * h;
    for (size_t i = 0; i < NODES; ++i) {
        const float left = i > 0 ? spring[i - 1] : 0, right = i < SPRINGS ? spring[i] : 0;
        const float here = x[i] + h * v[i];
        float force = 0;
        if (i > 0) force += left * (x[i - 1] + h * v[i - 1] - here);
        if (i < SPRINGS) force += right * (x[i + 1] + h * v[i + 1] - here);
        diagonal[i] = mass[i] + h2 * (left + right);
        side[i] = dt * force;
    }
    for (size_t i = 1; i < NODES; ++i) {
        const float l = -h2 * spring[i - 1] / diagonal[i - 1];
        diagonal[i] += l * h2 * spring[i - 1];
        side[i] -= l * side[i - 1];
    }
    for (size_t i = NODES; i-- > 0;) {
        const float next = i < SPRINGS ? h2 * spring[i] * side[i + 1] : 0;
        side[i] = (side[i] + next) / diagonal[i];
    }
    for (size_t i = 0; i < NODES; ++i) {
        x[i] += dt * (v[i] + lambda * side[i]);
        v[i] += side[i];
    }
}

static double error_of(const float* got, const long double* exact) {
    long double error = 0, size = 0;
    for (size_t i = 0; i < NODES; ++i) {
        if (!isfinite(got[i])) return INFINITY;
        error = fmaxl(error, fabsl(got[i] - exact[i]));
        size = fmaxl(size, fabsl(exact[i]));
    }
    return (double)(error / size);
}

/* The same states, masses and springs into both; dt = 1, so that stiffness over mass is what the solver meets. */
static void a_textbook_elimination_fails_where_the_library_holds(void** state) {
    (void)state;
    static const double ratios[] = {1, 1e2, 1e8, 1e12, 1e16, 1e20, 1e30};
    static float mass[NODES], spring[NODES], x[NODES], v[NODES], xt[NODES], vt[NODES];
    for (size_t k = 0; k < COUNT(ratios); ++k) {
        struct reference* r = reference_create(NODES);
        uint64_t seed = 7;
        for (size_t i = 0; i < NODES; ++i) {
            r->mass[i] = mass[i] = (float)exp2(random_number(&seed));
            r->stretch[i] = spring[i] = (float)(ratios[k] * exp2(random_number(&seed)));
            r->x[i] = xt[i] = x[i] = (float)random_number(&seed);
            r->v[i] = vt[i] = v[i] = (float)random_number(&seed);
        }
        cd_chain* chain = NULL;
        ok(cd_chain_create(1, SPRINGS, 1, CD_FLOAT32, NULL, &chain));
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_enable_field(chain, CD_MASS));
        ok(cd_chain_enable_field(chain, CD_STIFFNESS));
        ok(cd_chain_write_f32(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
        ok(cd_chain_write_f32(chain, CD_STIFFNESS, 0, 1, 0, SPRINGS, spring, SPRINGS));
        ok(cd_chain_write_f32(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
        ok(cd_chain_write_f32(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
        ok(cd_chain_step(chain, 1, 1));
        ok(cd_chain_read_f32(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
        ok(cd_chain_read_f32(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
        textbook_step(mass, spring, xt, vt, 1, 1);
        reference_step(r, CD_METHOD_IMPLICIT, 1, 1, 1);
        const double library = fmax(error_of(x, r->x), error_of(v, r->v));
        const double textbook = fmax(error_of(xt, r->x), error_of(vt, r->v));
        print_message("k/m %-6.0e one step in float32: library %.1e, textbook %.1e\n", ratios[k], library, textbook);
        assert_true(library <= 1e-5);
        if (ratios[k] <= 1) assert_true(textbook <= 1e-5);
        if (ratios[k] >= 1e8) assert_false(textbook <= 0.1);
        reference_destroy(r);
        cd_chain_destroy(chain);
    }
}

static void momentum_of(const cd_chain* chain, double* out_momentum) {
    ok(cd_chain_get_momentum(chain, out_momentum, 1));
}

/* All joints welded: every velocity becomes the mean by mass and stays it, offsets stay what they were. */
static void welded_throughout(cd_precision precision, const struct time_step* step, double allowed) {
    double mass[NODES], x0[NODES], x[NODES], v[NODES];
    uint64_t seed = 3;
    for (size_t i = 0; i < NODES; ++i) {
        mass[i] = exp2(random_number(&seed)) / NODES;
        x0[i] = random_number(&seed);
        v[i] = 0.5 + random_number(&seed);
    }
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, SPRINGS, 1, precision, NULL, &chain));
    set_time_step(chain, step);
    ok(cd_chain_enable_field(chain, CD_MASS));
    ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x0, NODES));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x0, NODES));
    double before, welded, after;
    momentum_of(chain, &before);
    /* in an order that joins groups of all sizes */
    for (size_t i = 0; i < SPRINGS; ++i) ok(cd_chain_weld(chain, 0, i * 7 % SPRINGS));
    momentum_of(chain, &welded);
    const double dt = 1.0 / 64;
    ok(cd_chain_step(chain, dt, 1000));
    momentum_of(chain, &after);
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
    double spread = 0, shift = 0;
    long double total = 0;
    for (size_t i = 0; i < NODES; ++i) total += mass[i];
    const double speed = (double)(before / total), way = speed * 1000 * dt;
    for (size_t i = 0; i < NODES; ++i) {
        spread = fmax(spread, fabs(v[i] - speed) / speed);
        shift = fmax(shift, fabs(x[i] - x0[i] - way) / way);
    }
    print_message("%s float%d: momentum changes by %.1e (welding), %.1e (1000 steps), speeds by %.1e, ways by %.1e\n",
                  step->name, precision == CD_FLOAT32 ? 32 : 64, fabs(welded / before - 1), fabs(after / before - 1),
                  spread, shift);
    assert_true(fabs(welded / before - 1) <= allowed);
    assert_true(fabs(after / before - 1) <= allowed);
    assert_true(spread <= allowed);
    /* 1000 roundings of positions, all to the same side if need be */
    assert_true(shift <= 10 * allowed);
    cd_chain_destroy(chain);
}

static void a_chain_welded_throughout_moves_as_one_body_and_keeps_its_momentum(void** state) {
    (void)state;
    for (size_t m = 0; m < TIME_STEPS; ++m) {
        welded_throughout(CD_FLOAT32, &time_steps[m], 1e-5);
        welded_throughout(CD_FLOAT64, &time_steps[m], 1e-12);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_textbook_elimination_fails_where_the_library_holds),
        cmocka_unit_test(a_chain_welded_throughout_moves_as_one_body_and_keeps_its_momentum),
    };
    return cmocka_run_group_tests_name("rigid", tests, NULL, NULL);
}
