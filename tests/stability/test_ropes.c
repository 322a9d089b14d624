/* Ropes in scenes that are hard for a solver, at steps from 1/600 s to 1 s: finite, as long as they should be to the
 * tolerance, and no energy from nothing. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "reference.h"

enum { MOST_NODES = 101 };

struct scene {
    size_t nodes, components;
    double mass[MOST_NODES], x[MOST_NODES][3], v[MOST_NODES][3];
    double stiffness[MOST_NODES]; /* of springs */
    double length;                /* of a spring */
    int pin[MOST_NODES];
    double gravity;
    int push;                 /* springs push as well */
    double bend;              /* of the whole rope */
    double angle[MOST_NODES]; /* at rest; of 2 components */
};

/* A rope of 10 m and 1 kg, level, its first node pinned. */
static void level(struct scene* s, size_t nodes) {
    memset(s, 0, sizeof *s);
    s->nodes = nodes, s->components = 3;
    s->length = 10.0 / (double)(nodes - 1);
    s->gravity = -9.81;
    s->pin[0] = CD_NODE_PINNED;
    for (size_t i = 0; i < nodes; ++i) {
        s->mass[i] = 1.0 / (double)nodes;
        s->x[i][0] = s->length * (double)i;
        s->stiffness[i] = INFINITY;
    }
}
static void random_walk(struct scene* s, double speed, uint64_t* seed) {
    for (size_t i = 1; i < s->nodes; ++i) {
        double way[3], size = 0;
        for (size_t k = 0; k < s->components; ++k) way[k] = random_number(seed), size += way[k] * way[k];
        for (size_t k = 0; k < s->components; ++k) {
            s->x[i][k] = s->x[i - 1][k] + s->length * way[k] / sqrt(size);
            s->v[i][k] = speed * random_number(seed);
        }
    }
}

enum hard {
    HEAVY_END,
    LIGHT_END,
    HEAVY_SECONDS,
    THROWN,
    ONE_POINT,
    CRUMPLED,
    WHIP,
    STRAIGHT_BETWEEN_PINS,
    RANDOM_MASSES,
    SOFT,
    MIXED,
    TOO_LONG,
    FAR_APART,
    BETWEEN_HEAVY,
    HARD
};
static const char* const names[HARD] = {"end 1e6 times heavier",
                                        "end 1e6 times lighter",
                                        "every second node 1e6 times heavier",
                                        "thrown at random",
                                        "all nodes in one point",
                                        "crumpled",
                                        "end driven at 50 m/s",
                                        "straight between two pins",
                                        "free, masses from 1e-3 to 1e3",
                                        "soft",
                                        "springs from 1 to infinity",
                                        "twice as long as it may be",
                                        "free, at rest, nodes far apart",
                                        "light between two heavy ends"};

static void build(struct scene* s, enum hard hard) {
    uint64_t seed = 10 + (uint64_t)hard;
    level(s, hard == STRAIGHT_BETWEEN_PINS ? 65 : 101);
    const size_t last = s->nodes - 1;
    if (hard == HEAVY_END || hard == BETWEEN_HEAVY) s->mass[last] *= 1e6;
    if (hard == BETWEEN_HEAVY) s->mass[0] *= 1e6, s->pin[0] = CD_NODE_FREE, s->v[0][1] = 3, s->v[last][1] = -3;
    if (hard == LIGHT_END) s->mass[last] *= 1e-6;
    for (size_t i = 0; i <= last; i += 2)
        if (hard == HEAVY_SECONDS) s->mass[i] *= 1e6;
    if (hard == THROWN || hard == RANDOM_MASSES) random_walk(s, 10, &seed);
    for (size_t i = 0; i <= last; ++i) {
        if (hard == ONE_POINT) s->x[i][0] = 0;
        if (hard == CRUMPLED) s->x[i][0] /= 2, s->x[i][1] = 1e-3 * (double)(i % 2);
        if (hard == TOO_LONG) s->x[i][0] *= 2;
        for (int k = 0; k < 3 && hard == FAR_APART; ++k) s->x[i][k] = 1000 * random_number(&seed);
        if (hard == RANDOM_MASSES) s->mass[i] *= pow(10, 3 * random_number(&seed));
        if (hard == SOFT) s->stiffness[i] = 100 * 20;
        if (hard == MIXED) s->stiffness[i] = i % 7 == 3 ? INFINITY : pow(10, 5 + 5 * random_number(&seed));
    }
    if (hard == WHIP) s->pin[last] = CD_NODE_DRIVEN, s->v[last][1] = 50;
    if (hard == STRAIGHT_BETWEEN_PINS) s->pin[last] = CD_NODE_PINNED;
    if (hard == WHIP || hard == RANDOM_MASSES || hard == FAR_APART || hard == BETWEEN_HEAVY)
        s->pin[0] = CD_NODE_FREE, s->gravity = 0;
}

static cd_chain* make(const struct scene* s, double lambda, cd_precision precision) {
    const size_t n = s->nodes, components = s->components;
    const double gravity[3] = {0, s->gravity, 0};
    double pin[MOST_NODES];
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, n - 1, components, precision, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, s->length * (double)(n - 1)));
    ok(cd_chain_set_lambda(chain, lambda));
    ok(cd_chain_set_push(chain, s->push));
    ok(cd_chain_set_bend(chain, s->bend));
    ok(cd_chain_set_gravity(chain, gravity, components));
    ok(cd_chain_enable_field(chain, CD_MASS));
    ok(cd_chain_enable_field(chain, CD_STIFFNESS));
    for (size_t i = 0; i < n; ++i) pin[i] = s->pin[i];
    ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, n, s->mass, n));
    ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 0, n - 1, s->stiffness, n - 1));
    for (size_t i = 0; i < n; ++i) {
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, i, 1, s->x[i], components));
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, s->v[i], components));
    }
    ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 0, n, pin, n));
    if (components == 2) ok(cd_chain_enable_field(chain, CD_REST_ANGLE));
    if (components == 2) ok(cd_chain_write_f64(chain, CD_REST_ANGLE, 0, 1, 0, n, s->angle, n));
    return chain;
}

struct result {
    double energy, stretch, kinetic;
    double tension, slack; /* the largest; and the largest times how much its spring is too short for it */
    double worth;          /* of the tolerance: what energy lengths that differ by it stand for; and of rounding */
};
static struct result look(const cd_chain* chain, const struct scene* s, double tolerance) {
    struct result r = {0, 0, 0, 0, 0, 0};
    const size_t components = s->components;
    double x[3 * MOST_NODES], tension[MOST_NODES], elastic, gravity;
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, s->nodes, x, components * s->nodes));
    ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, s->nodes - 1, tension, s->nodes - 1));
    ok(cd_chain_get_energy(chain, &r.kinetic, &elastic, &gravity));
    r.energy = r.kinetic + elastic + gravity;
    r.worth = 1e-14 * (double)(s->nodes * s->nodes) * elastic;
    for (size_t i = 0; i + 1 < s->nodes; ++i) {
        double d = 0;
        for (const double* a = x + i * components; a < x + (i + 1) * components; ++a)
            d += (a[components] - a[0]) * (a[components] - a[0]);
        const double over = (sqrt(d) - s->length - tension[i] / s->stiffness[i]) / s->length;
        r.stretch = fmax(r.stretch, s->push && s->stiffness[i] > 0 ? fabs(over) : over);
        r.tension = fmax(r.tension, tension[i]), r.slack = fmax(r.slack, -tension[i] * over);
        const double wrong = tolerance * s->length;
        r.worth += fabs(tension[i]) * wrong + (isinf(s->stiffness[i]) ? 0 : 0.5 * s->stiffness[i] * wrong * wrong);
        assert_true(tension[i] >= 0 || s->push);
    }
    return r;
}

/* What a run of steps came to. */
struct run {
    int missed;                  /* steps that ended short of the tolerance */
    double stretch, gain, scale; /* the longest stretch after a step that did not; energy that came from nothing */
    double drift;                /* of the momentum of a free rope, over the sum of its nodes' */
    double slack;                /* tension of springs that are too short, over the forces, over the tolerance */
    double iterations;
};
static int is_free(const struct scene* s) {
    for (size_t i = 0; i < s->nodes; ++i)
        if (s->pin[i] != CD_NODE_FREE) return 0;
    return 1;
}

static struct run run(cd_chain* chain, const struct scene* s, double dt, int steps, double tolerance, int driven) {
    struct run run = {0, 0, 0, 0, 0, 0, 0};
    double mass = 0, before_p[3] = {0, 0, 0}, p[3] = {0, 0, 0};
    for (size_t i = 0; i < s->nodes; ++i) mass += s->mass[i];
    struct result before = look(chain, s, tolerance);
    cd_status before_status = CD_OK;
    run.scale = fmax(mass * 98.1, before.kinetic);
    for (int step = 0; step < steps; ++step) {
        size_t iterations;
        ok(cd_chain_get_momentum(chain, before_p, s->components));
        const cd_status status = cd_chain_step(chain, dt, 1);
        assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
        ok(cd_chain_get_convergence(chain, &iterations, NULL));
        ok(cd_chain_get_momentum(chain, p, s->components));
        run.iterations += (double)iterations / steps;
        const struct result after = look(chain, s, tolerance);
        assert_true(isfinite(after.energy));
        const double size = sqrt(2 * mass * fmax(before.kinetic, after.kinetic)) + mass * 9.81 * dt;
        for (int k = 0; k < 3 && status == CD_OK && is_free(s); ++k)
            run.drift = fmax(run.drift, fabs(p[k] - before_p[k] - (k == 1 ? mass * s->gravity * dt : 0)) / size);
        if (status != CD_OK) ++run.missed;
        else run.stretch = fmax(run.stretch, after.stretch);
        /* the interior point, after Newton's 8 or 16 iterations, counts the mean force on the nodes as tension */
        const double room = before.worth + after.worth + (iterations > 8 ? tolerance * s->length * size / dt : 0);
        const double force = fmax(after.tension, size / dt + mass * s->length / (dt * dt));
        if (status == CD_OK && !s->push) run.slack = fmax(run.slack, after.slack / (force * tolerance));
        if (status == CD_OK && before_status == CD_OK && !driven) /* else lengths were wrong before it */
            run.gain = fmax(run.gain, after.energy - before.energy - 2 * room);
        before = after, before_status = status;
    }
    return run;
}

static void hard_scenes_stay_bounded(void** state) {
    (void)state;
    static const double steps[] = {1.0 / 600, 1.0 / 60, 0.1, 1};
    static const double lambdas[] = {0.5, 0.6, 1}, bends[] = {0, 1e-6, 1e-2, 1e4};
    for (int run_number = 0; run_number < HARD * (int)COUNT(bends); ++run_number) {
        const int hard = run_number / (int)COUNT(bends);
        static struct scene s;
        build(&s, (enum hard)hard);
        s.bend = bends[run_number % (int)COUNT(bends)];
        if (hard == FAR_APART && s.bend > 1e-6) continue; /* 1e12 J of bend, and a step that ends short says so */
        int missed = 0;
        double stretch = 0, gain = 0, drift = 0, most = 0;
        for (size_t l = 0; l < COUNT(lambdas); ++l)
            for (size_t k = 0; k < COUNT(steps); ++k)
                for (int precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                    if (!is_taken((size_t)run_number + l + k + (size_t)precision, 3)) continue;
                    const double tolerance = precision == CD_FLOAT64 ? 1e-6 : 1e-4;
                    cd_chain* chain = make(&s, lambdas[l], precision);
                    ok(cd_chain_set_tolerance(chain, tolerance, 200));
                    const int count = steps[k] < 0.01 ? 600 : 200;
                    const struct run r = run(chain, &s, steps[k], count, tolerance, hard == WHIP);
                    missed += r.missed;
                    if (precision == CD_FLOAT64)
                        stretch = fmax(stretch, r.stretch), gain = fmax(gain, r.gain / r.scale),
                        drift = fmax(drift, r.drift);
                    most = fmax(most, r.iterations);
                    cd_chain_destroy(chain);
                }
        print_message("%-36s bend %g, missed %d, stretch %.1e, gain %.1e of the scale, up to %.1f iterations\n",
                      names[hard], s.bend, missed, stretch, gain, most);
        assert_true(stretch <= 1.001e-6);
        /* 19 at a heavy end where errors within the tolerance become velocities */
        assert_true(most < (hard == HEAVY_END && s.bend == 0 ? 12 : 30));
        assert_true(drift < 1e-10);
        assert_int_equal(missed, 0);
        if (hard == TOO_LONG || hard == FAR_APART) continue; /* they shorten by a jerk */
        assert_true(gain < 1e-9);
    }
}

/* Stiff rods that pushed, or that pinned nodes hold bent, and made energy without a word where joints were not asked; and
 * ropes whose spring in the middle began with more tension than it could have at its length. */
static const int harder[] = {6259, 16907, 25179, 41170, 47860};

static void random_ropes_stay_bounded(int random, const int* hard, int hard_count, int curled) {
    const int count = random + hard_count;
    int missed = 0;
    double stretch = 0, gain = 0, drift = 0, slack = 0;
    for (int k = 0; k < count; ++k) {
        const int number = k < random ? k : hard[k - random];
        static struct scene s;
        uint64_t seed = 1000 + (uint64_t)number;
        const double lambda = number % 3 == 0 ? 1 : 0.75 + 0.25 * random_number(&seed);
        const double dt = pow(10, -1.4 + 1.4 * random_number(&seed)), decades = 3 * fabs(random_number(&seed));
        level(&s, 2 + (size_t)(49 * fabs(random_number(&seed))));
        if (curled) s.components = 2;
        if (number % 2) random_walk(&s, 5, &seed);
        for (size_t i = 0; i < s.nodes; ++i) {
            s.mass[i] *= pow(10, decades * random_number(&seed));
            if (number % 5 == 0) s.stiffness[i] = pow(10, 4 + 4 * random_number(&seed));
            if (number % 7 == 0 && random_number(&seed) > 0.9) s.stiffness[i] = 0;
            if (number % 11 == 0 && random_number(&seed) > 0.9) {
                s.pin[i] = CD_NODE_PINNED;
                memset(s.v[i], 0, sizeof s.v[i]);
            }
        }
        for (size_t i = 0; i < s.nodes && number % 9 == 4; ++i) /* along a line, and folded */
            s.x[i][0] = 0, s.x[i][2] = 0, s.v[i][0] = 0, s.v[i][2] = 0;
        memset(s.v[0], 0, sizeof s.v[0]);
        if (number % 4 == 1) s.pin[0] = CD_NODE_FREE;
        const double tolerance = pow(10, number % 3 == 1 ? -2 : -6);
        s.push = number % 8 == 3 && number % 9 != 4;
        if (number % 2 || curled) s.bend = pow(10, (k < random ? 5 : 6) * random_number(&seed));
        for (size_t i = 0; i < s.nodes && curled; ++i)
            s.angle[i] = (number % 5 == 2 ? 0.1 : 3.141592653589793) * random_number(&seed);
        cd_chain* chain = make(&s, lambda, CD_FLOAT64);
        ok(cd_chain_set_tolerance(chain, tolerance, 200));
        double tension[MOST_NODES];
        for (size_t i = 0; i < s.nodes; ++i) tension[i] = 100 * fabs(random_number(&seed));
        if (number % 8 == 7 || number % 9 == 4)
            ok(cd_chain_write_f64(chain, CD_TENSION, 0, 1, 0, s.nodes - 1, tension, s.nodes - 1));
        const struct run r = run(chain, &s, dt, 40, tolerance, 0);
        cd_chain_destroy(chain);
        if (!s.push) missed += r.missed; /* Newton's method alone may fail: it is told */
        stretch = fmax(stretch, r.stretch / tolerance);
        gain = fmax(gain, r.gain / r.scale);
        drift = fmax(drift, r.drift);
        slack = fmax(slack, r.slack);
        if ((r.missed && !s.push) || r.gain > 1e-9 * r.scale || r.stretch > 1.001 * tolerance || r.drift > 1e-10)
            print_message("rope %d: %zu nodes, lambda %.3f, dt %.3g: missed %d, stretch %.1e, gain %.1e, drift %.1e\n",
                          number, s.nodes, lambda, dt, r.missed, r.stretch, r.gain / r.scale, r.drift);
    }
    print_message(
        "%d random ropes: missed %d steps, stretch %.3f of the tolerance, gain %.1e, momentum off by %.1e, "
        "tension of slack springs %.3f of the tolerance\n",
        count, missed, stretch, gain, drift, slack);
    assert_int_equal(missed, 0);
    assert_true(stretch <= 1.001);
    assert_true(drift < 1e-10);
    assert_true(slack <= 1);
    assert_true(gain < 1e-9);
}

static void thousands_of_random_ropes_stay_bounded(void** state) {
    (void)state;
    random_ropes_stay_bounded(is_long() ? 50000 : 5000, harder, (int)COUNT(harder), 0);
}
static void thousands_of_random_curls_stay_bounded(void** state) {
    (void)state;
    random_ropes_stay_bounded(is_long() ? 50000 : 3000, NULL, 0, 1);
}

/* Too few iterations for a scene that needs many: each step says so, and what it leaves has no more energy than nodes
 * that no spring holds. */
static void steps_that_end_early_are_told_and_bounded(void** state) {
    (void)state;
    for (int hard = 0; hard < HARD; ++hard) {
        static struct scene s;
        for (int way = 0; way < 4; ++way) {
            const int push = way % 2, driven = way / 2;
            build(&s, (enum hard)hard);
            if (driven && s.pin[0] == CD_NODE_FREE) continue;
            if (driven) s.pin[0] = CD_NODE_DRIVEN, s.v[0][0] = 3, s.v[0][1] = -2;
            cd_chain* chain = make(&s, 0.5, CD_FLOAT64);
            ok(cd_chain_set_push(chain, push));
            ok(cd_chain_set_tolerance(chain, 1e-14, 1));
            double bound = 0, kinetic;
            int told = 0;
            ok(cd_chain_get_energy(chain, &kinetic, NULL, NULL));
            bound = sqrt(2 * kinetic);
            double mass = 0;
            for (size_t i = 0; i < s.nodes; ++i) mass += s.mass[i];
            for (int step = 0; step < 50 + 50 * push; ++step) {
                const double dt = step < 50 ? 0.1 : 1; /* where links push, nine iterations may be enough for 0.1 */
                size_t iterations;
                double error, held[2][3];
                ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, held[0], 3));
                const cd_status status = cd_chain_step(chain, dt, 1);
                assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
                ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 1, held[1], 3));
                for (int k = 0; k < 3 && s.pin[0] != CD_NODE_FREE; ++k) /* moves as it is told */
                    assert_near(held[1][k], held[0][k] + dt * s.v[0][k], 1e-12, 0);
                ok(cd_chain_get_convergence(chain, &iterations, &error));
                assert_int_equal(status == CD_OK, error <= 1e-14);
                told += status != CD_OK;
                bound += dt * fabs(s.gravity) * sqrt(mass);
                ok(cd_chain_get_energy(chain, &kinetic, NULL, NULL));
                assert_true(isfinite(kinetic));
                if (hard != WHIP && hard != TOO_LONG && hard != SOFT && hard != MIXED && !driven)
                    assert_true(sqrt(2 * kinetic) <= bound * 1.001);
            }
            assert_true(told > 0);
            cd_chain_destroy(chain);
        }
    }
}

/* A rod on its end, which pushes, and is kicked aside: it falls, and no step gives it energy. */
static void a_rod_that_pushes_falls_with_no_more_energy(void** state) {
    (void)state;
    static const double lambdas[] = {0.5, 0.6, 1}, gravity[] = {0, -9.81}, x[] = {0, 0, 0, 1}, v[] = {0, 0, 1, 0};
    for (size_t l = 0; l < COUNT(lambdas); ++l) {
        cd_chain* chain = NULL;
        ok(cd_chain_create(1, 1, 2, CD_FLOAT64, NULL, &chain));
        ok(cd_chain_set_rest_length(chain, 1));
        ok(cd_chain_set_stiffness(chain, INFINITY));
        ok(cd_chain_set_push(chain, 1));
        ok(cd_chain_set_lambda(chain, lambdas[l]));
        ok(cd_chain_set_tolerance(chain, 1e-12, 200));
        ok(cd_chain_set_gravity(chain, gravity, 2));
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 2, x, 4));
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, 2, v, 4));
        double before = 1e300, least = 0;
        for (int step = 0; step < 60; ++step) {
            double kinetic, potential, tension;
            ok(cd_chain_step(chain, 1.0 / 60, 1));
            ok(cd_chain_get_energy(chain, &kinetic, NULL, &potential));
            ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, 1, &tension, 1));
            assert_true(kinetic + potential <= before + 1e-10);
            before = kinetic + potential;
            least = fmin(least, tension);
        }
        assert_true(least < -1); /* it pushed */
        cd_chain_destroy(chain);
    }
}

/* Two held nodes further apart than the rope between them is long: the step says so and moves the rest. */
static void held_nodes_too_far_apart_are_told(void** state) {
    (void)state;
    static const double x[] = {0, 0, 1, 0, 2.5, 0, 3.5, 0, 4.5, 0}, gravity[] = {0, -9.81}, pins[] = {1, 1};
    cd_chain* chain = NULL;
    double error, end[2];
    size_t iterations;
    ok(cd_chain_create(1, 4, 2, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 4));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_gravity(chain, gravity, 2));
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 5, x, 10));
    ok(cd_chain_write_f64(chain, CD_PIN, 0, 1, 1, 2, pins, 2));
    for (int step = 0; step < 30; ++step) {
        assert_int_equal(cd_chain_step(chain, 1.0 / 60, 1), CD_ERROR_TOLERANCE);
        ok(cd_chain_get_convergence(chain, &iterations, &error));
        assert_true(fabs(error - 0.5) < 1e-12 && iterations <= 16);
    }
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 4, 1, end, 2));
    assert_true(end[1] < -0.5 && fabs(hypot(end[0] - 2.5, end[1]) - 2) < 0.1);
    cd_chain_destroy(chain);
}

/* A rope that hangs far out on a weak attachment, to a tolerance that rounding does not allow: a step ends with the
 * best that any of its methods found, not with the last. */
static void a_step_that_ends_short_keeps_the_best_it_found(void** state) {
    (void)state;
    const double target[3] = {0.01, 1, 2};
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, 102, 3, CD_FLOAT64, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, 0.0733));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    ok(cd_chain_attach(chain, 0, 99, 31.6, 0, target, 3));
    ok(cd_chain_set_tolerance(chain, 1.2e-13, 200));
    double worst = 0;
    int short_of_it = 0;
    for (int step = 0; step < 8; ++step) {
        double error;
        short_of_it += cd_chain_step(chain, 5.005, 1) == CD_ERROR_TOLERANCE;
        ok(cd_chain_get_convergence(chain, NULL, &error));
        worst = fmax(worst, error);
    }
    print_message("%d of 8 steps ended short of 1.2e-13, the worst at %.1e\n", short_of_it, worst);
    assert_true(short_of_it > 0 && worst < 1e-8);
    cd_chain_destroy(chain);
}

/* Far from the origin float32 rounds positions by more than the tolerance: a swing gains what chain.h says. */
static void far_float32_ropes_gain_what_the_header_says(void** state) {
    (void)state;
    static const struct {
        double away, most; /* in lengths of a spring; of the energy */
    } cases[] = {{1e4, 1e-5}, {1e5, 2e-4}, {1e6, 0.2}};
    for (size_t c = 0; c < COUNT(cases); ++c)
        for (int way = 0; way < 8; ++way) {
            enum { SPRINGS = 100 };
            const double gravity[2] = {0, -9.81}, length = 1.0 / SPRINGS;
            double x[SPRINGS + 1][2], e[3], start = 0, highest = 0;
            cd_chain* chain = NULL;
            ok(cd_chain_create(1, SPRINGS, 2, CD_FLOAT32, NULL, &chain));
            for (int i = 0; i <= SPRINGS; ++i)
                x[i][0] = length * (cases[c].away + i), x[i][1] = way / 4 ? length * cases[c].away : 0;
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, SPRINGS + 1, x[0], 2 * (SPRINGS + 1)));
            ok(cd_chain_set_rest_length(chain, 1));
            ok(cd_chain_set_stiffness(chain, way % 2 ? 1000 : INFINITY));
            ok(cd_chain_set_push(chain, way / 2 % 2));
            ok(cd_chain_set_bend(chain, way / 2 % 2 ? 1e-3 : 0));
            ok(cd_chain_set_gravity(chain, gravity, 2));
            ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
            for (int step = 0; step <= 600; ++step) {
                ok(cd_chain_get_energy(chain, &e[0], &e[1], &e[2]));
                if (step == 0) start = e[0] + e[1] + e[2];
                highest = fmax(highest, (e[0] + e[1] + e[2] - start) / (9.81 / 2));
                cd_chain_step(chain, 1 / 60.0, 1);
            }
            if (!(highest <= cases[c].most)) fail_msg("%g lengths away, %d: gained %.2e", cases[c].away, way, highest);
            cd_chain_destroy(chain);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hard_scenes_stay_bounded),
        cmocka_unit_test(steps_that_end_early_are_told_and_bounded),
        cmocka_unit_test(a_rod_that_pushes_falls_with_no_more_energy),
        cmocka_unit_test(held_nodes_too_far_apart_are_told),
        cmocka_unit_test(a_step_that_ends_short_keeps_the_best_it_found),
        cmocka_unit_test(far_float32_ropes_gain_what_the_header_says),
        cmocka_unit_test(thousands_of_random_ropes_stay_bounded),
        cmocka_unit_test(thousands_of_random_curls_stay_bounded),
    };
    return cmocka_run_group_tests_name("ropes", tests, NULL, NULL);
}
