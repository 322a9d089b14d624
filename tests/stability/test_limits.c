/* Explicit methods: bounded below the limit, diverging above it, and forward Euler growing at every step size. */
#include <math.h>

#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NODES = 24, STEPS = 100000, WINDOW = 100 };

/* One chain per way of making omega_max: everything that enters the explicit limit. */
enum feature {
    PLAIN,
    PINNED_END,
    PINNED_BOTH,
    PINNED_INSIDE,
    HALF,
    CLOSED,
    RANDOM_MASSES,
    RANDOM_SPRINGS,
    RANDOM_BOTH,
    CUT,
    WELDED,
    DRAG,
    STIFFNESS_DAMPING,
    ATTACHED,
    ATTACHED_DAMPED,
    MATCHED,
    BEND,
    BEND_PINNED,
    FEATURES
};
static const char* const feature_names[FEATURES] = {
    "free",        "pinned end",    "pinned ends",       "pinned inside", "half ends",
    "ring",        "random masses", "random springs",    "random both",   "cut",
    "welded",      "drag",          "stiffness damping", "attached",      "attached, damped",
    "matched end", "bend",          "bend, pinned ends"};

static cd_chain* make(enum feature feature, cd_precision precision, uint64_t seed) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, NODES - 1, 1, precision, NULL, &chain));
    ok(cd_chain_set_method(chain, CD_METHOD_SYMPLECTIC_EULER));
    ok(cd_chain_set_mass(chain, 1.7));
    ok(cd_chain_set_stiffness(chain, 0.6));
    if (feature == PINNED_END || feature == PINNED_BOTH || feature == BEND_PINNED)
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    if (feature == PINNED_BOTH || feature == BEND_PINNED) ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
    const double pinned = CD_NODE_PINNED;
    if (feature == PINNED_INSIDE) ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, NODES / 3, 1, &pinned, 1));
    if (feature == HALF) ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
    if (feature == CLOSED) ok(cd_chain_set_ring(chain, 1));
    double values[NODES];
    if (feature == RANDOM_MASSES || feature == RANDOM_BOTH) {
        for (size_t i = 0; i < NODES; ++i) values[i] = exp(2 * random_number(&seed));
        ok(cd_chain_enable_field(chain, CD_MASS));
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, values, NODES));
    }
    if (feature == RANDOM_SPRINGS || feature == RANDOM_BOTH) {
        for (size_t i = 0; i < NODES; ++i) values[i] = exp(4 * random_number(&seed));
        ok(cd_chain_enable_field(chain, CD_STIFFNESS));
        ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, NODES - 1, values, NODES - 1));
    }
    if (feature == CUT) ok(cd_chain_cut(chain, 0, 4));
    if (feature == WELDED)
        for (size_t i = 0; i < NODES; i += 3) ok(cd_chain_weld(chain, 0, i));
    if (feature == DRAG) ok(cd_chain_set_drag(chain, 5));
    if (feature == STIFFNESS_DAMPING) ok(cd_chain_set_stiffness_damping(chain, 0.02));
    if (feature == ATTACHED) ok(cd_chain_attach(chain, 0, 5, 90, 0, NULL, 1));
    if (feature == ATTACHED_DAMPED) ok(cd_chain_attach(chain, 0, 5, 50, 0.4, NULL, 1));
    if (feature == MATCHED) ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_MATCHED));
    if (feature == BEND || feature == BEND_PINNED) ok(cd_chain_set_bend(chain, 0.05));
    return chain;
}

static void start_at_random(cd_chain* chain, uint64_t seed) {
    double x[NODES], v[NODES], pin[NODES];
    for (size_t i = 0; i < NODES; ++i) x[i] = random_number(&seed), v[i] = random_number(&seed);
    ok(cd_chain_read_f64(chain, CD_PIN, 0, 1, 0, NODES, pin, NODES));
    for (size_t i = 0; i < NODES; ++i)
        if (pin[i] == CD_NODE_PINNED) x[i] = v[i] = 0;
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
    ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v, NODES));
}

static double energy_of(const cd_chain* chain) {
    double kinetic, elastic;
    ok(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
    return kinetic + elastic;
}

/* Highest energy over the next WINDOW steps. */
static double highest_energy(cd_chain* chain, double dt) {
    double highest = 0;
    for (int k = 0; k < WINDOW; ++k) {
        ok(cd_chain_step(chain, dt, 1));
        highest = fmax(highest, energy_of(chain));
    }
    return highest;
}

static double stable_dt(const cd_chain* chain) {
    double dt = 0;
    ok(cd_chain_stable_dt(chain, &dt));
    assert_true(dt > 0 && isfinite(dt));
    return dt;
}

/* At 0.999 of the limit the fastest mode's energy swings by up to 1 / (1 - 0.999^2) = 500 times, and no more. */
static void symplectic_euler_is_bounded_at_0_999_of_the_limit(void** state) {
    (void)state;
    for (int feature = 0; feature < FEATURES; ++feature)
        for (int p = 0; p < 2; ++p) {
            cd_chain* chain = make((enum feature)feature, p ? CD_FLOAT64 : CD_FLOAT32, 11);
            start_at_random(chain, 5);
            const double dt = 0.999 * stable_dt(chain), start = energy_of(chain);
            const double early = highest_energy(chain, dt);
            ok(cd_chain_step(chain, dt, STEPS - 2 * WINDOW));
            const double late = highest_energy(chain, dt);
            print_message("%-17s float%d: energy x %.3g early, x %.3g after %d steps\n", feature_names[feature],
                          p ? 64 : 32, early / start, late / start, STEPS);
            assert_true(early <= 1000 * start);
            assert_true(late <= 2 * early);
            cd_chain_destroy(chain);
        }
}

static void symplectic_euler_diverges_at_1_001_of_the_limit(void** state) {
    (void)state;
    for (int feature = 0; feature < BEND; ++feature)
        for (int p = 0; p < 2; ++p) {
            cd_chain* chain = make((enum feature)feature, p ? CD_FLOAT64 : CD_FLOAT32, 11);
            start_at_random(chain, 5);
            const double dt = 1.001 * stable_dt(chain), start = energy_of(chain);
            const cd_status status = cd_chain_step(chain, dt, STEPS);
            if (status != CD_ERROR_DIVERGED) {
                ok(status);
                const double growth = energy_of(chain) / start;
                print_message("%-17s float%d: energy x %.3g after %d steps\n", feature_names[feature], p ? 64 : 32,
                              growth, STEPS);
                assert_true(growth > 1e12);
            }
            cd_chain_destroy(chain);
        }
}

/* Uniform lattices have modes: the limit is 2 / omega of the fastest of them, and with bend a lower bound that
 * closes. */
static void stable_dt_is_that_of_the_fastest_mode(void** state) {
    (void)state;
    static const size_t sizes[] = {3, 4, 5, 10, 101, 1000};
    for (int ends = 0; ends < LATTICES; ++ends)
        for (size_t s = 0; s < COUNT(sizes); ++s) {
            const struct lattice_chain l = {
                .ends = (enum lattice)ends, .nodes = sizes[s], .mass = 1.3, .stiffness = 0.8, .bend = 0.3};
            cd_chain* chain = make_lattice_chain(&l, 1, 1, CD_FLOAT64);
            const double exact = (double)(2 / lattice_omega(&l, lattice_last_mode(&l))), got = stable_dt(chain);
            const int bends = ends == HINGED || ends == HINGED_BOTH || ends == RING_BOTH;
            if (s + 1 == COUNT(sizes) || !(fabs(got / exact - 1) < 1e-9))
                print_message("%-15s %4zu nodes: stable_dt / exact = 1 %+.1e\n", lattice_names[ends], l.nodes,
                              got / exact - 1);
            assert_true(got <= exact * (1 + 1e-9));
            if (!bends) assert_true(got >= exact * (1 - 1e-9));
            if (bends && l.nodes >= 101) assert_true(got >= 0.99 * exact);
            cd_chain_destroy(chain);
        }
}

static void stable_dt_is_infinite_where_nothing_swings(void** state) {
    (void)state;
    cd_chain* chain = NULL;
    double dt = 0;
    ok(cd_chain_create(1, 0, 1, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_stable_dt(chain, &dt));
    assert_true(isinf(dt));
    cd_chain_destroy(chain);
    ok(cd_chain_create(1, 3, 1, CD_FLOAT64, NULL, &chain));
    for (size_t i = 0; i < 3; ++i) ok(cd_chain_weld(chain, 0, i));
    ok(cd_chain_stable_dt(chain, &dt));
    assert_true(isinf(dt));
    cd_chain_destroy(chain);
    /* of a ring all springs are welds but for one, which then joins a body to itself */
    for (size_t loose = 0; loose < 4; ++loose) {
        ok(cd_chain_create(1, 3, 1, CD_FLOAT64, NULL, &chain));
        ok(cd_chain_set_ring(chain, 1));
        for (size_t i = 0; i < 4; ++i)
            if (i != loose) ok(cd_chain_weld(chain, 0, i));
        ok(cd_chain_stable_dt(chain, &dt));
        assert_true(isinf(dt));
        ok(cd_chain_attach(chain, 0, 2, 9, 0, NULL, 0)); /* a body of 1 kg: omega = 3 */
        ok(cd_chain_stable_dt(chain, &dt));
        assert_near(dt, 2.0 / 3, 1e-12, 0);
        cd_chain_destroy(chain);
    }
}

/* Without damping every mode's energy grows by |1 + i omega dt|^2 a step, however small dt is. */
static void forward_euler_grows_by_the_exact_factor_at_every_dt(void** state) {
    (void)state;
    for (int lambda0 = 0; lambda0 < 2; ++lambda0)
        for (size_t j = 1; j < NODES; j += 5)
            for (double z = 1e-3; z < 5; z *= 10) {
                const struct lattice_chain l = {.ends = FREE_FREE, .nodes = NODES, .mass = 1.3, .stiffness = 0.8};
                cd_chain* chain = make_lattice_chain(&l, 1, 1, CD_FLOAT64);
                set_time_step(chain, &time_steps[lambda0 ? LAMBDA_0 : FORWARD_EULER]);
                double x[NODES];
                for (size_t i = 0; i < NODES; ++i) x[i] = (double)lattice_shape(&l, j, i);
                ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, NODES, x, NODES));
                const int steps = z > 0.5 ? 4 : 20;
                const double start = energy_of(chain), expected = pow(1 + z * z, steps);
                ok(cd_chain_step(chain, z / (double)lattice_omega(&l, j), (size_t)steps));
                const double growth = energy_of(chain) / start;
                assert_true(expected > 1);
                assert_true(fabs(growth / expected - 1) < 1e-11);
                cd_chain_destroy(chain);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(symplectic_euler_is_bounded_at_0_999_of_the_limit),
        cmocka_unit_test(symplectic_euler_diverges_at_1_001_of_the_limit),
        cmocka_unit_test(stable_dt_is_that_of_the_fastest_mode),
        cmocka_unit_test(stable_dt_is_infinite_where_nothing_swings),
        cmocka_unit_test(forward_euler_grows_by_the_exact_factor_at_every_dt),
    };
    return cmocka_run_group_tests_name("limits", tests, NULL, NULL);
}
