/* Ropes against exact answers: the discrete catenary, pendulums, the modes of a hanging rope and of a taut string. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "reference.h"

#define PI 3.14159265358979323846

static const double gravity[3] = {0, -9.81, 0};

/* A rope of fixed length of `springs` links from the origin along the direction `way`, its first node pinned. */
static cd_chain* rope(size_t springs, double length, double mass, const double* way, cd_precision precision) {
    cd_chain* chain = NULL;
    ok(cd_chain_create(1, springs, 3, precision, NULL, &chain));
    ok(cd_chain_set_rest_length(chain, length));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_set_mass(chain, mass));
    ok(cd_chain_set_gravity(chain, gravity, 3));
    ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
    for (size_t i = 0; i <= springs; ++i) {
        double x[3];
        for (int k = 0; k < 3; ++k) x[k] = way[k] * length * (double)i / (double)springs;
        ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, i, 1, x, 3));
    }
    return chain;
}

static void place(cd_chain* chain, size_t node, double x, double y) {
    const double at[3] = {x, y, 0};
    ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, node, 1, at, 3));
}
static void where(const cd_chain* chain, size_t node, double* x) {
    ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, node, 1, x, 3));
}

/* ---- at rest ----------------------------------------------------------------------------------------------------- */

/* Links of one length between two supports: link i pulls with (h, v_i), v_i = v_0 + i w of the nodes' weight w. Finds h
 * and v_0 such that the links, added up, reach from one to the other, by Newton's method. */
enum { LINKS = 50 };
static void hang(double length, double weight, double dx, double dy, long double* x, long double* y, double* pull) {
    long double h = (long double)weight * LINKS / 4, v0 = -h;
    const long double l = (long double)length / LINKS;
    for (int round = 0; round < 200; ++round) {
        long double sx = 0, sy = 0, xh = 0, xv = 0, yv = 0;
        for (int i = 0; i < LINKS; ++i) {
            const long double v = v0 + i * (long double)weight, t = sqrtl(h * h + v * v);
            sx += l * h / t, sy += l * v / t;
            xh += l * v * v / (t * t * t), xv -= l * h * v / (t * t * t), yv += l * h * h / (t * t * t);
        }
        const long double ex = dx - sx, ey = dy - sy, det = xh * yv - xv * xv;
        long double dh = (ex * yv - ey * xv) / det, dv = (ey * xh - ex * xv) / det, part = 1;
        if (h + dh <= 0) part = -0.5L * h / dh;
        h += part * dh, v0 += part * dv;
    }
    x[0] = y[0] = 0;
    for (int i = 0; i < LINKS; ++i) {
        const long double v = v0 + i * (long double)weight, t = sqrtl(h * h + v * v);
        pull[i] = (double)t;
        x[i + 1] = x[i] + l * h / t, y[i + 1] = y[i] + l * v / t;
    }
}

static void a_rope_between_two_hooks_hangs_as_the_discrete_catenary(void** state) {
    (void)state;
    static const double spans[][3] = {{10, 6, 1}, {10, 9.9, 0.2}, {10, 0.5, -3}};
    for (size_t k = 0; k < COUNT(spans); ++k) {
        const double length = spans[k][0], dx = spans[k][1], dy = spans[k][2], along[3] = {1, 0, 0};
        long double x[LINKS + 1], y[LINKS + 1];
        double pull[LINKS], found[LINKS], worst = 0, worst_pull = 0;
        hang(length, 9.81 / (LINKS + 1), dx, dy, x, y, pull);
        cd_chain* chain = rope(LINKS, length, 1, along, CD_FLOAT64);
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_set_tolerance(chain, 1e-13, 200));
        for (size_t i = 0; i <= LINKS; ++i)
            place(chain, i, dx * (double)i / LINKS, dy * (double)i / LINKS - 0.1 * (i % 2));
        place(chain, LINKS, dx, dy);
        for (int i = 0; i < 400; ++i) {
            const cd_status status = cd_chain_step(chain, i < 100 ? 0.1 : 10, 1);
            assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
        }
        ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, LINKS, found, LINKS));
        for (size_t i = 0; i <= LINKS; ++i) {
            double at[3];
            where(chain, i, at);
            worst = fmax(worst, fmax(fabs(at[0] - (double)x[i]), fabs(at[1] - (double)y[i])));
            if (i < LINKS) worst_pull = fmax(worst_pull, fabs(found[i] / pull[i] - 1));
        }
        print_message("catenary of %g m over %g m by %g m: nodes to %.1e m, tensions to %.1e\n", length, dx, dy, worst,
                      worst_pull);
        assert_true(worst < 1e-12 * length);
        assert_true(worst_pull < 1e-9);
        cd_chain_destroy(chain);
    }
}

/* A rope of springs that yield, hanging: spring i is longer by what hangs below it. */
static void a_soft_rope_hangs_as_long_as_its_springs_make_it(void** state) {
    (void)state;
    static const double stiffness[] = {5, 50, 5000, 1e9, INFINITY};
    for (size_t k = 0; k < COUNT(stiffness); ++k) {
        const double down[3] = {0, -1, 0};
        cd_chain* chain = rope(20, 2, 0.5, down, CD_FLOAT64);
        ok(cd_chain_set_stiffness(chain, stiffness[k]));
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_set_tolerance(chain, 1e-12, 200));
        for (int i = 0; i < 600; ++i) ok(cd_chain_step(chain, 1, 1));
        double y = 0, last = 0;
        for (size_t i = 0; i < 20; ++i) {
            double at[3], tension;
            const double weight = 9.81 * 0.5 / 21 * (double)(20 - i);
            y -= 0.1 + weight / (20 * stiffness[k]);
            where(chain, i + 1, at);
            ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, i, 1, &tension, 1));
            assert_near(at[1], y, 1e-9, 1);
            assert_near(tension, weight, 1e-9, 1);
            last = at[1];
        }
        print_message("rope of 2 m, stiffness %g N/m: hangs %.6f m\n", stiffness[k], -last);
        cd_chain_destroy(chain);
    }
}

/* ---- pendulums --------------------------------------------------------------------------------------------------- */

/* n equal links with equal masses at their ends, as angles from the vertical: sum_j c_ij (a_j'' cos(a_i - a_j) +
 * a_j'^2 sin(a_i - a_j)) l = -c_ii g sin a_i with c_ij = n - max(i, j); by Runge and Kutta's method. */
enum { MOST_LINKS = 10 };
static void swing_rate(size_t n, double l, const double* a, double* rate) {
    double m[MOST_LINKS][MOST_LINKS + 1];
    for (size_t i = 0; i < n; ++i) {
        m[i][n] = -(double)(n - i) * 9.81 * sin(a[i]);
        for (size_t j = 0; j < n; ++j) {
            const double c = (double)(n - (i > j ? i : j));
            m[i][j] = c * l * cos(a[i] - a[j]);
            m[i][n] -= c * l * a[n + j] * a[n + j] * sin(a[i] - a[j]);
        }
    }
    for (size_t i = 0; i < n; ++i)
        for (size_t r = i + 1; r < n; ++r) {
            const double f = m[r][i] / m[i][i];
            for (size_t j = i; j <= n; ++j) m[r][j] -= f * m[i][j];
        }
    for (size_t i = n; i-- > 0;) {
        double sum = m[i][n];
        for (size_t j = i + 1; j < n; ++j) sum -= m[i][j] * rate[n + j];
        rate[n + i] = sum / m[i][i];
        rate[i] = a[n + i];
    }
}
static void swing(size_t n, double l, double* a, double time, int steps) {
    const double h = time / steps;
    for (int s = 0; s < steps; ++s) {
        double k[4][2 * MOST_LINKS], at[2 * MOST_LINKS];
        static const double part[4] = {0, 0.5, 0.5, 1};
        for (int stage = 0; stage < 4; ++stage) {
            for (size_t i = 0; i < 2 * n; ++i) at[i] = a[i] + (stage ? h * part[stage] * k[stage - 1][i] : 0);
            swing_rate(n, l, at, k[stage]);
        }
        for (size_t i = 0; i < 2 * n; ++i) a[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
    }
}

/* How far the end of a pendulum of n links, let go level, is from where it should be after a second. */
static double missed_after_a_second(size_t n, double lambda, int steps) {
    const double level[3] = {1, 0, 0};
    double a[2 * MOST_LINKS], at[3], x = 0, y = 0;
    for (size_t i = 0; i < 2 * n; ++i) a[i] = i < n ? PI / 2 : 0;
    swing(n, 10.0 / (double)n, a, 1, 20000);
    for (size_t i = 0; i < n; ++i) x += 10 * sin(a[i]) / (double)n, y -= 10 * cos(a[i]) / (double)n;
    cd_chain* chain = rope(n, 10, 1, level, CD_FLOAT64);
    ok(cd_chain_set_lambda(chain, lambda));
    ok(cd_chain_set_push(chain, 1));
    ok(cd_chain_set_tolerance(chain, 1e-10, 200));
    ok(cd_chain_step(chain, 1.0 / steps, (size_t)steps));
    where(chain, n, at);
    cd_chain_destroy(chain);
    return hypot(at[0] - x, at[1] - y);
}

static void pendulums_of_links_swing_to_second_order(void** state) {
    (void)state;
    static const struct {
        size_t links;
        double missed; /* at 60 Hz [m] */
    } cases[] = {{1, 1.1e-4}, {2, 2.2e-4}, {3, 2.4e-4}, {10, 4.5e-4}};
    for (size_t k = 0; k < COUNT(cases); ++k) {
        double e[4];
        for (int r = 0; r < 4; ++r) e[r] = missed_after_a_second(cases[k].links, 0.5, 60 << r);
        print_message("pendulum of %zu links, lambda 1/2, 60 to 480 Hz: end missed by %.1e, %.1e, %.1e, %.1e m\n",
                      cases[k].links, e[0], e[1], e[2], e[3]);
        assert_true(e[0] < cases[k].missed);
        for (int r = 0; r < 3; ++r) assert_true(e[r + 1] < 0.27 * e[r]);
    }
    print_message("10 links, lambda 0.55 and 1, 60 Hz: %.1e, %.1e m\n", missed_after_a_second(10, 0.55, 60),
                  missed_after_a_second(10, 1, 60));
}

/* ---- modes ------------------------------------------------------------------------------------------------------- */

/* Time of the k-th passage of a node through x = 0, between the steps around it. */
static double passage(cd_chain* chain, size_t node, double dt, int k) {
    double before[3], after[3];
    where(chain, node, before);
    for (int step = 0;; ++step) {
        ok(cd_chain_step(chain, dt, 1));
        where(chain, node, after);
        if (before[0] * after[0] <= 0 && --k == 0) return dt * (step + before[0] / (before[0] - after[0]));
        memcpy(before, after, sizeof before);
    }
}

/* The lowest mode of a hanging rope is J_0(2.40483 sqrt(s / length)), s from its free end, at 1.20241 sqrt(g / length). */
static void a_hanging_rope_swings_in_its_lowest_mode(void** state) {
    (void)state;
    static const struct {
        size_t springs;
        double missed;
    } cases[] = {{10, 3e-3}, {50, 1.3e-4}, {200, 1e-5}};
    for (size_t k = 0; k < COUNT(cases); ++k) {
        const size_t n = cases[k].springs;
        const double down[3] = {0, -1, 0}, l = 10.0 / (double)n, exact = 1.2024127788478854 * sqrt(0.981),
                     dt = 1.0 / 480;
        cd_chain* chain = rope(n, 10, 1, down, CD_FLOAT64);
        ok(cd_chain_set_mass_rule(chain, CD_MASS_HALF_ENDS));
        ok(cd_chain_set_tolerance(chain, 1e-12, 200));
        double x = 0, y = 0;
        for (size_t i = 0; i < n; ++i) {
            const double to = 1e-4 * j0(2.404825557695773 * sqrt(1 - (double)(i + 1) / (double)n));
            y -= sqrt(l * l - (to - x) * (to - x));
            x = to;
            place(chain, i + 1, x, y);
        }
        const double found = 9.5 * PI / passage(chain, n, dt, 10);
        const double shifted = 2 / dt * atan(exact * dt / 2), off = found / shifted - 1;
        print_message("hanging rope of %zu links, lowest mode: %.2e of its frequency\n", n, off);
        assert_true(fabs(off) < cases[k].missed);
        cd_chain_destroy(chain);
    }
}

/* A string of springs under a tension swings as its lattice does, omega^2 = 4 T / (l m) sin^2(k pi / 2 n), at
 * (2 / dt) atan(omega dt / 2). */
static void a_taut_string_swings_as_its_lattice(void** state) {
    (void)state;
    enum { SPRINGS = 100 };
    static const int modes[] = {1, 5, 20};
    const double tension = 100, stiffness = 1e5, along[3] = {1, 0, 0}, dt = 1.0 / 240, size = 1e-6;
    for (size_t k = 0; k < COUNT(modes); ++k) {
        cd_chain* chain = rope(SPRINGS, 10, 1, along, CD_FLOAT64);
        ok(cd_chain_set_gravity(chain, (double[3]){0, 0, 0}, 3));
        ok(cd_chain_set_stiffness(chain, stiffness));
        ok(cd_chain_set_rest_length(chain, 10 - tension / stiffness));
        ok(cd_chain_set_end(chain, CD_END_LAST, CD_NODE_PINNED));
        ok(cd_chain_set_tolerance(chain, 1e-14, 200));
        double pull[SPRINGS];
        for (size_t i = 0; i < SPRINGS; ++i) pull[i] = tension;
        ok(cd_chain_write_f64(chain, CD_TENSION, 0, 1, 0, SPRINGS, pull, SPRINGS));
        for (size_t i = 0; i < SPRINGS; ++i)
            place(chain, i, 0.1 * (double)i, size * sin(modes[k] * PI * (double)i / SPRINGS));
        double a[3] = {0, 0, 0}, sum = 0, weight = 0;
        for (int step = 0; step < 400; ++step) {
            a[0] = a[1], a[1] = a[2], a[2] = 0;
            for (size_t i = 0; i < SPRINGS; ++i) {
                double at[3];
                where(chain, i, at);
                a[2] += at[1] / size * sin(modes[k] * PI * (double)i / SPRINGS) * 2 / SPRINGS;
            }
            if (step >= 2) sum += (a[2] + a[0]) * a[1] / 2, weight += a[1] * a[1];
            const cd_status status = cd_chain_step(chain, dt, 1);
            assert_true(status == CD_OK || status == CD_ERROR_TOLERANCE);
        }
        const double half = sin(modes[k] * PI / 2 / SPRINGS), omega = sqrt(4 * tension / 0.1 * 101) * half;
        const double exact = 2 / dt * atan(omega * dt / 2), found = acos(sum / weight) / dt;
        print_message("taut string, mode %d: %.1e of its frequency\n", modes[k], found / exact - 1);
        assert_true(fabs(found / exact - 1) < 1e-6);
        cd_chain_destroy(chain);
    }
}

/* ---- what is kept ------------------------------------------------------------------------------------------------ */

/* A free rope that spins and wriggles keeps its momentum; with lambda = 1/2 and short steps its angular momentum. */
static void momenta(const cd_chain* chain, size_t nodes, double mass, double* out) {
    for (int k = 0; k < 6; ++k) out[k] = 0;
    for (size_t i = 0; i < nodes; ++i) {
        double x[3], v[3];
        where(chain, i, x);
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, i, 1, v, 3));
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            out[k] += mass * v[k];
            out[3 + k] += mass * (x[l] * v[m] - x[m] * v[l]);
        }
    }
}
static void a_free_rope_keeps_its_momentum(void** state) {
    (void)state;
    for (int damped = 0; damped < 2; ++damped) {
        const double along[3] = {1, 0, 0};
        double before[6], after[6], worst = 0, turned = 0;
        uint64_t seed = 5;
        cd_chain* chain = rope(64, 10, 65, along, CD_FLOAT64);
        ok(cd_chain_set_gravity(chain, (double[3]){0, 0, 0}, 3));
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_FREE));
        ok(cd_chain_set_lambda(chain, damped ? 1 : 0.5));
        ok(cd_chain_set_tolerance(chain, 1e-10, 200));
        for (size_t i = 0; i <= 64; ++i) {
            const double v[3] = {1 + 0.1 * random_number(&seed), (double)i / 16 - 3, 0.1 * random_number(&seed)};
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, v, 3));
        }
        momenta(chain, 65, 1, before);
        ok(cd_chain_step(chain, 1.0 / 600, 3000));
        momenta(chain, 65, 1, after);
        for (int k = 0; k < 3; ++k) {
            worst = fmax(worst, fabs(after[k] - before[k]));
            turned = fmax(turned, fabs(after[3 + k] - before[3 + k]) / 1000);
        }
        print_message("free rope, lambda %g, 5 s: momentum to %.1e, angular momentum to %.1e\n", damped ? 1 : 0.5,
                      worst, turned);
        assert_true(worst < 1e-10);
        if (!damped) assert_true(turned < 1e-6);
        cd_chain_destroy(chain);
    }
}

/* What a step of lambda = 1 did to each node is what the tensions that it tells do, whatever way it was solved: of ropes
 * of very different masses that are thrown apart, to 1% of the mean force that would stop a node within the step. */
static void tensions_are_what_the_step_did(void** state) {
    (void)state;
    enum { NODES = 41 };
    const double along[3] = {1, 0, 0}, none[3] = {0, 0, 0}, dt = 1.0 / 60;
    double worst = 0;
    size_t most = 0;
    uint64_t seed = 17 + other_scenes();
    for (int scene = 0; scene < 60; ++scene) {
        double mass[NODES], v[NODES][3], after[NODES][3], stops = 0;
        cd_chain* chain = rope(NODES - 1, 1, 1, along, CD_FLOAT64);
        ok(cd_chain_set_lambda(chain, 1));
        ok(cd_chain_set_gravity(chain, none, 3));
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_FREE));
        ok(cd_chain_enable_field(chain, CD_MASS));
        for (int i = 0; i < NODES; ++i) mass[i] = pow(10, 2 * random_number(&seed));
        for (int i = 0; i < NODES; ++i)
            for (int k = 0; k < 3; ++k) v[i][k] = random_number(&seed);
        for (int i = 0; i < NODES; ++i)
            stops += mass[i] * sqrt(v[i][0] * v[i][0] + v[i][1] * v[i][1] + v[i][2] * v[i][2]);
        ok(cd_chain_write_f64(chain, CD_MASS, 0, 1, 0, NODES, mass, NODES));
        ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, v[0], 3 * NODES));
        size_t iterations;
        ok(cd_chain_step(chain, dt, 1));
        ok(cd_chain_get_convergence(chain, &iterations, NULL));
        ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, NODES, after[0], 3 * NODES));
        for (int i = 0; i < NODES; ++i) {
            double force[3];
            ok(cd_chain_get_reaction(chain, 0, (size_t)i, force, 3));
            for (int k = 0; k < 3; ++k)
                worst = fmax(worst, fabs(force[k] - mass[i] * (after[i][k] - v[i][k]) / dt) / (stops / NODES / dt));
        }
        most = iterations > most ? iterations : most;
        cd_chain_destroy(chain);
    }
    print_message("tensions: what the step did to %.1e of the mean force; up to %zu iterations\n", worst, most);
    assert_true(most > 8); /* by the interior point too */
    assert_true(worst < 0.01);
}

/* A step of lambda = 1/2 is as easy to solve where springs yield, however small the tolerance is, so that hardly any is
 * made with lambda = 1 instead: swings from an angle, stretched by their weight, end where looser ones end, and ropes
 * that spin, and grow longer and shorter as they do, keep their angular momentum. */
static void soft_ropes_move_alike_at_any_tolerance(void** state) {
    (void)state;
    enum { SPRINGS = 5, STEPS = 60 };
    static const double stiffnesses[] = {50, 1000, 20000}, tolerances[] = {1e-10, 1e-6, 1e-4}, angle = 0.7;
    for (size_t k = 0; k < 6; ++k) {
        const int spins = k >= 3;
        double end[3][3], worst[3] = {0};
        for (int t = 0; t < 3; ++t) {
            const double way[3] = {sin(angle), -cos(angle), 0}, stiffness = stiffnesses[k % 3];
            double before[6], after[6], far = 0;
            size_t most = 0, iterations;
            cd_chain* chain = rope(SPRINGS, 1, 1, way, CD_FLOAT64);
            ok(cd_chain_set_stiffness(chain, stiffness));
            ok(cd_chain_set_tolerance(chain, tolerances[t], 200));
            for (size_t i = 1; i <= SPRINGS && !spins; ++i) {
                far += (1 + 9.81 * cos(angle) / (SPRINGS + 1) * (double)(SPRINGS + 1 - i) / stiffness) / SPRINGS;
                place(chain, i, far * way[0], far * way[1]);
            }
            if (spins) {
                ok(cd_chain_set_gravity(chain, (double[3]){0, 0, 0}, 3));
                ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_FREE));
            }
            for (size_t i = 0; i <= SPRINGS && spins; ++i) {
                const double v = 2 * ((double)i - SPRINGS / 2.0) / SPRINGS, across[3] = {-v * way[1], v * way[0], 0};
                ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, 1, i, 1, across, 3));
            }
            momenta(chain, SPRINGS + 1, 1.0 / (SPRINGS + 1), before);
            for (int step = 0; step < (spins ? 5 : 1) * STEPS; ++step) {
                ok(cd_chain_step(chain, 1.0 / STEPS, 1));
                ok(cd_chain_get_convergence(chain, &iterations, NULL));
                if (step > 0 && iterations > most) most = iterations;
            }
            momenta(chain, SPRINGS + 1, 1.0 / (SPRINGS + 1), after);
            where(chain, SPRINGS, end[t]);
            for (int i = 0; i < 3; ++i) worst[t] = fmax(worst[t], fabs(end[t][i] - end[0][i]));
            if (spins) worst[t] = fabs(after[5] / before[5] - 1);
            print_message("stiffness %g, tolerance %g: %s by %.1e, %d iterations at most\n", stiffness, tolerances[t],
                          spins ? "spin off" : "elsewhere", worst[t], (int)most);
            assert_true(worst[t] < (spins ? fmax(1e-9, tolerances[t]) : 10 * tolerances[t]));
            assert_true(most <= 8);
            cd_chain_destroy(chain);
        }
    }
}

/* ---- winches ----------------------------------------------------------------------------------------------------- */

/* Straight ropes of any number of springs that are let go, level or hanging, at rest and at their length: whether a
 * spring is taut is a matter of rounding, and no step may need more than Newton's method for it. A level one falls at
 * first as if nothing held it. */
static void straight_ropes_begin_to_second_order(void** state) {
    (void)state;
    const double ways[][3] = {{1, 0, 0}, {0, -1, 0}, {0.6, -0.8, 0}, {0.8, 0.6, 0}}, dt = 1 / 60.0;
    for (size_t way = 0; way < COUNT(ways); ++way)
        for (size_t springs = 2; springs < 130; ++springs) {
            cd_chain* chain = rope(springs, 1, 1, ways[way], CD_FLOAT64);
            double x[3];
            for (int step = 0; step < (ways[way][1] > 0 ? 1 : 6); ++step) { /* what stands falls into slack */
                size_t iterations;
                ok(cd_chain_step(chain, dt, 1));
                ok(cd_chain_get_convergence(chain, &iterations, NULL));
                if (iterations > 8) fail_msg("way %zu, %zu springs: %zu iterations", way, springs, iterations);
                where(chain, springs, x);
                if (way == 0 && step == 0) assert_near(x[1], gravity[1] * dt * dt / 2, 1e-6, 0);
            }
            cd_chain_destroy(chain);
        }
}

/* A hanging rope that is reeled in, or paid out, at an even speed carries its weight, as one at rest does. */
static void a_winch_at_an_even_speed_carries_the_weight(void** state) {
    (void)state;
    static const double down[3] = {0, -1, 0}, speeds[] = {0, -0.1, 0.1, -1, 0};
    static const double lambdas[] = {0.5, 0.55, 1}, stiffnesses[] = {INFINITY, 1e4};
    enum { SPRINGS = 10 };
    const double dt = 1 / 60.0, mass = 2;
    for (size_t l = 0; l < COUNT(lambdas); ++l)
        for (size_t k = 0; k < COUNT(stiffnesses); ++k) {
            double length = 5, worst = 0;
            cd_chain* chain = rope(SPRINGS, length, mass, down, CD_FLOAT64);
            ok(cd_chain_set_lambda(chain, lambdas[l]));
            ok(cd_chain_set_stiffness(chain, stiffnesses[k]));
            ok(cd_chain_set_drag(chain, isinf(stiffnesses[k]) ? 0 : 5)); /* a soft one bounces when speeds change */
            ok(cd_chain_set_tolerance(chain, 1e-10, 200));
            for (size_t phase = 0; phase < COUNT(speeds); ++phase)
                for (int frame = 0; frame < 180; ++frame) {
                    double tension[SPRINGS], v[SPRINGS + 1][3];
                    length += dt * speeds[phase];
                    ok(cd_chain_set_rest_length(chain, length));
                    ok(cd_chain_step(chain, dt, 1));
                    if (frame < 120) continue;
                    ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, SPRINGS, tension, SPRINGS));
                    ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, 1, 0, SPRINGS + 1, v[0], 3 * (SPRINGS + 1)));
                    for (int i = 0; i < SPRINGS; ++i) {
                        double weight = 0; /* and what the drag takes */
                        for (int below = i + 1; below <= SPRINGS; ++below)
                            weight += mass / (SPRINGS + 1) * (9.81 + (isinf(stiffnesses[k]) ? 0 : 5) * v[below][1]);
                        worst = fmax(worst, fabs(tension[i] / weight - 1));
                    }
                }
            print_message("lambda %.2f, stiffness %g: tension of a winch off by %.1e\n", lambdas[l], stiffnesses[k],
                          worst);
            assert_true(worst < 1e-3);
            cd_chain_destroy(chain);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rope_between_two_hooks_hangs_as_the_discrete_catenary),
        cmocka_unit_test(a_soft_rope_hangs_as_long_as_its_springs_make_it),
        cmocka_unit_test(pendulums_of_links_swing_to_second_order),
        cmocka_unit_test(a_hanging_rope_swings_in_its_lowest_mode),
        cmocka_unit_test(a_taut_string_swings_as_its_lattice),
        cmocka_unit_test(a_free_rope_keeps_its_momentum),
        cmocka_unit_test(tensions_are_what_the_step_did),
        cmocka_unit_test(soft_ropes_move_alike_at_any_tolerance),
        cmocka_unit_test(straight_ropes_begin_to_second_order),
        cmocka_unit_test(a_winch_at_an_even_speed_carries_the_weight),
    };
    return cmocka_run_group_tests_name("rope", tests, NULL, NULL);
}
