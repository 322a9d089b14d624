/* What is at the sides: open water that waves leave into, tides, streams, and the opposite side. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"
#include "reference.h"

static const double gravity = 9.81;

/* ---- echoes ------------------------------------------------------------------------------------------------------ */

/* The largest height of what comes back of a hump of height 1 that runs into a side of water 2 m deep. */
static double echo(const struct way* way, cd_side side, cd_border kind, size_t n) {
    const int along_y = side >= CD_SIDE_Y_FIRST, last = side % 2;
    const double deep = 2, dx = 10.0 / (double)n, height = 1e-4, c = sqrt(gravity * deep), width = 0.5;
    double* values = calloc(n + 1, sizeof *values);
    assert_non_null(values);
    cd_water* w = line_basin(along_y, n, 2, dx, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_side(w, side, kind, kind == CD_BORDER_OPEN ? deep : 0, 0));
    for (size_t i = 0; i < n; ++i) values[i] = deep + height * exp(-pow((((double)i + 0.5) * dx - 5) / width, 2) / 2);
    line_write(w, along_y, CD_DEPTH, values);
    for (size_t i = 0; i <= n; ++i)
        values[i] = (last ? 1 : -1) * c / deep * height * exp(-pow(((double)i * dx - 5) / width, 2) / 2);
    values[0] = values[n] = 0;
    line_write(w, along_y, CD_VELOCITY_X, values);
    const size_t steps = 2 * n; /* half a cell each */
    for (size_t k = 0; k < steps; ++k) basin_step(w, 0.5 * dx / c, 1);
    line_read(w, along_y, CD_DEPTH, 1e-9 * height, values);
    double largest = 0;
    for (size_t i = 0; i < n; ++i) largest = fmax(largest, fabs(values[i] - deep) / height);
    free(values);
    cd_water_destroy(w);
    return largest;
}

/* A simple wave, a tenth of the depth high, runs out through an open side: u = 2 (sqrt(g d) - sqrt(g D)). */
static void a_high_simple_wave_leaves_too(void** state) {
    (void)state;
    enum { CELLS = 400 };
    static const int which[] = {ADVECTED, EXPLICIT_ADVECTED};
    static const double courants[] = {0.4, 0.8};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (size_t c = 0; c < COUNT(courants); ++c)
            for (int end = 0; end < 4; ++end) {
                const int along_y = end / 2, last = end % 2;
                const double height = 0.1, speed = sqrt(gravity), dt = courants[c] / speed;
                double d[CELLS], u[CELLS + 1], most = 0;
                cd_water* w = line_basin(along_y, CELLS, 1, 1, CD_FLOAT64);
                basin_set_way(w, &ways[which[k]]);
                ok(cd_water_set_side(w, line_side(along_y, last), CD_BORDER_OPEN, 1, 0));
                for (size_t i = 0; i <= CELLS; ++i) {
                    const double here = height * exp(-pow(((double)i - 200) / 30, 2));
                    u[i] = (last ? 2 : -2) * (sqrt(gravity * (1 + here)) - speed);
                    if (i < CELLS) d[i] = 1 + height * exp(-pow(((double)i + 0.5 - 200) / 30, 2));
                }
                u[0] = u[CELLS] = 0;
                line_write(w, along_y, CD_DEPTH, d);
                line_write(w, along_y, CD_VELOCITY_X, u);
                basin_step(w, dt, (size_t)(330 / courants[c]));
                line_read(w, along_y, CD_DEPTH, 0, d);
                for (size_t i = 0; i < CELLS; ++i) most = fmax(most, fabs(d[i] - 1) / height);
                print_message("%-17s side %d: %.1e of a wave of a tenth of the depth comes back\n", ways[which[k]].name,
                              end, most);
                assert_true(most <= 0.01);
                cd_water_destroy(w);
            }
}

static void a_wave_leaves_through_an_open_side(void** state) {
    (void)state;
    static const int which[] = {LINEAR, LINEAR_HALF, ADVECTED, EXPLICIT, EXPLICIT_ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            double before = INFINITY;
            if (side > CD_SIDE_X_FIRST && k % 2) continue;
            for (size_t n = 100; n <= 400; n *= 2) {
                const double open = echo(&ways[which[k]], side, CD_BORDER_OPEN, n);
                const double wall = echo(&ways[which[k]], side, CD_BORDER_WALL, n);
                if (side == CD_SIDE_X_FIRST)
                    print_message("%-17s %zu cells: %.1e comes back of an open side, %.2f of a wall\n",
                                  ways[which[k]].name, n, open, wall);
                assert_true(wall > 0.7);
                assert_true(open <
                            (ways[which[k]].lambda > 0.5 || basin_is_explicit(&ways[which[k]]) ? 0.6 : 0.3) * before);
                before = open;
            }
            assert_true(before < (basin_is_explicit(&ways[which[k]]) ? 5e-3
                                  : ways[which[k]].lambda > 0.5      ? 5e-4
                                                                     : 2e-4));
        }
}

/* ---- tides ------------------------------------------------------------------------------------------------------- */

/* An outside level of a sin(w t) sends in waves of half its height; what the wall at the end sends back leaves again:
 * a cos(w (L - x) / c) sin(w (t - L / c)). */
static double tide(const struct way* way, cd_side side, size_t n, int with_rate) {
    const int along_y = side >= CD_SIDE_Y_FIRST, last = side % 2;
    const double deep = 10, length = 1000, dx = length / (double)n, c = sqrt(gravity * deep), height = 1e-4;
    const double w = 0.6 * c / length, dt = dx / c;
    const size_t steps = (size_t)lround(12 * 2 * (double)PI / w / dt);
    double* values = calloc(n, sizeof *values);
    assert_non_null(values);
    cd_water* water = line_basin(along_y, n, 1, dx, CD_FLOAT64);
    basin_set_way(water, way);
    for (size_t i = 0; i < n; ++i) values[i] = deep;
    line_write(water, along_y, CD_DEPTH, values);
    for (size_t k = 0; k < steps; ++k) {
        const double t = (double)k * dt, now = height * sin(w * t), then = height * sin(w * (t + dt));
        ok(cd_water_set_side(water, side, CD_BORDER_OPEN, deep + now, with_rate ? (then - now) / dt : 0));
        basin_step(water, dt, 1);
    }
    line_read(water, along_y, CD_DEPTH, 0, values);
    double off = 0;
    const double t = (double)steps * dt;
    for (size_t i = 0; i < n; ++i) {
        const double x = ((double)i + 0.5) * dx, from_wall = last ? x : length - x;
        const double exact = cos(w * from_wall / c) * sin(w * (t - length / c));
        off = fmax(off, fabs((values[i] - deep) / height - exact));
    }
    assert_true(basin_volume_off(water) <= 1e-13);
    free(values);
    cd_water_destroy(water);
    return off;
}

static void a_tide_runs_into_a_basin_and_out_again(void** state) {
    (void)state;
    static const int which[] = {LINEAR_HALF, ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            double before = INFINITY;
            for (size_t n = 25; n <= 100; n *= 2) {
                const double off = tide(&ways[which[k]], side, n, 1);
                if (side == CD_SIDE_X_FIRST)
                    print_message("%-17s %zu cells: tide off by %.1e of its height (without a rate: %.1e)\n",
                                  ways[which[k]].name, n, off, tide(&ways[which[k]], side, n, 0));
                assert_true(off < 0.5 * before);
                before = off;
            }
            assert_true(before < 2e-5);
        }
}

/* A basin of beaches fills up to the level outside, and stays; it drains off a side that lies below its bed. */
static void a_basin_fills_to_the_level_outside_and_drains(void** state) {
    (void)state;
    enum { N = 12 };
    for (size_t k = 0; k < WAYS; ++k) {
        cd_water* w = basin(N, N, 1, 1, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        basin_random_bed(w, 0.8, 4, 3);
        ok(cd_water_set_drag(w, 0.2));
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_OPEN, 1, 0));
        const double dt = basin_is_explicit(&ways[k]) ? 0.1 : 0.25;
        for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1);
        assert_near(basin_least(w, CD_SURFACE), 1, 1e-6, 0);
        assert_near(-basin_least(w, CD_SURFACE), -1, 1e-6, 0);
        assert_true(basin_largest(w, CD_VELOCITY_X) < 1e-6);
        const double full = basin_volume(w);
        ok(cd_water_set_side(w, CD_SIDE_Y_LAST, CD_BORDER_OPEN, -3, 0));
        double fastest = 0;
        for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1), fastest = fmax(fastest, basin_largest(w, CD_VELOCITY_Y));
        assert_true(fastest < 20);                 /* films at the side, too */
        assert_true(basin_volume(w) < 0.5 * full); /* pools stay in the hollows */
        assert_true(basin_least(w, CD_DEPTH) >= 0);
        assert_true(basin_volume_off(w) <= 1e-12);
        cd_water_destroy(w);
    }
}

/* ---- streams ----------------------------------------------------------------------------------------------------- */

/* What comes in by a discharge and its rate is known to rounding, and so is what leaves by a negative one. */
static void discharges_bring_in_what_they_say(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            double in, out, q;
            cd_border kind;
            const double dt = 0.01, first = 0.3, rate = 0.05;
            cd_water* w = basin(8, 6, 0.5, 0.25, CD_FLOAT64);
            const double length = side < CD_SIDE_Y_FIRST ? 6 * 0.25 : 8 * 0.5, start = 1;
            basin_set_way(w, &ways[k]);
            for (size_t c = 0; c < 48; ++c) basin_set(w, CD_DEPTH, c % 8, c / 8, start);
            ok(cd_water_set_side(w, side, CD_BORDER_INFLOW, first, rate));
            for (int s = 0; s < 100; ++s) basin_step(w, dt, 1);
            ok(cd_water_get_account(w, NULL, &in, &out, NULL));
            /* taken at lambda of each step */
            const double expected = (first * 1 + rate * (0.5 + (ways[k].lambda - 0.5) * dt)) * length;
            assert_near(in, expected, 1e-12, 0);
            assert_true(out == 0);
            ok(cd_water_get_side(w, side, &kind, &q, NULL));
            assert_int_equal(kind, CD_BORDER_INFLOW);
            assert_near(q, first + rate, 1e-12, 0);
            ok(cd_water_set_side(w, side, CD_BORDER_INFLOW, -first, 0));
            for (int s = 0; s < 50; ++s) basin_step(w, dt, 1);
            ok(cd_water_get_account(w, NULL, NULL, &out, NULL));
            assert_near(out, first * 0.5 * length, 1e-12, 0);
            for (int s = 0; s < 4000; ++s) basin_step(w, dt, 1); /* it runs dry there, and no further */
            assert_true(basin_least(w, CD_DEPTH) >= 0);
            assert_true(basin_volume_off(w) <= 1e-12);
            cd_water_destroy(w);
        }
}

/* ---- streams that come in at one side and leave at the other ------------------------------------------------------ */

/* The level outside at which a stream of depth d leaves as deep as it is: see cd_water_set_side. */
static double level_for(const struct way* way, double speed, double d) {
    const double c = sqrt(gravity * d);
    return way->momentum ? pow(c - speed / 2, 2) / gravity : d * (1 - speed / c);
}

static void a_stream_goes_through_as_it_comes_in(void** state) {
    (void)state;
    enum { N = 20 };
    static const double courants[] = {0.3, 2, 8}, speeds[] = {0.5, 2.2};
    const double deep = 2;
    for (size_t k = 0; k < WAYS; ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            if (basin_is_explicit(&ways[k]) && c > 0) continue;
            double worst = 0;
            for (int end = 0; end < 8; ++end) {
                const int along_y = end / 2 % 2, last = end % 2, held = end >= 4;
                const double dt = courants[c] / sqrt(gravity * deep);
                const double speed = speeds[end % 2], q = speed * deep, level = level_for(&ways[k], speed, deep);
                double values[N + 1];
                cd_water* w = line_basin(along_y, N, 3, 1, CD_FLOAT64);
                basin_set_way(w, &ways[k]);
                ok(cd_water_set_side(w, line_side(along_y, last), CD_BORDER_INFLOW, q, 0));
                /* a held level is that of the stream; advected, as its u is carried */
                if (held) ok(cd_water_set_side(w, line_side(along_y, !last), CD_BORDER_LEVEL, deep, 0));
                else ok(cd_water_set_side(w, line_side(along_y, !last), CD_BORDER_OPEN, level, 0));
                for (size_t i = 0; i < N; ++i) values[i] = deep;
                line_write(w, along_y, CD_DEPTH, values);
                for (size_t i = 0; i <= N; ++i) values[i] = last ? -speed : speed;
                line_write(w, along_y, CD_VELOCITY_X, values);
                basin_step(w, dt, 1000);
                line_read(w, along_y, CD_DEPTH, 1e-9, values);
                for (size_t i = 0; i < N; ++i) worst = fmax(worst, fabs(values[i] - deep));
                cd_water_destroy(w);
            }
            print_message("%-17s courant %3g: a stream that goes through is off by %.1e m\n", ways[k].name, courants[c],
                          worst);
            assert_true(worst <= 1e-12);
        }
}

/* ---- steady flow over a bump ------------------------------------------------------------------------------------- */

/* Depth of a discharge q with the head (over the bed) H = h + q^2 / (2 g h^2): the slow one or the fast one. */
static double depth_of(double q, double head, int fast) {
    const double critical = pow(q * q / gravity, 1.0 / 3);
    double low = fast ? 1e-6 : critical, high = fast ? critical : head;
    for (int k = 0; k < 100; ++k) {
        const double h = (low + high) / 2;
        if ((h + q * q / (2 * gravity * h * h) < head) != fast) low = h;
        else high = h;
    }
    return (low + high) / 2;
}

enum flow { SLOW, TURNS_FAST, JUMPS_BACK };
static double bump(double x) { return fmax(0, 0.2 - 0.05 * (x - 10) * (x - 10)); }
static double momentum_of(double q, double h) { return q * q / h + gravity * h * h / 2; }

/* By Bernoulli along the stream and, at the jump, by the momentum (Goutal and Maurel 1997). */
static double depth_over_bump(enum flow flow, double x, double q, double below) {
    const double critical_head = 1.5 * pow(q * q / gravity, 1.0 / 3);
    const double head_below = below + q * q / (2 * gravity * below * below);
    const double slow = depth_of(q, (flow == SLOW ? head_below : critical_head + bump(10)) - bump(x), 0);
    if (flow == SLOW || x < 10) return slow;
    const double fast = depth_of(q, critical_head + bump(10) - bump(x), 1);
    if (flow == TURNS_FAST) return fast;
    if (x >= 12) return below;
    const double behind = depth_of(q, fmax(head_below - bump(x), critical_head), 0);
    return momentum_of(q, fast) > momentum_of(q, behind) ? fast : behind;
}

/* The mean error of depths over the depth below, once the stream is steady. */
static double bump_error(const struct way* way, enum flow flow, size_t n, double courant) {
    static const double discharges[] = {4.42, 1.53, 0.18}, depths[] = {2, 0.66, 0.33};
    const double q = discharges[flow], below = depths[flow], dx = 25.0 / (double)n;
    const double dt = courant * dx / sqrt(gravity * below), seconds = flow == SLOW ? 400 : 250;
    double *values = calloc(n, sizeof *values), error = 0;
    assert_non_null(values);
    cd_water* w = line_basin(0, n, 1, dx, CD_FLOAT64);
    basin_set_way(w, way);
    for (size_t i = 0; i < n; ++i) values[i] = bump(((double)i + 0.5) * dx);
    line_write(w, 0, CD_BED, values);
    for (size_t i = 0; i < n; ++i) values[i] = below - values[i];
    line_write(w, 0, CD_DEPTH, values);
    ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, q, 0));
    ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, flow == TURNS_FAST ? -1 : level_for(way, q / below, below),
                         0));
    basin_step(w, dt, (size_t)(seconds / dt));
    line_read(w, 0, CD_DEPTH, 0, values);
    /* what falls off a side slowly at first may stay so: a jump stands at the very end */
    const size_t counts = flow == TURNS_FAST ? 4 * n / 5 : n;
    for (size_t i = 0; i < counts; ++i)
        error += fabs(values[i] - depth_over_bump(flow, ((double)i + 0.5) * dx, q, below)) / (double)counts / below;
    free(values);
    cd_water_destroy(w);
    return error;
}

/* Of second order, and the same whatever the step. */
static void a_stream_over_a_bump_keeps_its_head(void** state) {
    (void)state;
    static const char* const names[] = {"slow", "turns fast", "jumps back"};
    static const struct {
        int way;
        double courant, most[3]; /* with 100 cells */
    } rows[] = {{ADVECTED, 0.4, {2.5e-4, 2.7e-3, 1.3e-2}},
                {ADVECTED, 2, {2.5e-4, 2.7e-3, 1.3e-2}},
                {ADVECTED, 8, {2.5e-4, 2.7e-3, 1.3e-2}},
                {EXPLICIT_ADVECTED, 0.3, {2.5e-4, 2.7e-3, 1.3e-2}}};
    for (size_t r = 0; r < COUNT(rows); ++r)
        for (enum flow flow = SLOW; flow <= JUMPS_BACK; ++flow) {
            double before = INFINITY;
            for (size_t n = 100; n <= 200; n *= 2) {
                const double error = bump_error(&ways[rows[r].way], flow, n, rows[r].courant);
                print_message("%-17s courant %.1f, %-10s, %zu cells: off by %.2e of the depth\n",
                              ways[rows[r].way].name, rows[r].courant, names[flow], n, error);
                assert_true(error <= rows[r].most[flow] && error <= 0.4 * before);
                before = error;
            }
        }
}

/* So does one that slows down where the bed falls from 1 to 4 m, in steps in which waves cross 0.2 to 2.5 cells: what it
 * comes in with pays for what it rises by. */
static void a_stream_that_slows_down_keeps_its_head(void** state) {
    (void)state;
    enum { N = 100 };
    static const double dts[] = {0.05, 0.2, 0.4}, discharge = 1.25;
    for (size_t k = 0; k < COUNT(dts); ++k)
        for (int turned = 0; turned < 4; ++turned) {
            const int along_y = turned % 2, back = turned / 2;
            double bed[N], d[N], deep[2] = {0.8, 1}; /* of the shallow water: bisected */
            const double head = 1 + discharge * discharge / (2 * gravity * 16);
            for (int bisection = 0; bisection < 60; ++bisection) {
                const double middle = (deep[0] + deep[1]) / 2;
                const double has = middle + discharge * discharge / (2 * gravity * middle * middle);
                deep[has > head ? 1 : 0] = middle;
            }
            cd_water* w = line_basin(along_y, N, 2, 1, CD_FLOAT64);
            basin_set_way(w, &ways[ADVECTED]);
            for (size_t i = 0; i < N; ++i) {
                const double x = fmin(1, fmax(0, ((double)(back ? N - 1 - i : i) - 30) / 30));
                bed[i] = -3 * x * x * (3 - 2 * x), d[i] = 1 - bed[i];
            }
            line_write(w, along_y, CD_BED, bed);
            line_write(w, along_y, CD_DEPTH, d);
            ok(cd_water_set_side(w, line_side(along_y, back), CD_BORDER_INFLOW, discharge, 0));
            ok(cd_water_set_side(w, line_side(along_y, !back), CD_BORDER_LEVEL, 1, 0));
            basin_step(w, dts[k], (size_t)(2000 / dts[k]));
            line_read(w, along_y, CD_DEPTH, 1e-9, d);
            print_message("a stream that slows down, steps of %g s: %.4f m deep, not %.4f\n", dts[k],
                          d[back ? N - 11 : 10], deep[0]);
            assert_near(d[back ? N - 11 : 10], deep[0], 5e-3, 0);
            cd_water_destroy(w);
        }
}

/* ---- levels and edges -------------------------------------------------------------------------------------------- */

/* Whatever a pool holds at first, it comes to the level that a side holds. */
static void a_pool_comes_to_the_level_of_its_side(void** state) {
    (void)state;
    enum { N = 20 };
    for (size_t k = 0; k < WAYS; ++k)
        for (int end = 0; end < 4; ++end) {
            double d[N];
            cd_water* w = line_basin(end / 2, N, 2, 0.5, CD_FLOAT64);
            basin_set_way(w, &ways[k]);
            ok(cd_water_set_drag(w, 0.5));
            ok(cd_water_set_side(w, line_side(end / 2, end % 2), CD_BORDER_LEVEL, 0.5, 0));
            for (size_t i = 0; i < N; ++i) d[i] = end % 3 ? 1 : 0.2;
            line_write(w, end / 2, CD_DEPTH, d);
            basin_step(w, basin_is_explicit(&ways[k]) ? 0.05 : 0.3, 4000);
            line_read(w, end / 2, CD_DEPTH, 1e-9, d);
            for (size_t i = 0; i < N; ++i) assert_near(d[i], 0.5, 1e-7, 0);
            assert_true(basin_volume_off(w) <= 1e-12);
            cd_water_destroy(w);
        }
}

/* A level of a sin(w t) that a side holds makes the water before a wall stand by a cos(k (L - x)) / cos(k L) sin(w t),
 * k = w / c = 0.6 / L, whether waves cross a quarter of a cell in a step or a whole one. */
static void a_level_that_moves_is_held_at_the_side_itself(void** state) {
    (void)state;
    static const int which[] = {LINEAR_HALF, ADVECTED};
    const double deep = 10, length = 1000, c = sqrt(gravity * deep), k = 0.6 / length, w = k * c, high = 1e-5;
    for (int row = 0; row < 4; ++row)
        for (cd_side side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
            const int along_y = side >= CD_SIDE_Y_FIRST, last = side % 2;
            for (size_t n = 25; n <= 100; n *= 2) {
                const double dx = length / (double)n, dt = (row % 2 ? 1 : 0.25) * dx / c;
                double values[101], off = 0, t = 0;
                cd_water* water = line_basin(along_y, n, 1, dx, CD_FLOAT64);
                basin_set_way(water, &ways[which[row / 2]]);
                ok(cd_water_set_side(water, side, CD_BORDER_LEVEL, deep, 0));
                for (size_t i = 0; i < n; ++i) values[i] = deep;
                line_write(water, along_y, CD_DEPTH, values);
                for (size_t i = 0; i <= n; ++i)
                    values[i] = high * c / deep * sin(k * dx * (double)(last ? i : n - i)) * (last ? -1 : 1);
                line_write(water, along_y, CD_VELOCITY_X, values);
                for (; w * t < 6 * PI; t += dt) {
                    const double now = high * cos(0.6) * sin(w * t), then = high * cos(0.6) * sin(w * (t + dt));
                    ok(cd_water_set_side(water, side, CD_BORDER_LEVEL, deep + now, (then - now) / dt));
                    basin_step(water, dt, 1);
                }
                line_read(water, along_y, CD_DEPTH, 0, values);
                for (size_t i = 0; i < n; ++i) {
                    const double from_wall = ((double)(last ? i : n - 1 - i) + 0.5) * dx;
                    off = fmax(off, fabs((values[i] - deep - high * cos(k * from_wall) * sin(w * t)) / high));
                }
                cd_water_destroy(water);
                assert_true(off < 0.2 / (double)(n * n));
            }
        }
}

/* A slow stream and a film that fall off a lower edge run over it at their critical depth, (q^2 / g)^(1/3). */
static void what_falls_off_an_edge_is_critical_there(void** state) {
    (void)state;
    enum { N = 400 };
    static const double discharges[] = {0.5, 1e-3};
    for (size_t q = 0; q < COUNT(discharges); ++q)
        for (int c = 0; c < 2; ++c) {
            if (!is_taken(q + (size_t)c, 2)) continue;
            const double critical = pow(discharges[q] * discharges[q] / gravity, 1.0 / 3), dx = critical / 4;
            double d[N];
            cd_water* w = line_basin(0, N, 1, dx, CD_FLOAT64);
            basin_set_way(w, &ways[ADVECTED]);
            ok(cd_water_set_manning(w, 0.02 * pow(critical, 1.0 / 6))); /* alike at every depth */
            ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, discharges[q], 0));
            ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, -1, 0));
            for (size_t i = 0; i < N; ++i) d[i] = 2 * critical;
            line_write(w, 0, CD_DEPTH, d);
            basin_step(w, (c ? 2 : 0.5) * dx / sqrt(gravity * critical), c ? 5000 : 20000);
            line_read(w, 0, CD_DEPTH, 0, d);
            print_message("%g m^2/s off an edge: %.4f of its critical depth\n", discharges[q], d[N - 1] / critical);
            assert_near(d[N - 1], critical, 0.03, 0);
            cd_water_destroy(w);
        }
}

/* ---- what runs off ----------------------------------------------------------------------------------------------- */

/* The front of a broken dam reaches a side at which water falls off: up there it is as if land went on. */
static void a_dam_breaks_over_the_edge(void** state) {
    (void)state;
    enum { N = 200 };
    static const int which[] = {ADVECTED, EXPLICIT_ADVECTED};
    for (size_t k = 0; k < COUNT(which); ++k)
        for (int end = 0; end < 4; ++end) {
            const int along_y = end / 2, last = end % 2;
            double depth[2][2 * N], worst = 0;
            for (int longer = 0; longer < 2; ++longer) {
                const size_t n = longer ? 2 * N : N;
                cd_water* w = line_basin(along_y, n, 2, 1, CD_FLOAT64);
                double* d = depth[longer];
                basin_set_way(w, &ways[which[k]]);
                for (size_t i = 0; i < n; ++i) d[last ? i : n - 1 - i] = i < N / 2 ? 1 : 0;
                line_write(w, along_y, CD_DEPTH, d);
                if (!longer) ok(cd_water_set_side(w, line_side(along_y, last), CD_BORDER_OPEN, -1, 0));
                basin_step(w, 0.1, 300);
                line_read(w, along_y, CD_DEPTH, 1e-9, d);
                cd_water_destroy(w);
            }
            for (size_t i = 0; i < N; ++i) worst = fmax(worst, fabs(depth[0][i] - depth[1][last ? i : N + i]));
            print_message("%-17s side %d: depths differ by %.1e m at most\n", ways[which[k]].name, end, worst);
            assert_true(worst <= 1e-3);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wave_leaves_through_an_open_side),
        cmocka_unit_test(a_high_simple_wave_leaves_too),
        cmocka_unit_test(a_pool_comes_to_the_level_of_its_side),
        cmocka_unit_test(a_level_that_moves_is_held_at_the_side_itself),
        cmocka_unit_test(what_falls_off_an_edge_is_critical_there),
        cmocka_unit_test(a_tide_runs_into_a_basin_and_out_again),
        cmocka_unit_test(a_basin_fills_to_the_level_outside_and_drains),
        cmocka_unit_test(discharges_bring_in_what_they_say),
        cmocka_unit_test(a_stream_goes_through_as_it_comes_in),
        cmocka_unit_test(a_stream_over_a_bump_keeps_its_head),
        cmocka_unit_test(a_stream_that_slows_down_keeps_its_head),
        cmocka_unit_test(a_dam_breaks_over_the_edge),
    };
    return cmocka_run_group_tests_name("water sides", tests, NULL, NULL);
}
