/* Streams that come in in a given depth, faster than their waves: down a flume, over a bump, against friction, into a
 * jump, and under gates that are drowned. */
#include <math.h>

#include "basin.h"
#include "check.h"

static const double gravity = 9.81;
enum { MOST = 400 };

/* Advected ways, and steps in which a stream's waves run so many cells. */
static const struct {
    int way;
    double lambda, courant;
} runs[] = {
    {ADVECTED, 0.5, 0.4}, {ADVECTED, 0.5, 2}, {ADVECTED, 0.5, 8}, {ADVECTED, 1, 0.9}, {EXPLICIT_ADVECTED, 0.5, 0.4}};

/* A flume of n cells, along x or y and either way, into which `flow` comes in in the depth `gate`. */
struct flume {
    int along_y, last;
    size_t n;
    double length, flow, gate;
};

static double speed_of(const struct flume* f) { return f->flow / f->gate; }

/* `values` run with the stream. */
static void turn(const struct flume* f, double* values) {
    for (size_t i = 0; f->last && i < f->n / 2; ++i) {
        const double one = values[i];
        values[i] = values[f->n - 1 - i];
        values[f->n - 1 - i] = one;
    }
}

static cd_water* flume(const struct flume* f, size_t run, double depth, double slope, double manning) {
    double bed[MOST], depths[MOST];
    const double dx = f->length / (double)f->n;
    cd_water* w = line_basin(f->along_y, f->n, 2, dx, CD_FLOAT64);
    basin_set_way(w, &ways[runs[run].way]);
    if (!basin_is_explicit(&ways[runs[run].way])) ok(cd_water_set_lambda(w, runs[run].lambda));
    ok(cd_water_set_manning(w, manning));
    for (size_t i = 0; i < f->n; ++i) bed[i] = -slope * ((double)i + 0.5) * dx, depths[i] = depth;
    turn(f, bed);
    line_write(w, f->along_y, CD_BED, bed);
    line_write(w, f->along_y, CD_DEPTH, depths);
    ok(cd_water_set_side(w, line_side(f->along_y, f->last), CD_BORDER_INFLOW, f->flow, 0));
    ok(cd_water_set_inflow_depth(w, line_side(f->along_y, f->last), f->gate));
    ok(cd_water_set_side(w, line_side(f->along_y, !f->last), CD_BORDER_OPEN, -100, 0));
    return w;
}

/* Depths with the stream, after some seconds. */
static void after(cd_water* w, const struct flume* f, size_t run, double seconds, double* out_depths) {
    const double dt = runs[run].courant * f->length / (double)f->n / (speed_of(f) + sqrt(gravity * f->gate));
    basin_step(w, dt, (size_t)ceil(seconds / dt));
    assert_true(basin_volume_off(w) <= 1e-12);
    line_read(w, f->along_y, CD_DEPTH, 1e-9, out_depths);
    turn(f, out_depths);
}

/* Whether the flume was dry, or water stood in it as deep, or twice as deep. */
static void a_fast_stream_has_the_depth_that_it_comes_in_with(void** state) {
    (void)state;
    static const double froude[] = {1.5, 3, 8};
    for (size_t run = 0; run < COUNT(runs); ++run) {
        double worst = 0;
        for (size_t k = 0; k < COUNT(froude) * 4 * 3; ++k) {
            const double gate = 0.5, before = gate * (double)(k % 3), fast = froude[k / 12];
            const struct flume f = {k / 3 % 2, k / 6 % 2, 40, 10, fast * sqrt(gravity * gate) * gate, gate};
            double depths[MOST];
            cd_water* w = flume(&f, run, before, 0, 0);
            after(w, &f, run, 60, depths);
            for (size_t i = 0; i < f.n; ++i) worst = fmax(worst, fabs(depths[i] - gate));
            cd_water_destroy(w);
        }
        print_message("%-17s courant %.1f: a fast stream is off by %.1e m\n", ways[runs[run].way].name,
                      runs[run].courant, worst);
        assert_true(worst <= 1e-10);
    }
}

static double bump(double x) { return fmax(0, 0.05 * (1 - (x - 10) * (x - 10) / 4)); }

/* Bernoulli: h + q^2 / (2 g h^2) is the head over the bed; the fast one of its two depths. */
static double fast_depth(double q, double head) {
    double low = 1e-6, high = pow(q * q / gravity, 1.0 / 3);
    for (int k = 0; k < 100; ++k) {
        const double h = (low + high) / 2;
        if (h + q * q / (2 * gravity * h * h) > head) low = h;
        else high = h;
    }
    return low;
}

static void a_fast_stream_over_a_bump_keeps_its_head(void** state) {
    (void)state;
    static const double froude[] = {1.5, 3}, most[] = {8e-4, 1.2e-4}; /* of the depth, with 100 cells */
    for (size_t k = 0; k < COUNT(runs) * COUNT(froude); ++k) {
        const size_t run = k / 2;
        const double gate = 0.5, fast = froude[k % 2] * sqrt(gravity * gate), head = gate + fast * fast / (2 * gravity);
        double before = INFINITY;
        for (size_t n = 100; n <= 200; n *= 2) {
            const struct flume f = {0, run % 2 != 0, n, 20, fast * gate, gate};
            double bed[MOST], depths[MOST], error = 0;
            cd_water* w = flume(&f, run, 0.1, 0, 0);
            for (size_t i = 0; i < n; ++i) bed[i] = bump(((double)i + 0.5) * 20 / (double)n);
            turn(&f, bed);
            line_write(w, 0, CD_BED, bed);
            after(w, &f, run, 30, depths);
            for (size_t i = 0; i < n; ++i)
                error += fabs(depths[i] - fast_depth(f.flow, head - bump(((double)i + 0.5) * 20 / (double)n)));
            error /= (double)n * gate;
            print_message("%-17s courant %.1f, Froude %.1f, %zu cells: off by %.2e of the depth\n",
                          ways[runs[run].way].name, runs[run].courant, froude[k % 2], n, error);
            assert_true(error <= most[k % 2] && error <= 0.4 * before);
            before = error;
            cd_water_destroy(w);
        }
    }
}

/* ---- friction ---------------------------------------------------------------------------------------------------- */

/* A stream has the depth that it comes in with in the middle of the first cell: friction and slope begin there.
 * h_x = (slope - Sf) / (1 - q^2 / g h^3), Sf = (n q)^2 h^(-10/3): gradually varied flow. */
static double steepness(double q, double slope, double manning, double h) {
    return (slope - pow(manning * q, 2) * pow(h, -10.0 / 3)) / (1 - q * q / (gravity * h * h * h));
}

/* The depth so far down the stream (or up, of a distance < 0) from where it is h, by Runge and Kutta. */
static double depth_from(double h, double distance, double q, double slope, double manning) {
    enum { PARTS = 2000 };
    const double dx = distance / PARTS;
    for (int k = 0; k < PARTS; ++k) {
        const double a = steepness(q, slope, manning, h), b = steepness(q, slope, manning, h + dx / 2 * a);
        const double c = steepness(q, slope, manning, h + dx / 2 * b), d = steepness(q, slope, manning, h + dx * c);
        h += dx / 6 * (a + 2 * b + 2 * c + d);
    }
    return h;
}

static void a_fast_stream_comes_to_its_normal_depth(void** state) {
    (void)state;
    const double q = 2, slope = 0.02, manning = 0.02;
    for (size_t k = 0; k < COUNT(runs) * 2; ++k) {
        const size_t run = k / 2;
        const double gate = k % 2 ? 0.3 : 0.6; /* it slows down, and speeds up, to 0.469 m */
        double before = INFINITY;
        for (size_t n = 50; n <= 100; n *= 2) {
            const struct flume f = {run % 2 != 0, run % 3 == 0, n, 50, q, gate};
            double depths[MOST], error = 0;
            cd_water* w = flume(&f, run, 0.2, slope, manning);
            after(w, &f, run, 100, depths);
            for (size_t i = 0; i < n; ++i) {
                const double x = (double)i * 50 / (double)n; /* from there */
                error += fabs(depths[i] - depth_from(gate, x, q, slope, manning)) / gate / (double)n;
            }
            print_message("%-17s courant %.1f, from %.1f m, %zu cells: off by %.2e of the depth\n",
                          ways[runs[run].way].name, runs[run].courant, gate, n, error);
            assert_true(error <= 1e-3 && error <= 0.5 * before);
            before = error;
            cd_water_destroy(w);
        }
    }
}

/* ---- jumps ------------------------------------------------------------------------------------------------------- */

static double momentum_of(double q, double h) { return q * q / h + gravity * h * h / 2; }

/* A stream under a gate runs over a rough level bed, slows down, and jumps to the level that a side holds, where the
 * momentum of what comes is that of what stands behind (Belanger 1828). */
static void a_jump_stands_where_both_momenta_are_equal(void** state) {
    (void)state;
    const double q = 2, gate = 0.3, manning = 0.02, length = 30, levels[] = {1.4, 1.25};
    for (size_t k = 0; k < COUNT(runs) * 2; ++k) {
        const size_t run = k / 2;
        const struct flume f = {run % 2 != 0, run % 3 == 0, 120, length, q, gate};
        const double dx = length / (double)f.n, level = levels[k % 2];
        double depths[MOST], place = 0, low = 0, high = length;
        for (int n = 0; n < 40; ++n) { /* the exact one */
            const double x = (low + high) / 2, fast = depth_from(gate, x - dx / 2, q, 0, manning);
            const double slow = depth_from(level, x - (length - dx / 2), q, 0, manning);
            if (momentum_of(q, fast) > momentum_of(q, slow)) low = x;
            else high = x;
        }
        cd_water* w = flume(&f, run, level, 0, manning);
        ok(cd_water_set_side(w, line_side(f.along_y, !f.last), CD_BORDER_LEVEL, level, 0));
        after(w, &f, run, 150, depths);
        const double fast = depth_from(gate, low - dx / 2, q, 0, manning);
        const double sequent = depth_from(level, low - (length - dx / 2), q, 0, manning), middle = (fast + sequent) / 2;
        for (size_t i = 1; i < f.n && place == 0; ++i)
            if (depths[i] > middle) /* between the cells */
                place = ((double)i - 0.5 + (middle - depths[i - 1]) / (depths[i] - depths[i - 1])) * dx;
        double most = 0; /* but for eight cells on each side of the jump */
        for (size_t i = 0; i < f.n; ++i) {
            const double x = ((double)i + 0.5) * dx;
            const double exact = x < low ? depth_from(gate, x - dx / 2, q, 0, manning)
                                         : depth_from(level, x - (length - dx / 2), q, 0, manning);
            if (fabs(x - low) > 8 * dx) most = fmax(most, fabs(depths[i] - exact));
        }
        print_message("%-17s courant %.1f: from %.3f to %.3f m at %.2f m, %.2f cells off; depths off by %.1e m\n",
                      ways[runs[run].way].name, runs[run].courant, fast, sequent, low, (place - low) / dx, most);
        assert_true(fabs(place - low) <= 1.2 * dx && most <= 0.03);
        cd_water_destroy(w);
    }
}

/* With a level too high for a jump the gate is drowned: what stands over the jet is as deep as the momentum says. So it
 * is where a slow stream comes in in a depth that is not its own. */
static void what_drowns_a_gate_is_as_deep_as_the_momentum_says(void** state) {
    (void)state;
    static const double scenes[][3] = {
        {1.6, 0.3, 2}, {1.2, 0.5, 1.5}, {1, 0.8, 0.8}, {1, 1.5, 0.8}}; /* level, gate, q */
    for (size_t run = 0; run < COUNT(runs); ++run) {
        double worst = 0;
        for (size_t k = 0; k < COUNT(scenes); ++k) {
            const double level = scenes[k][0], gate = scenes[k][1], q = scenes[k][2];
            const struct flume f = {k % 2 != 0, run % 2 != 0, 100, 25, q, gate};
            const double exact = sqrt(2 / gravity * (momentum_of(q, level) - q * q / gate));
            double depths[MOST];
            cd_water* w = flume(&f, run, level, 0, 0);
            ok(cd_water_set_side(w, line_side(f.along_y, !f.last), CD_BORDER_LEVEL, level, 0));
            after(w, &f, run, 250, depths);
            worst = fmax(worst, fabs(depths[0] - exact) / exact);
            cd_water_destroy(w);
        }
        print_message("%-17s courant %.1f: behind drowned gates off by %.1e\n", ways[runs[run].way].name,
                      runs[run].courant, worst);
        assert_true(worst <= 2e-4);
    }
}

/* Of linear momentum one wave always runs against the stream: the depth comes from inside. */
static void linear_streams_take_no_depth(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k) {
        if (ways[k].momentum != CD_MOMENTUM_LINEAR) continue;
        double depths[2][50];
        for (int given = 0; given < 2; ++given) {
            cd_water* w = line_basin(0, 50, 1, 1, CD_FLOAT64);
            basin_set_way(w, &ways[k]);
            ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_INFLOW, 2, 0));
            ok(cd_water_set_side(w, CD_SIDE_X_LAST, CD_BORDER_OPEN, 0.25, 0));
            if (given) ok(cd_water_set_inflow_depth(w, CD_SIDE_X_FIRST, 0.25));
            basin_step(w, 0.1, 100);
            line_read(w, 0, CD_DEPTH, 0, depths[given]);
            cd_water_destroy(w);
        }
        for (size_t i = 0; i < 50; ++i) assert_true(depths[0][i] == depths[1][i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fast_stream_has_the_depth_that_it_comes_in_with),
        cmocka_unit_test(a_fast_stream_over_a_bump_keeps_its_head),
        cmocka_unit_test(a_fast_stream_comes_to_its_normal_depth),
        cmocka_unit_test(a_jump_stands_where_both_momenta_are_equal),
        cmocka_unit_test(what_drowns_a_gate_is_as_deep_as_the_momentum_says),
        cmocka_unit_test(linear_streams_take_no_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
