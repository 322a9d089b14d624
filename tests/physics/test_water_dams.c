/* Fronts: dams that break onto water (Stoker 1957) and onto dry ground (Ritter 1892), and a front that drag slows down
 * over dry ground; and bores that a wall throws back or that run into water at rest. All but the front are solutions
 * with advected momentum only. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"

static const double gravity = 9.81, deep = 0.005;

/* The depth a time t after the dam at x = 0 broke. */
static double stoker(double x, double t) {
    const double c0 = sqrt(gravity * deep), plateau = 0.00253936, speed = 0.127280, shock = 0.209963;
    if (x < -c0 * t) return deep;
    if (x < (speed - sqrt(gravity * plateau)) * t) return pow(2 * c0 - x / t, 2) / (9 * gravity);
    return x < shock * t ? plateau : 0.001;
}
static double ritter(double x, double t) {
    const double c0 = sqrt(gravity * deep);
    if (x < -c0 * t) return deep;
    return x < 2 * c0 * t ? pow(2 * c0 - x / t, 2) / (9 * gravity) : 0;
}

struct dam {
    double error;  /* L1 of the depth, over the volume */
    double middle; /* depth halfway between the dam and the shock */
    double speed;  /* and the velocity there */
};

static struct dam breaks(const struct way* way, int along_y, size_t n, int wet, double step) {
    const double dx = 2.0 / (double)n, time = wet ? 2.5 : 2, dt_near = step * dx / sqrt(gravity * deep);
    const size_t steps = (size_t)ceil(time / dt_near);
    struct dam dam = {0, 0, 0};
    double *d = calloc(n + 1, sizeof *d), all = 0;
    assert_non_null(d);
    cd_water* w = line_basin(along_y, n, 3, dx, CD_FLOAT64);
    basin_set_way(w, way);
    for (size_t i = 0; i < n; ++i) d[i] = i < n / 2 ? deep : wet ? 0.001 : 0;
    line_write(w, along_y, CD_DEPTH, d);
    for (size_t k = 0; k < steps; ++k) basin_step(w, time / (double)steps, 1);
    line_read(w, along_y, CD_DEPTH, 1e-9 * deep, d);
    for (size_t i = 0; i < n; ++i) {
        const double exact = (wet ? stoker : ritter)(((double)i + 0.5) * dx - 1, time);
        dam.error += fabs(d[i] - exact), all += exact;
    }
    dam.error /= all;
    const size_t middle = n / 2 + (size_t)(0.25 / dx);
    dam.middle = d[middle];
    line_read(w, along_y, CD_VELOCITY_X, 1e-8, d);
    dam.speed = d[middle];
    cd_water_destroy(w);
    free(d);
    return dam;
}

static void dams_break_as_stoker_and_ritter_say(void** state) {
    (void)state;
    static const struct {
        int way, wet;
        double step, most[4];
    } rows[] = {
        {ADVECTED, 1, 0.5, {5.2e-3, 2.8e-3, 1.5e-3, 7.5e-4}},  {ADVECTED, 0, 0.5, {9.5e-3, 4.6e-3, 2.2e-3, 1.1e-3}},
        {ADVECTED, 1, 2, {7.2e-3, 3.8e-3, 1.9e-3, 1.0e-3}},    {ADVECTED, 0, 2, {1.2e-2, 5.4e-3, 2.7e-3, 1.4e-3}},
        {EXPLICIT_ADVECTED, 1, 0.3, {4.3e-3, 2.6e-3, 1.4e-3}}, {EXPLICIT_ADVECTED, 0, 0.3, {9.5e-3, 4.6e-3, 2.2e-3}},
    };
    for (size_t r = 0; r < COUNT(rows); ++r)
        for (int along_y = 0; along_y < (rows[r].way == ADVECTED ? 2 : 1); ++along_y) {
            size_t n = 200;
            double before = INFINITY;
            for (int k = 0; k < (along_y ? 2 : 4) && rows[r].most[k] > 0; ++k, n *= 2) {
                const struct dam dam = breaks(&ways[rows[r].way], along_y, n, rows[r].wet, rows[r].step);
                print_message("%s along %c, %-17s %4zu cells: L1 %.2e", rows[r].wet ? "Stoker" : "Ritter",
                              along_y ? 'y' : 'x', ways[rows[r].way].name, n, dam.error);
                if (rows[r].wet)
                    print_message(", plateau x %.5f, speed x %.5f", dam.middle / 0.00253936, dam.speed / 0.127280);
                print_message("\n");
                if (rows[r].wet) {
                    assert_near(dam.middle, 0.00253936, 1e-3, 0);
                    assert_near(dam.speed, 0.127280, 2e-3, 0);
                }
                assert_true(dam.error <= rows[r].most[k]);
                assert_true(dam.error < before);
                before = dam.error;
            }
        }
}

/* ---- a front with drag ------------------------------------------------------------------------------------------- */

/* d = (drag u / g) (u t - x) where that is positive: at every place the slope of the surface makes up for the drag. */
static double front(const struct way* way, int along_y, int last, size_t n, double step) {
    const double u = 1, drag = 2, dx = 10.0 / (double)n, time = 8, part = drag * u / gravity;
    const size_t steps = (size_t)ceil(time * u / (step * dx));
    double *d = calloc(n, sizeof *d), off = 0, all = 0, initial, in, out;
    assert_non_null(d);
    cd_water* w = line_basin(along_y, n, 2, dx, CD_FLOAT64);
    basin_set_way(w, way);
    ok(cd_water_set_drag(w, drag));
    ok(cd_water_set_side(w, line_side(along_y, last), CD_BORDER_INFLOW, 0, u * part * u));
    for (size_t k = 0; k < steps; ++k) basin_step(w, time / (double)steps, 1);
    line_read(w, along_y, CD_DEPTH, 1e-9, d);
    for (size_t i = 0; i < n; ++i) {
        const double exact = fmax(0, part * (u * time - ((double)i + 0.5) * dx));
        off += fabs(d[last ? n - 1 - i : i] - exact), all += exact;
    }
    ok(cd_water_get_account(w, &initial, &in, &out, NULL));
    assert_near(in, u * part * u * time * time / 2 * 2 * dx, 0.02, 0); /* the discharge of each step's middle or end */
    assert_true(initial == 0 && out == 0);
    assert_near(basin_volume(w), in, 1e-13, 0);
    assert_true(basin_least(w, CD_DEPTH) >= 0);
    cd_water_destroy(w);
    free(d);
    return off / all;
}

static void a_front_runs_over_dry_ground_against_drag(void** state) {
    (void)state;
    static const struct {
        int way;
        double most[3];
    } rows[] = {
        {LINEAR, {1.2e-2, 9.9e-3, 9.1e-3}},
        {LINEAR_ONE, {1.1e-2, 9.2e-3, 8.5e-3}}, /* hardly converges */
        {ADVECTED, {8.2e-4, 4.1e-4, 2.1e-4}},
        {EXPLICIT, {1.3e-2, 1.2e-2, 1.2e-2}},
        {EXPLICIT_ADVECTED, {8.2e-4, 4.1e-4, 2.1e-4}},
    };
    for (size_t r = 0; r < COUNT(rows); ++r) {
        size_t n = 100;
        for (int k = 0; k < 3 && rows[r].most[k] > 0; ++k, n *= 2)
            for (int side = 0; side < (k == 0 ? 4 : 1); ++side) {
                const double error = front(&ways[rows[r].way], side / 2, side % 2, n, 0.1);
                print_message("front, %-17s %zu cells, side %d: L1 %.2e\n", ways[rows[r].way].name, n, side, error);
                assert_true(error <= rows[r].most[k]);
            }
    }
}

static void turn_round(double* line, size_t n) {
    for (size_t i = 0; i < n / 2; ++i) {
        const double of = line[i];
        line[i] = line[n - 1 - i], line[n - 1 - i] = of;
    }
}

/* A stream a metre deep that a wall stops piles up behind a bore that runs back against it, as mass and momentum say
 * (Stoker 1957, chapter 10), or, of linear momentum, mass and the slope of the surface. */
static void a_stream_against_a_wall_sends_back_a_bore(void** state) {
    (void)state;
    enum { N = 600 };
    static const double streams[] = {1, 2, 4}, courants[] = {0.5, 4, 16};
    for (size_t n = 0; n < 2 * COUNT(streams) * COUNT(courants); ++n) {
        const size_t k = n / 2;
        const int advected = n & 1;
        const double stream = streams[k / COUNT(courants)], courant = courants[k % COUNT(courants)];
        const int along_y = k / COUNT(courants) & 1, at_first = k < 2; /* which wall stops it */
        double h[2] = {1, 100}, d[N], u[N + 1], place[2];              /* h: bisected */
        for (int bisection = 0; bisection < 60; ++bisection) {
            const double middle = (h[0] + h[1]) / 2;
            const double carried = advected ? (middle + 1) / (2 * middle) : 1;
            h[(middle - 1) * sqrt(gravity * carried) > stream ? 1 : 0] = middle;
        }
        const double speed = stream / (h[0] - 1), time = 0.2 * N / (speed + stream);
        const size_t steps = (size_t)ceil(time * sqrt(gravity * h[0]) / courant);
        cd_water* w = line_basin(along_y, N, 3, 1, CD_FLOAT64);
        basin_set_way(w, &ways[advected ? ADVECTED : LINEAR]);
        for (size_t i = 0; i < N; ++i) d[i] = 1;
        for (size_t i = 0; i <= N; ++i) u[i] = i == 0 || i == N ? 0 : at_first ? -stream : stream;
        line_write(w, along_y, CD_DEPTH, d);
        line_write(w, along_y, CD_VELOCITY_X, u);
        double behind = 0;
        for (int half = 0; half < 2; ++half) {
            basin_step(w, time / (double)steps, steps);
            line_read(w, along_y, CD_DEPTH, 1e-12, d);
            if (!at_first) turn_round(d, N);
            size_t i = N / 2; /* in front of the bore */
            const double front = (1 + h[0]) / 2;
            while (d[i - 1] < front) --i;
            place[half] = (double)i + (d[i - 1] - front) / (d[i - 1] - d[i]);
            behind = 0;
            for (size_t l = 0; l < i - 10; ++l) behind += d[l] / ((double)(i - 10) * h[0]);
        }
        const double slow = 1 - (place[1] - place[0]) / (speed * time);
        print_message("%s stream of %g m/s, courant %3g: bore %+.1e too slow, the water behind %+.1e too deep\n",
                      advected ? "advected" : "linear", stream, courant, slow, behind - 1);
        assert_true(fabs(slow) <= 1e-2);
        assert_true(fabs(behind - 1) <= 1e-2);
        cd_water_destroy(w);
    }
}

/* A bore that a steady inflow sends into water at rest, a metre deep: a part of that high. What water.h tells of it. */
static void a_bore_into_water_at_rest_runs_as_slowly_as_is_told(void** state) {
    (void)state;
    enum { N = 800 };
    static const double heights[] = {0.1, 0.5, 2}, linear[] = {0.023, 0.091, 0.227}, courants[] = {0.5, 2, 4, 8, 16};
    for (size_t k = 0; k < 2 * COUNT(heights); ++k)
        for (size_t c = 0; c < COUNT(courants); ++c) {
            const int along_y = k & 1, advected = k >= COUNT(heights);
            const double height = heights[k % COUNT(heights)], deep_behind = 1 + height;
            const double speed = sqrt(gravity * deep_behind * (1 + deep_behind) / 2), time = 0.35 * N / speed;
            const size_t steps = (size_t)ceil(time * sqrt(gravity * deep_behind) / courants[c]);
            double d[N], place[2];
            cd_water* w = line_basin(along_y, N, 3, 1, CD_FLOAT64);
            basin_set_way(w, &ways[advected ? ADVECTED : LINEAR]);
            for (size_t i = 0; i < N; ++i) d[i] = 1;
            line_write(w, along_y, CD_DEPTH, d);
            ok(cd_water_set_side(w, line_side(along_y, 0), CD_BORDER_INFLOW, speed * height, 0));
            for (int half = 0; half < 2; ++half) {
                basin_step(w, time / (double)steps, steps);
                line_read(w, along_y, CD_DEPTH, 1e-12, d);
                const double front = 1 + height / 2;
                size_t i = N - 1;
                while (d[i - 1] < front) --i;
                place[half] = (double)i + (d[i - 1] - front) / (d[i - 1] - d[i]);
            }
            const double slow = 1 - (place[1] - place[0]) / (speed * time);
            print_message("%s bore %g m high, courant %g: %+.2e too slow\n", advected ? "advected" : "linear", height,
                          courants[c], slow);
            if (advected) assert_true(fabs(slow) <= (c > 0 ? 0.011 : 1e-3));
            else assert_near(slow, linear[k], 0.05, 0);
            cd_water_destroy(w);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dams_break_as_stoker_and_ritter_say),
        cmocka_unit_test(a_front_runs_over_dry_ground_against_drag),
        cmocka_unit_test(a_stream_against_a_wall_sends_back_a_bore),
        cmocka_unit_test(a_bore_into_water_at_rest_runs_as_slowly_as_is_told),
    };
    return cmocka_run_group_tests_name("water dams", tests, NULL, NULL);
}
