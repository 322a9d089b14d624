/* Advected momentum: what is carried is kept; whirls stay whirls; walls and masks hold water. */
#include <math.h>
#include <stdlib.h>

#include "basin.h"
#include "check.h"
#include "modes.h"
#include "reference.h"

enum { NX = 24, NY = 18 };

/* The sum of velocity x the mean depth of the two cells, of a ring's x-faces. */
static double momentum_x(const cd_water* w, size_t nx, size_t ny) {
    double sum = 0;
    for (size_t j = 0; j < ny; ++j)
        for (size_t i = 0; i < nx; ++i) {
            const double d = basin_get(w, CD_DEPTH, i, j) + basin_get(w, CD_DEPTH, i > 0 ? i - 1 : nx - 1, j);
            sum += 0.5 * d * basin_get(w, CD_VELOCITY_X, i, j);
        }
    return sum;
}

static const int advected[] = {ADVECTED, EXPLICIT_ADVECTED};

/* Over a flat bed, to rounding: what carries takes from one face what it gives the next, and the pushes of the surface,
 * half (d_r + d_l) (d_r - d_l), add up to 0, of high waves and of low ones that cross up to 100 cells in a step. */
static void a_stream_that_goes_round_keeps_its_momentum(void** state) {
    (void)state;
    static const double height_and_dt[][2] = {{0.3, 0.1}, {1e-3, 0.1}, {1e-3, 3}, {0.02, 3}, {0.02, 30}};
    for (size_t k = 0; k < COUNT(advected); ++k)
        for (size_t c = 0; c < COUNT(height_and_dt); ++c) {
            const double height = height_and_dt[c][0], dt = height_and_dt[c][1];
            if (basin_is_explicit(&ways[advected[k]]) && dt > 0.1) continue;
            double worst = 0;
            cd_water* w = basin(60, 1, 1, 1, CD_FLOAT64);
            basin_set_way(w, &ways[advected[k]]);
            if (dt > 0.1) ok(cd_water_set_lambda(w, 0.5)); /* or the waves have died out soon */
            ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
            for (size_t i = 0; i < 60; ++i) {
                basin_set(w, CD_DEPTH, i, 0, 1 + height * sin(2 * (double)PI * (double)i / 60));
                basin_set(w, CD_VELOCITY_X, i, 0, 1);
            }
            const double start = momentum_x(w, 60, 1);
            for (int s = 0; s < 2000; ++s) {
                basin_step(w, dt, 1);
                worst = fmax(worst, fabs(momentum_x(w, 60, 1) / start - 1));
            }
            print_message("%-17s waves of %g of the depth, steps of %g s: momentum off by %.1e\n",
                          ways[advected[k]].name, height, dt, worst);
            assert_true(worst < (dt > 3 ? 1e-10 : 1e-13)); /* a step of 64 parts rounds more */
            cd_water_destroy(w);
        }
}

/* A uniform stream over a flat bed, straight or aslant, does not change as long as its water goes less than a cell in a
 * step. Longer ones wind up what rounding leaves. */
static void a_uniform_stream_stays_uniform(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k) {
        cd_water* w = basin(NX, NY, 1, 1.3, CD_FLOAT64);
        basin_set_way(w, &ways[k]);
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) {
                basin_set(w, CD_DEPTH, i, j, 0.4);
                basin_set(w, CD_VELOCITY_X, i, j, 5);
                basin_set(w, CD_VELOCITY_Y, i, j, -3);
            }
        const double dt = 0.1;
        for (int s = 0; s < 300; ++s) basin_step(w, dt, 1);
        for (size_t j = 0; j < NY; ++j)
            for (size_t i = 0; i < NX; ++i) {
                assert_near(basin_get(w, CD_DEPTH, i, j), 0.4, 1e-11, 0);
                assert_near(basin_get(w, CD_VELOCITY_X, i, j), 5, 1e-11, 0);
                assert_near(basin_get(w, CD_VELOCITY_Y, i, j), -3, 1e-11, 0);
            }
        cd_water_destroy(w);
    }
}

/* A row of whirls in a box that goes round: upwind carrying wears them down and never winds them up. */
static void whirls_stay_bounded(void** state) {
    (void)state;
    for (size_t k = 0; k < COUNT(advected); ++k) {
        const int explicit_way = basin_is_explicit(&ways[advected[k]]);
        cd_water* w = basin(NX, NX, 1, 1, CD_FLOAT64);
        const double turn = 2 * (double)PI / NX, dt = explicit_way ? 0.1 : 0.2;
        basin_set_way(w, &ways[advected[k]]);
        ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
        ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
        for (size_t j = 0; j < NX; ++j)
            for (size_t i = 0; i < NX; ++i) {
                const double x = turn * (double)i, y = turn * (double)j;
                basin_set(w, CD_DEPTH, i, j, 1);
                basin_set(w, CD_VELOCITY_X, i, j, 0.5 * sin(x) * cos(y + turn / 2));
                basin_set(w, CD_VELOCITY_Y, i, j, -0.5 * cos(x + turn / 2) * sin(y));
            }
        const double start = basin_energy(w), moving = basin_kinetic(w);
        double most = 0, soon = 0;
        for (int s = 0; s < 3000; ++s) {
            basin_step(w, dt, 1);
            most = fmax(most, basin_energy(w) / start - 1);
            if (s == 50) soon = basin_kinetic(w) / moving;
        }
        print_message("%-17s whirls: %.2f of their energy left after %g s, %.2f at the end; above the start %+.1e\n",
                      ways[advected[k]].name, soon, 50 * dt, basin_kinetic(w) / moving, most);
        assert_true(most <= 1e-6);
        assert_true(soon > 0.9 && basin_kinetic(w) > 0.15 * moving); /* without slopes across 0.86, 0.04 */
        cd_water_destroy(w);
    }
}

/* Absent cells and walls between: not a drop comes through, whatever presses. */
static void walls_and_masks_hold_water_exactly(void** state) {
    (void)state;
    for (size_t k = 0; k < WAYS; ++k) {
        cd_water* w = basin(NX, NY, 1, 1, CD_FLOAT64);
        double values[(NX + 1) * NY];
        basin_set_way(w, &ways[k]);
        ok(cd_water_enable_field(w, CD_MASK));
        ok(cd_water_enable_field(w, CD_WALL_X));
        for (size_t c = 0; c < (NX + 1) * NY; ++c) values[c] = c % (NX + 1) == 8;
        basin_write(w, CD_WALL_X, values);
        for (size_t c = 0; c < NX * NY; ++c) values[c] = c % NX != 16;
        basin_write(w, CD_MASK, values);
        for (size_t c = 0; c < NX * NY; ++c) values[c] = c % NX < 8 ? 3 : c % NX > 16 ? 1 + 0.1 * (double)(c % 7) : 0;
        basin_write(w, CD_DEPTH, values);
        double left = 0, right = 0, start = 0;
        for (size_t c = 0; c < NX * NY; ++c) start += c % NX > 16 ? values[c] : 0;
        for (int s = 0; s < 300; ++s) basin_step(w, basin_is_explicit(&ways[k]) ? 0.05 : 0.5, 1);
        basin_read(w, CD_DEPTH, values);
        for (size_t c = 0; c < NX * NY; ++c) {
            if (c % NX < 8) left += values[c];
            else if (c % NX > 16) right += values[c];
            else assert_true(values[c] == 0);
        }
        assert_near(left, 3.0 * 8 * NY, 1e-13, 0);
        assert_near(right, start, 1e-13, 0);
        cd_water_destroy(w);
    }
}

/* A stream that runs up to three cells in a step, with ripples on it, between an inflow and an open side. */
static void a_swift_stream_stays_smooth(void** state) {
    (void)state;
    enum { CELLS = 120 };
    static const double speed_and_dt[][2] = {{1.5, 1}, {3, 1}, {5, 0.5}};
    const double depth = 0.4;
    for (size_t k = 0; k < COUNT(speed_and_dt); ++k)
        for (int upright = 0; upright < 2; ++upright) {
            const double u = speed_and_dt[k][0], outside = fmax(0.01, depth - u * sqrt(depth / 9.81));
            cd_water* w = basin(upright ? 1 : CELLS, upright ? CELLS : 1, 1, 1, CD_FLOAT64);
            ok(cd_water_set_momentum(w, CD_MOMENTUM_ADVECTED));
            ok(cd_water_set_side(w, upright ? CD_SIDE_Y_FIRST : CD_SIDE_X_FIRST, CD_BORDER_INFLOW, u * depth, 0));
            ok(cd_water_set_side(w, upright ? CD_SIDE_Y_LAST : CD_SIDE_X_LAST, CD_BORDER_OPEN, outside, 0));
            double d[CELLS], v[CELLS + 1], rough = 0;
            for (size_t i = 0; i < CELLS; ++i) d[i] = depth + 1e-6 * sin(2 * (double)PI * 7 * (double)i / 60);
            for (size_t i = 0; i <= CELLS; ++i) v[i] = u;
            const size_t nx = upright ? 1 : CELLS, ny = upright ? CELLS : 1;
            ok(cd_water_write_f64(w, CD_DEPTH, 0, 0, nx, ny, d, CELLS));
            ok(cd_water_write_f64(w, upright ? CD_VELOCITY_Y : CD_VELOCITY_X, 0, 0, upright ? 1 : CELLS + 1,
                                  upright ? CELLS + 1 : 1, v, CELLS + 1));
            ok(cd_water_step(w, speed_and_dt[k][1], 40));
            ok(cd_water_read_f64(w, CD_DEPTH, 0, 0, nx, ny, d, CELLS));
            for (size_t i = 10; i < CELLS / 2; ++i) rough = fmax(rough, fabs(d[i + 1] - d[i]));
            print_message("stream of %g m/s, steps of %g s: neighbours differ by at most %.1e\n", u, speed_and_dt[k][1],
                          rough);
            assert_true(rough < 1e-2); /* 0.5 to 1.4 where its depth is carried explicitly */
            cd_water_destroy(w);
        }
}

/* Round a ring nothing sets a stream's course but itself: ripples die out at any speed, in steps of any length, and the
 * stream goes on as fast. */
static void a_stream_round_a_ring_stays_smooth_at_any_speed(void** state) {
    (void)state;
    enum { CELLS = 60 };
    static const double cells_run[] = {0.3, 0.95, 1.5, 3, 10, 40}, cells_of_waves[] = {0.5, 2.2, 4, 30};
    for (size_t k = 0; k < WAYS; ++k) {
        if (!ways[k].momentum || basin_is_explicit(&ways[k])) continue;
        double worst = 0, slower = 0;
        for (size_t c = 0; c < COUNT(cells_run); ++c)
            for (size_t v = 0; v < COUNT(cells_of_waves); ++v) {
                const double depth = cells_of_waves[v] * cells_of_waves[v] / 9.81;
                cd_water* w = basin(CELLS, 1, 1, 1, CD_FLOAT64);
                double d[CELLS], u[CELLS + 1], rough = 0, momentum = 0, volume = 0;
                basin_set_way(w, &ways[k]);
                ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
                for (size_t i = 0; i < CELLS; ++i) d[i] = depth * (1 + 1e-6 * sin(2 * (double)(i * i)));
                for (size_t i = 0; i <= CELLS; ++i) u[i] = cells_run[c];
                basin_write(w, CD_DEPTH, d);
                basin_write(w, CD_VELOCITY_X, u);
                basin_step(w, 1, 60);
                basin_read(w, CD_DEPTH, d);
                basin_read(w, CD_VELOCITY_X, u);
                for (size_t i = 0; i < CELLS; ++i) {
                    const size_t before = i > 0 ? i - 1 : CELLS - 1;
                    rough = fmax(rough, fabs(d[i] - d[before]) / depth);
                    momentum += 0.5 * (d[before] + d[i]) * u[i];
                    volume += d[i];
                }
                worst = fmax(worst, rough);
                slower = fmax(slower, fabs(momentum / volume / cells_run[c] - 1));
                cd_water_destroy(w);
            }
        print_message("%-17s streams round a ring: neighbours differ by at most %.1e, speed off by %.1e\n",
                      ways[k].name, worst, slower);
        assert_true(worst <= 2e-6); /* as they did at first */
        assert_true(slower <= 1e-12);
    }
}

/* A ring of one row is the same water as one of two equal rows: the velocity across it goes with the stream, too. */
static void a_ring_of_one_row_goes_as_one_of_two(void** state) {
    (void)state;
    enum { CELLS = 20 };
    for (int along_y = 0; along_y < 2; ++along_y)
        for (int sleeps = 0; sleeps < 2; ++sleeps) {
            double across[2][CELLS], depths[2][CELLS], momentum = 0;
            for (size_t rows = 1; rows <= 2; ++rows) {
                cd_water* w = line_basin(along_y, CELLS, rows, 1, CD_FLOAT64);
                basin_set_way(w, &ways[ADVECTED]);
                ok(cd_water_set_first(w, along_y));
                if (sleeps) ok(cd_water_set_sleep(w, 1e-3));
                ok(cd_water_set_side(w, CD_SIDE_X_FIRST, CD_BORDER_PERIODIC, 0, 0));
                ok(cd_water_set_side(w, CD_SIDE_Y_FIRST, CD_BORDER_PERIODIC, 0, 0));
                const cd_field other = along_y ? CD_VELOCITY_X : CD_VELOCITY_Y;
                for (size_t i = 0; i <= CELLS; ++i)
                    for (size_t j = 0; j <= rows; ++j) {
                        const size_t x = along_y ? j : i, y = along_y ? i : j;
                        if (j < rows) basin_set(w, line_field(along_y, CD_VELOCITY_X), x, y, 1);
                        if (i == CELLS) continue;
                        basin_set(w, other, x, y, i < CELLS / 2 ? 1 : 0);
                        if (j < rows) basin_set(w, CD_DEPTH, x, y, 1 + 0.3 * sin(2 * (double)PI * (double)i / CELLS));
                    }
                for (int steps = 0; steps < 2; ++steps) {
                    double sum = 0;
                    for (size_t i = 0; i < CELLS; ++i) {
                        const size_t x = along_y ? 0 : i, y = along_y ? i : 0;
                        across[rows - 1][i] = basin_get(w, other, x, y);
                        depths[rows - 1][i] = basin_get(w, CD_DEPTH, x, y);
                        sum += across[rows - 1][i] * depths[rows - 1][i];
                    }
                    if (steps == 0) momentum = sum, basin_step(w, 0.1, 100);
                    else assert_near(sum, momentum, 1e-13, 0);
                }
                cd_water_destroy(w);
            }
            for (size_t i = 0; i < CELLS; ++i) {
                assert_near(across[0][i], across[1][i], 1e-12, 1);
                assert_near(depths[0][i], depths[1][i], 1e-12, 1);
            }
            assert_true(across[0][0] < 0.9); /* the front has gone round half of it */
        }
}

/* A lake runs through a canal into a lower one: what comes in has its speed from the upper level, and what runs out
 * stands at the lower one, so that u^2 / 2 g is how far that lies below the other (Bernoulli). */
static void a_canal_between_two_lakes_runs_by_their_levels(void** state) {
    (void)state;
    enum { CELLS = 20 };
    static const double falls[] = {0.001, 0.05, 0.2}, courants[] = {0.5, 4}, lambdas[] = {0.5, 0.55, 1};
    for (int side = 0; side < 4; ++side)
        for (size_t k = 0; k < COUNT(falls) * COUNT(courants) * COUNT(lambdas); ++k) {
            const double fall = falls[k % COUNT(falls)], courant = courants[k / COUNT(falls) % COUNT(courants)];
            const double lambda = lambdas[k / COUNT(falls) / COUNT(courants)], speed = sqrt(2 * 9.81 * fall);
            const int along_y = side > 1, last = side % 2; /* where the upper lake is */
            cd_water* w = line_basin(along_y, CELLS, 3, 1, CD_FLOAT64);
            double depth[CELLS], velocity[CELLS + 1];
            basin_set_way(w, &ways[ADVECTED]);
            ok(cd_water_set_lambda(w, lambda));
            ok(cd_water_set_side(w, line_side(along_y, last), CD_BORDER_LEVEL, 1, 0));
            ok(cd_water_set_side(w, line_side(along_y, !last), CD_BORDER_LEVEL, 1 - fall, 0));
            for (size_t i = 0; i < CELLS; ++i) depth[i] = 1 - fall;
            line_write(w, along_y, CD_DEPTH, depth);
            basin_step(w, courant / sqrt(9.81), (size_t)(40 * CELLS / speed / courant * sqrt(9.81)));
            line_read(w, along_y, CD_VELOCITY_X, 1e-9, velocity);
            for (size_t i = 0; i <= CELLS; ++i)
                if (!(fabs(velocity[i] * (last ? -1 : 1) / speed - 1) <= 1e-6))
                    fail_msg("side %d, fall %g, courant %g, lambda %g, face %zu: %.9g m/s, not %.9g", side, fall,
                             courant, lambda, i, velocity[i], speed);
            cd_water_destroy(w);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stream_that_goes_round_keeps_its_momentum),
        cmocka_unit_test(a_uniform_stream_stays_uniform),
        cmocka_unit_test(whirls_stay_bounded),
        cmocka_unit_test(a_swift_stream_stays_smooth),
        cmocka_unit_test(a_stream_round_a_ring_stays_smooth_at_any_speed),
        cmocka_unit_test(walls_and_masks_hold_water_exactly),
        cmocka_unit_test(a_canal_between_two_lakes_runs_by_their_levels),
        cmocka_unit_test(a_ring_of_one_row_goes_as_one_of_two),
    };
    return cmocka_run_group_tests_name("water momentum", tests, NULL, NULL);
}
