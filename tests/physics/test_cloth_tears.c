/* Cloth that tears: at which strain, where, into how many pieces, and what it does to the energy. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"
#include "sheet.h"

enum { MOST = 1000 }; /* nodes */

static size_t torn_in(cd_membrane* m, double dt, size_t steps) {
    size_t torn = 99;
    ok(cd_membrane_step(m, dt, steps));
    ok(cd_membrane_get_broken(m, &torn));
    return torn;
}

/* The springs along one way of a sheet that is as good as without stiffness: number i of a line is strained by
 * strain[line * springs + i] at every step. */
static cd_membrane* strained(cd_precision precision, int along_v, size_t lines, size_t springs, const double* strain) {
    cd_membrane* m = along_v ? cloth(lines - 1, springs, 3, precision) : cloth(springs, lines - 1, 3, precision);
    if (along_v) ok(cd_membrane_set_rest_length(m, (double)(lines - 1), (double)springs));
    else ok(cd_membrane_set_rest_length(m, (double)springs, (double)(lines - 1)));
    ok(cd_membrane_set_stiffness(m, 1e-30, 1e-30));
    ok(cd_membrane_set_compression(m, 0));
    for (size_t line = 0; line < lines; ++line) {
        double x[3] = {0, 0, 0};
        for (size_t i = 0; i <= springs; ++i) {
            x[along_v ? 0 : 1] = (double)line;
            ok(cd_membrane_write_f64(m, CD_POSITION, along_v ? line : i, along_v ? i : line, 1, 1, x, 3));
            if (i < springs) x[along_v ? 1 : 0] += 1 + strain[line * springs + i];
        }
    }
    ok(cd_membrane_enable_field(m, along_v ? CD_BREAKING_STRAIN_V : CD_BREAKING_STRAIN_U));
    return m;
}
static void set_along(cd_membrane* m, int along_v, cd_field of_u, size_t line, size_t i, double value) {
    sheet_set(m, along_v ? of_u + 1 : of_u, along_v ? line : i, along_v ? i : line, value);
}
static void let_tear(cd_membrane* m, int along_v, double strain) {
    const cd_field field = along_v ? CD_BREAKING_STRAIN_V : CD_BREAKING_STRAIN_U;
    const struct cloth_extent all = cloth_extent(m, field);
    for (size_t v = 0; v < all.rows; ++v)
        for (size_t u = 0; u < all.columns; ++u) sheet_set(m, field, u, v, strain);
}
/* Cut springs are 'x' in a text of a line after the other. */
static void is_cut(const cd_membrane* m, int along_v, const char* wanted) {
    const cd_field field = along_v ? CD_STIFFNESS_V : CD_STIFFNESS_U;
    const struct cloth_extent all = cloth_extent(m, field);
    const size_t lines = along_v ? all.columns : all.rows, springs = along_v ? all.rows : all.columns;
    char shown[MOST] = "";
    size_t at = 0;
    for (size_t line = 0; line < lines; ++line) {
        if (line > 0) shown[at++] = ' ';
        for (size_t i = 0; i < springs; ++i)
            shown[at++] = sheet_get(m, field, along_v ? line : i, along_v ? i : line) == 0 ? 'x' : '-';
    }
    assert_string_equal(shown, wanted);
}

static const double uneven[3 * 4] = {0.05, 0.20, 0.05, 0.30, 0.05, 0.15, 0.40, 0.12, 0.00, 0.02, 0.11, 0.25};

/* The second line's worst comes first, and takes the third line's along, which is beyond there too if not the most. */
static void each_line_tears_in_one_place_of_a_step(void** state) {
    (void)state;
    for (int k = 0; k < 4; ++k) {
        const cd_precision precision = k / 2 ? CD_FLOAT64 : CD_FLOAT32;
        cd_membrane *m = strained(precision, k % 2, 3, 4, uneven), *at_once = strained(precision, k % 2, 3, 4, uneven);
        size_t torn;
        let_tear(m, k % 2, 0.1);
        assert_int_equal(torn_in(m, 1e-3, 1), 3);
        is_cut(m, k % 2, "---x --x- --x-");
        assert_int_equal(torn_in(m, 1e-3, 1), 3); /* and the last spring of the first line is gone */
        is_cut(m, k % 2, "-x-x --xx --xx");
        assert_int_equal(torn_in(m, 1e-3, 1), 1);
        is_cut(m, k % 2, "-x-x -xxx --xx");
        ok(cd_membrane_step(m, 1e-3, 0)); /* makes none */
        ok(cd_membrane_get_broken(m, &torn));
        assert_int_equal(torn, 1);
        assert_int_equal(torn_in(m, 1e-3, 3), 0);

        let_tear(at_once, k % 2, 0.1);
        assert_int_equal(torn_in(at_once, 1e-3, 6), 7);
        assert_int_equal(hash_of(at_once), hash_of(m));

        ok(cd_membrane_set_stiffness(m, 2e-30, 3e-30)); /* mends all, and they tear again */
        is_cut(m, k % 2, "---- ---- ----");
        assert_int_equal(torn_in(m, 1e-3, 6), 7);
        is_cut(m, k % 2, "-x-x -xxx --xx");
        cd_membrane_destroy(m);
        cd_membrane_destroy(at_once);
    }
}

/* It is multiples of the breaking strain that count; a spring that is cut, or has no node at one end, bears nothing. */
static void what_is_cut_or_absent_does_not_tear(void** state) {
    (void)state;
    static const double strain[2 * 3] = {0.2, 0.5, 0.9, 0.8, 0.2, 0.3};
    for (int along_v = 0; along_v < 2; ++along_v) {
        cd_membrane* m = strained(CD_FLOAT64, along_v, 2, 3, strain);
        let_tear(m, along_v, 0.25);
        set_along(m, along_v, CD_BREAKING_STRAIN_U, 0, 0, 0.05); /* 4 times: more than 0.9 of 0.25 */
        set_along(m, along_v, CD_BREAKING_STRAIN_U, 0, 2, INFINITY);
        set_along(m, along_v, CD_STIFFNESS_U, 1, 0, 0);
        assert_int_equal(torn_in(m, 1e-3, 1), 2);
        is_cut(m, along_v, "x-- x-x");
        ok(cd_membrane_enable_field(m, CD_MASK));
        sheet_set(m, CD_MASK, along_v ? 0 : 1, along_v ? 1 : 0, 0); /* an end of the spring of 0.5 */
        assert_int_equal(torn_in(m, 1e-3, 1), 0);
        sheet_set(m, CD_MASK, along_v ? 0 : 1, along_v ? 1 : 0, 1);
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
            ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED)); /* held nodes are torn apart too */
        assert_int_equal(torn_in(m, 1e-3, 1), 1);
        is_cut(m, along_v, "xx- x-x");
        cd_membrane_destroy(m);
    }
}

/* A tear runs round a tube, from the last line to the first. */
static void a_tear_runs_on_round_a_ring(void** state) {
    (void)state;
    static const double strain[4 * 3] = {0, 0.5, 0.2, 0, 0.2, 0.3, 0.3, 0, 0.1, 0.1, 0.2, 0.4};
    for (int k = 0; k < 4; ++k) {
        const int along_v = k % 2, ring = k / 2;
        cd_membrane* m = strained(CD_FLOAT64, along_v, 4, 3, strain);
        ok(cd_membrane_set_ring(m, ring && along_v, ring && !along_v));
        let_tear(m, along_v, 0.15);
        assert_int_equal(torn_in(m, 1e-3, 1), 4);
        is_cut(m, along_v, ring ? "-x- -x- x-- -x-" : "-x- -x- x-- --x");
        cd_membrane_destroy(m);
    }
}

/* ---- what hangs and what is pulled ------------------------------------------------------------------------------- */

/* Along one way it is `springs` springs of 0.05 m, across it as many as `across`; the first edge is pinned. */
static cd_membrane* hung(int along_v, size_t across, size_t springs, double stiffness) {
    cd_membrane* m = along_v ? cloth(across, springs, 3, CD_FLOAT64) : cloth(springs, across, 3, CD_FLOAT64);
    const struct cloth_extent all = cloth_extent(m, CD_POSITION);
    ok(cd_membrane_set_rest_length(m, 0.05 * (double)(all.columns - 1), 0.05 * (double)(all.rows - 1)));
    ok(cd_membrane_set_stiffness(m, stiffness, stiffness));
    for (size_t v = 0; v < all.rows; ++v)
        for (size_t u = 0; u < all.columns; ++u) {
            const double x[3] = {0.05 * (double)u, 0, -0.05 * (double)v};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    ok(cd_membrane_set_edge(m, along_v ? CD_EDGE_V_FIRST : CD_EDGE_U_FIRST, CD_NODE_PINNED));
    return m;
}

static void assert_cut_across(const cd_membrane* m, int along_v, size_t where) {
    for (cd_field field = CD_STIFFNESS_U; field <= CD_STIFFNESS_V; ++field) {
        const struct cloth_extent all = cloth_extent(m, field);
        for (size_t v = 0; v < all.rows; ++v)
            for (size_t u = 0; u < all.columns; ++u)
                assert_true((sheet_get(m, field, u, v) == 0) ==
                            ((field == CD_STIFFNESS_V) == along_v && (along_v ? v : u) == where));
    }
}

/* Below the first springs hangs m g of the strip, and a load at its end: T = k_i (strain - 0.003) L. */
static void a_strip_bears_its_breaking_strain_and_no_more(void** state) {
    (void)state;
    enum { ACROSS = 4, SPRINGS = 8, LINES = ACROSS + 1 };
    for (int along_v = 0; along_v < 2; ++along_v) {
        const double k = 2000, load = 3, g = 10, each = 1.0 / (LINES * (SPRINGS + 1));
        const double gravity[3] = {along_v ? 0 : g, 0, along_v ? -g : 0};
        const double tension = g * (each * SPRINGS + load / LINES), of_spring = k * SPRINGS / LINES;
        const double strain = 0.003 + tension / (of_spring * 0.05);
        cd_membrane* holds = hung(along_v, ACROSS, SPRINGS, k);
        ok(cd_membrane_set_gravity(holds, gravity, 3));
        ok(cd_membrane_set_compression(holds, 0));
        ok(cd_membrane_set_drag(holds, 3));
        ok(cd_membrane_set_effort(holds, 20, 200));
        ok(cd_membrane_enable_field(holds, CD_MASS));
        for (size_t line = 0; line < LINES; ++line)
            sheet_set(holds, CD_MASS, along_v ? line : SPRINGS, along_v ? SPRINGS : line, each + load / LINES);
        ok(cd_membrane_step(holds, 0.02, 1000));
        assert_near(sheet_get(holds, along_v ? CD_STRAIN_V : CD_STRAIN_U, 0, 0), strain, 1e-6, 0);
        cd_membrane* tears = cloth(along_v ? ACROSS : SPRINGS, along_v ? SPRINGS : ACROSS, 3, CD_FLOAT64);
        ok(cd_membrane_copy_state(tears, holds));
        ok(cd_membrane_set_breaking_strain(holds, strain * (1 + 1e-5)));
        ok(cd_membrane_set_breaking_strain(tears, strain * (1 - 1e-5)));
        assert_int_equal(torn_in(holds, 0.02, 100), 0);
        assert_int_equal(torn_in(tears, 0.02, 1), LINES); /* all at once, as all bear the same */
        assert_int_equal(torn_in(tears, 0.02, 100), 0);
        assert_cut_across(tears, along_v, 0);
        cd_membrane_destroy(holds);
        cd_membrane_destroy(tears);
    }
}

/* A sheet of 30 springs along the way, 21 side by side, whose last edge is drawn away at a speed. */
enum { ACROSS = 20, SPRINGS = 30, LEAST = ACROSS + 1 };
static cd_membrane* drawn(int along_v, double stiffness, double shear, double speed) {
    cd_membrane* m = hung(along_v, ACROSS, SPRINGS, stiffness);
    const double v[3] = {along_v ? 0 : speed, 0, along_v ? -speed : 0};
    ok(cd_membrane_set_shear(m, shear));
    ok(cd_membrane_set_edge(m, along_v ? CD_EDGE_V_LAST : CD_EDGE_U_LAST, CD_NODE_DRIVEN));
    for (size_t line = 0; line <= ACROSS; ++line)
        ok(cd_membrane_write_f64(m, CD_VELOCITY, along_v ? line : SPRINGS, along_v ? SPRINGS : line, 1, 1, v, 3));
    ok(cd_membrane_set_breaking_strain(m, 0.1));
    return m;
}

/* How many pieces the springs that are left hold together, and how many nodes the second largest one has. */
static size_t pieces_of(const cd_membrane* m, size_t* out_second) {
    const struct cloth_extent all = cloth_extent(m, CD_MASS);
    size_t piece[MOST], size[MOST] = {0}, pieces = 0, largest = 0;
    for (size_t i = 0; i < all.count; ++i) piece[i] = i;
    for (int changed = 1; changed;) {
        changed = 0;
        for (size_t i = 0; i < all.count; ++i)
            for (cd_field field = CD_STIFFNESS_U; field <= CD_STIFFNESS_V; ++field) {
                const size_t u = i % all.columns, v = i / all.columns;
                const size_t next = field == CD_STIFFNESS_U ? i + 1 : i + all.columns;
                if (field == CD_STIFFNESS_U ? u + 1 == all.columns : v + 1 == all.rows) continue;
                if (piece[i] == piece[next] || sheet_get(m, field, u, v) == 0) continue;
                piece[i] = piece[next] = piece[i] < piece[next] ? piece[i] : piece[next];
                changed = 1;
            }
    }
    *out_second = 0;
    for (size_t i = 0; i < all.count; ++i) ++size[piece[i]];
    for (size_t i = 0; i < all.count; ++i) {
        pieces += size[i] > 0;
        if (size[i] > largest) *out_second = largest, largest = size[i];
        else if (size[i] > *out_second) *out_second = size[i];
    }
    return pieces;
}

static void a_seam_parts_along_itself(void** state) {
    (void)state;
    for (int k = 0; k < 4; ++k) {
        const int along_v = k % 2;
        const double speed = k / 2 ? 5 : 0.3;
        cd_membrane* m = drawn(along_v, 2000, 100, speed);
        const cd_field field = along_v ? CD_BREAKING_STRAIN_V : CD_BREAKING_STRAIN_U;
        ok(cd_membrane_enable_field(m, field));
        for (size_t line = 0; line <= ACROSS; ++line)
            sheet_set(m, field, along_v ? line : 11, along_v ? 11 : line, 0.04);
        size_t torn = 0, second;
        for (int step = 0; step < 60; ++step) torn += torn_in(m, 1.0 / 60, 1);
        assert_int_equal(torn, LEAST);
        assert_cut_across(m, along_v, 11);
        assert_int_equal(pieces_of(m, &second), 2);
        assert_int_equal(second, 12 * LEAST);
        cd_membrane_destroy(m);
    }
}

/* It bears the same all over, but for noise, and would fall to dust if all that is beyond its strain tore at once. */
static void a_jerked_sheet_parts_without_falling_to_pieces(void** state) {
    (void)state;
    for (uint64_t number = 0; number < 16; ++number) {
        uint64_t seed = 1 + number;
        const int along_v = number % 2;
        cd_membrane* m = drawn(along_v, 2000, number % 4 < 2 ? 0 : 1000, 5);
        const cd_field field = along_v ? CD_BREAKING_STRAIN_V : CD_BREAKING_STRAIN_U;
        const struct cloth_extent all = cloth_extent(m, field);
        ok(cd_membrane_enable_field(m, field));
        for (size_t v = 0; v < all.rows; ++v)
            for (size_t u = 0; u < all.columns; ++u) sheet_set(m, field, u, v, 0.1 * (1 + 0.1 * random_number(&seed)));
        size_t second, torn = 0;
        for (int step = 0; step < 30; ++step) torn += torn_in(m, 1.0 / 60, 1);
        const size_t pieces = pieces_of(m, &second);
        print_message("[   INFO   ] sheet %d: %zu springs of %d, %zu pieces\n", (int)number, torn, LEAST, pieces);
        assert_in_range(torn, LEAST, 4 * LEAST);
        assert_in_range(pieces, 2, 5);
        cd_membrane_destroy(m);
    }
}

/* From a cut of a fifth of its width a sheet that is drawn apart slowly tears across, and nowhere else. */
static void a_notched_sheet_tears_across_from_its_notch(void** state) {
    (void)state;
    for (int along_v = 0; along_v < 2; ++along_v) {
        cd_membrane* m = drawn(along_v, 2000, 1000, 0.1);
        for (size_t line = 0; line < 4; ++line) set_along(m, along_v, CD_STIFFNESS_U, line, 15, 0);
        size_t second, torn = 0, tip = 4;
        for (int step = 0; step < 300; ++step) {
            const size_t now = torn_in(m, 1.0 / 60, 1);
            torn += now;
            if (tip >= 8 || now == 0) continue; /* at first spring by spring, the one at the tip */
            assert_int_equal(now, 1);
            assert_true(
                sheet_get(m, along_v ? CD_STIFFNESS_V : CD_STIFFNESS_U, along_v ? tip : 15, along_v ? 15 : tip) == 0);
            ++tip;
        }
        assert_int_equal(torn, LEAST - 4);
        assert_int_equal(pieces_of(m, &second), 2);
        assert_true(second > 13 * LEAST);
        cd_membrane_destroy(m);
    }
}

/* A ball goes through a sheet that is held all round. */
static void a_ball_goes_through_what_tears(void** state) {
    (void)state;
    for (int tears = 0; tears < 2; ++tears) {
        cd_membrane* m = hung(0, 24, 24, 500);
        const double ball[3] = {0.6, 0.5, -0.6}, way[3] = {0, -5, 0};
        for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
            ok(cd_membrane_set_edge(m, edge, CD_NODE_PINNED));
        ok(cd_membrane_set_shear(m, 200));
        ok(cd_membrane_set_colliders(m, 1));
        ok(cd_membrane_set_capsule(m, 0, ball, ball, 3, 0.15, 0.3));
        ok(cd_membrane_set_collider_velocity(m, 0, way, 3));
        if (tears) ok(cd_membrane_set_breaking_strain(m, 0.3));
        size_t torn = 0, second;
        double deepest = 0, y[3 * MOST];
        for (int step = 0; step < 60; ++step) torn += torn_in(m, 1.0 / 120, 1);
        assert_true((torn > 0) == tears);
        ok(cd_membrane_step(m, 1.0 / 120, 60)); /* by now the ball is 4.5 m away */
        cloth_read(m, CD_POSITION, y);
        for (size_t i = 0; i < 25 * 25; ++i) deepest = fmin(deepest, y[3 * i + 1]);
        if (!tears) assert_true(deepest < -4);
        else assert_in_range(torn, 10, 100), assert_in_range(pieces_of(m, &second), 1, 5), assert_true(second < 50);
        cd_membrane_destroy(m);
    }
}

/* ---- what is torn open ------------------------------------------------------------------------------------------- */

/* A curved sheet whose rows from `first` on are those of the whole one: 1 / 8 kg for each of its nodes. */
enum { WIDE = 80, HIGH = 5, TORN = 2 };
static cd_membrane* curved(cd_precision precision, size_t first, size_t rows) {
    cd_membrane* m = cloth(WIDE, rows - 1, 3, precision);
    const double wind[3] = {1, 2, -3};
    ok(cd_membrane_set_rest_length(m, 0.1 * WIDE, 0.1 * (double)(rows - 1)));
    ok(cd_membrane_set_mass(m, (WIDE + 1) * (double)rows / 8));
    ok(cd_membrane_set_stiffness(m, 10 * (double)rows, 10 * (WIDE + 1) / (double)(rows - 1)));
    ok(cd_membrane_set_compression(m, 0));
    ok(cd_membrane_set_pressure(m, 20));
    ok(cd_membrane_set_air(m, 0.5, 5));
    ok(cd_membrane_set_wind(m, wind, 3));
    ok(cd_membrane_set_effort(m, 50, 1000));
    for (size_t v = 0; v < rows; ++v)
        for (size_t u = 0; u <= WIDE; ++u) {
            const double at = (double)(first + v);
            const double x[3] = {0.1 * (double)u, 0.1 * at, sin(0.2 * (double)u) + 0.1 * at * at * at};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}

/* A sheet torn across is two sheets, to pressure, air, volume and normals. */
static void what_is_torn_apart_is_two_sheets(void** state) {
    (void)state;
    static float shown[2][HIGH][WIDE + 1][6];
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane *m = curved(precision, 0, HIGH), *low = curved(precision, 0, TORN);
        cd_membrane* up = curved(precision, TORN, HIGH - TORN);
        ok(cd_membrane_enable_field(m, CD_STIFFNESS_V));
        for (size_t u = 0; u <= WIDE; ++u) sheet_set(m, CD_STIFFNESS_V, u, TORN - 1, 0);
        double volume[3];
        cd_membrane* const all[3] = {m, low, up};
        for (int k = 0; k < 3; ++k) ok(cd_membrane_get_volume(all[k], &volume[k]));
        assert_near(volume[0], volume[1] + volume[2], 1e-14, 10);
        ok(cd_membrane_write_vertices(m, shown[0], sizeof shown[0], 24, 0, 12));
        ok(cd_membrane_write_vertices(low, shown[1][0], TORN * sizeof shown[0][0], 24, 0, 12));
        ok(cd_membrane_write_vertices(up, shown[1][TORN], (HIGH - TORN) * sizeof shown[0][0], 24, 0, 12));
        assert_memory_equal(shown[0], shown[1], sizeof shown[0]);
        double largest = 0;
        for (int k = 0; k < 3; ++k) ok(cd_membrane_step(all[k], 0.02, 1));
        for (size_t v = 0; v < HIGH; ++v)
            for (size_t u = 0; u <= WIDE; ++u) {
                double one[3], other[3];
                ok(cd_membrane_read_f64(m, CD_VELOCITY, u, v, 1, 1, one, 3));
                ok(cd_membrane_read_f64(v < TORN ? low : up, CD_VELOCITY, u, v < TORN ? v : v - TORN, 1, 1, other, 3));
                for (int k = 0; k < 3; ++k) {
                    assert_near(one[k], other[k], 1e-6, 1);
                    largest = fmax(largest, fabs(one[k]));
                }
            }
        assert_true(largest > 0.1);
        for (int k = 0; k < 3; ++k) cd_membrane_destroy(all[k]);
    }
}

/* ---- energy ------------------------------------------------------------------------------------------------------ */

/* A step that tears leaves the nodes as one that does not, and no more energy. */
static void no_energy_comes_of_tearing(void** state) {
    (void)state;
    size_t all_torn = 0;
    for (uint64_t number = 0; number < 40; ++number) {
        uint64_t seed = 1 + number;
        cd_membrane *m = cloth(9, 7, 3, CD_FLOAT64), *holds = cloth(9, 7, 3, CD_FLOAT64);
        const double gravity[3] = {0, 0, -10};
        ok(cd_membrane_set_ring(m, number % 5 == 0, number % 7 == 0));
        cloth_lay_out(m, 0.1);
        cloth_shake(m, 0.05, seed);
        ok(cd_membrane_set_rest_length(m, 0.8, 0.65));
        ok(cd_membrane_set_stiffness(m, 300, 200));
        ok(cd_membrane_set_shear(m, number % 2 ? 100 : 0));
        ok(cd_membrane_set_bend(m, number % 3 ? 0.5 : 0));
        ok(cd_membrane_set_compression(m, 50));
        ok(cd_membrane_set_lambda(m, number % 4 ? 1 : 0.5));
        ok(cd_membrane_set_gravity(m, gravity, 3));
        ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, number % 2 ? CD_NODE_PINNED : CD_NODE_FREE));
        if (number % 3 == 0) ok(cd_membrane_set_air(m, 0.1, 2));
        double x[2][3 * 80], before = sheet_energy(m);
        ok(cd_membrane_set_breaking_strain(m, 0.3 + 0.2 * random_number(&seed)));
        for (int step = 0; step < 40; ++step) {
            ok(cd_membrane_copy_state(holds, m));
            ok(cd_membrane_set_breaking_strain(holds, INFINITY));
            ok(cd_membrane_step(holds, 1.0 / 60, 1));
            const size_t torn = torn_in(m, 1.0 / 60, 1);
            for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
                cloth_read(m, field, x[0]);
                cloth_read(holds, field, x[1]);
                assert_same_bits(x[0], x[1], 3 * 80);
            }
            const double now = sheet_energy(m), held = sheet_energy(holds);
            assert_true(torn > 0 ? now < held : now == held);
            if (!(now <= before + 1e-9)) fail_msg("sheet %d: from %.12g J to %.12g J", (int)number, before, now);
            before = now;
            all_torn += torn;
        }
        cd_membrane_destroy(m);
        cd_membrane_destroy(holds);
    }
    assert_true(all_torn > 500);
}

/* Strains that nothing reaches change no bit, and leave nothing behind. */
static void what_never_tears_is_as_without(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_membrane *m = cloth(9, 7, 3, precision), *never = cloth(9, 7, 3, precision);
        cloth_sail(m);
        cloth_sail(never);
        ok(cd_membrane_set_breaking_strain(m, 100));
        ok(cd_membrane_enable_field(m, CD_BREAKING_STRAIN_U));
        ok(cd_membrane_step(m, 0.01, 100));
        ok(cd_membrane_step(never, 0.01, 100));
        ok(cd_membrane_set_breaking_strain(m, INFINITY));
        for (cd_field field = CD_BREAKING_STRAIN_U; field <= CD_BREAKING_STRAIN_V; ++field)
            ok(cd_membrane_disable_field(m, field));
        for (cd_field field = CD_STIFFNESS_U; field <= CD_STIFFNESS_V; ++field) ok(cd_membrane_disable_field(m, field));
        assert_int_equal(hash_of(m), hash_of(never));
        cd_membrane_destroy(m);
        cd_membrane_destroy(never);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_line_tears_in_one_place_of_a_step),
        cmocka_unit_test(what_is_cut_or_absent_does_not_tear),
        cmocka_unit_test(a_tear_runs_on_round_a_ring),
        cmocka_unit_test(a_strip_bears_its_breaking_strain_and_no_more),
        cmocka_unit_test(a_seam_parts_along_itself),
        cmocka_unit_test(a_jerked_sheet_parts_without_falling_to_pieces),
        cmocka_unit_test(a_notched_sheet_tears_across_from_its_notch),
        cmocka_unit_test(a_ball_goes_through_what_tears),
        cmocka_unit_test(what_is_torn_apart_is_two_sheets),
        cmocka_unit_test(no_energy_comes_of_tearing),
        cmocka_unit_test(what_never_tears_is_as_without),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
