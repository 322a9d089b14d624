/* What a step computes follows from an object's settings and state alone: not from what it was before, nor from steps
 * that went wrong. An object with a past and a new one with the same settings and state step to the same bits. */
#include <math.h>

#include "check.h"
#include "cloth.h"
#include "kernels.h"
#include "scene.h"
#include "sheet.h"

enum { COLUMNS = 9, ROWS = 6, MOST = COLUMNS * ROWS };

typedef void change(cd_membrane* m);
static void nothing(cd_membrane* m) { (void)m; }
static void tube(cd_membrane* m) { ok(cd_membrane_set_ring(m, 1, 0)); }
static void torus(cd_membrane* m) { ok(cd_membrane_set_ring(m, 1, 1)); }
static void coupled(cd_membrane* m) { ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED)); }
static void plate(cd_membrane* m) { ok(cd_membrane_set_bend(m, 0.3)); }
static void stiff_second(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_STIFF_SECOND)); }
static void explicit_steps(cd_membrane* m) { ok(cd_membrane_set_method(m, CD_METHOD_SYMPLECTIC_EULER)); }
static void edge(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_V_LAST, CD_NODE_PINNED)); }
static void masses(cd_membrane* m) { ok(cd_membrane_enable_field(m, CD_MASS)); }
static void springs(cd_membrane* m) { ok(cd_membrane_enable_field(m, CD_STIFFNESS_V)); }
static void pins(cd_membrane* m) {
    const double pinned = CD_NODE_PINNED;
    ok(cd_membrane_enable_field(m, CD_PIN));
    ok(cd_membrane_write_f64(m, CD_PIN, 3, 2, 1, 1, &pinned, 1));
}
static void hole(cd_membrane* m) {
    const double absent = 0;
    ok(cd_membrane_enable_field(m, CD_MASK));
    ok(cd_membrane_write_f64(m, CD_MASK, 4, 4, 1, 1, &absent, 1));
}
static void strips(cd_membrane* m) { ok(cd_membrane_set_stiffness(m, 2, 0)); }
static change* const changes[] = {nothing, tube,   torus,   coupled, plate, stiff_second, explicit_steps,
                                  edge,    masses, springs, pins,    hole,  strips};

static cd_membrane* wild_sheet(size_t columns, size_t rows) {
    cd_membrane* m;
    double x[MOST];
    uint64_t seed = 3;
    for (size_t i = 0; i < MOST; ++i) x[i] = scene_noise(&seed);
    ok(cd_membrane_create(columns - 1, rows - 1, 1, CD_FLOAT64, NULL, &m));
    ok(cd_membrane_set_solver(m, CD_SOLVER_ALTERNATING));
    ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, columns, rows, x, columns * rows));
    return m;
}

/* Two changes one after the other, a step before, between and after them; and a copy made before the last step. */
static void a_sheet_steps_as_its_fresh_copy_does(void** state) {
    (void)state;
    static const size_t sizes[][2] = {{COLUMNS, ROWS}, {3, 3}};
    for (size_t s = 0; s < COUNT(sizes); ++s)
        for (size_t first = 0; first < COUNT(changes); ++first)
            for (size_t second = 0; second < COUNT(changes); ++second) {
                if (s > 0 && (changes[first] == pins || changes[second] == pins || changes[first] == hole ||
                              changes[second] == hole))
                    continue; /* of nodes that a small sheet has not */
                cd_membrane *m = wild_sheet(sizes[s][0], sizes[s][1]), *fresh = wild_sheet(sizes[s][0], sizes[s][1]);
                ok(cd_membrane_step(m, 10, 1));
                changes[first](m);
                ok(cd_membrane_step(m, 0.01, 1));
                changes[second](m);
                ok(cd_membrane_copy_state(fresh, m));
                const cd_status with_a_past = cd_membrane_step(m, 0.01, 2), new = cd_membrane_step(fresh, 0.01, 2);
                if (with_a_past != new || hash_of(m) != hash_of(fresh))
                    fail_msg("%zu nodes a row, change %zu and then %zu: another step than a fresh copy's", sizes[s][0],
                             first, second);
                cd_membrane_destroy(m);
                cd_membrane_destroy(fresh);
            }
}

/* Left to the library, the solver changes with dt alone. */
static void a_sheet_of_another_dt_steps_as_its_fresh_copy_does(void** state) {
    (void)state;
    static const double dts[] = {0.01, 20, 1, 0.02, 300};
    for (size_t first = 0; first < COUNT(changes); ++first)
        for (size_t second = 0; second < COUNT(changes); ++second) {
            cd_membrane *m = wild_sheet(COLUMNS, ROWS), *fresh = NULL;
            changes[first](m), changes[second](m);
            ok(cd_membrane_set_solver(m, CD_SOLVER_AUTO));
            for (size_t k = 0; k < COUNT(dts); ++k) {
                fresh = wild_sheet(COLUMNS, ROWS);
                ok(cd_membrane_copy_state(fresh, m));
                assert_int_equal(cd_membrane_step(m, dts[k], 2), cd_membrane_step(fresh, dts[k], 2));
                assert_int_equal(hash_of(m), hash_of(fresh));
                cd_membrane_destroy(fresh);
            }
            cd_membrane_destroy(m);
        }
}

static void a_diverged_sheet_leaves_no_trace_after_a_reset(void** state) {
    (void)state;
    const double far = 1e308, gravity = -9;
    size_t diverged = 0;
    for (cd_method before = CD_METHOD_IMPLICIT; before <= CD_METHOD_STIFF_SECOND; ++before)
        for (cd_method after = CD_METHOD_IMPLICIT; after <= CD_METHOD_STIFF_SECOND; ++after)
            for (cd_solver solver = CD_SOLVER_ALTERNATING; solver <= CD_SOLVER_COUPLED; ++solver) {
                cd_membrane *m = wild_sheet(COLUMNS, ROWS), *fresh = wild_sheet(COLUMNS, ROWS);
                ok(cd_membrane_set_method(m, before));
                ok(cd_membrane_set_solver(m, CD_SOLVER_COUPLED - solver));
                ok(cd_membrane_write_f64(m, CD_POSITION, 0, 0, 1, 1, &far, 1));
                int lost = 0;
                for (int i = 0; i < 6 && !lost; ++i) lost = cd_membrane_step(m, 1e30, 8) == CD_ERROR_DIVERGED;
                diverged += (size_t)lost;
                ok(cd_membrane_reset(m));
                ok(cd_membrane_reset(fresh));
                for (int k = 0; k < 2; ++k) {
                    ok(cd_membrane_set_method(k ? fresh : m, after));
                    ok(cd_membrane_set_solver(k ? fresh : m, solver));
                    ok(cd_membrane_set_gravity(k ? fresh : m, &gravity, 1));
                    ok(cd_membrane_step(k ? fresh : m, 1e-3, 3));
                }
                assert_int_equal(hash_of(m), hash_of(fresh));
                cd_membrane_destroy(m);
                cd_membrane_destroy(fresh);
            }
    assert_true(diverged >= 16);
}

/* The same of ropes: what they are begun with is a tension, which is state, and nothing that a step left behind. */
static void lengths(cd_chain* c) { ok(cd_chain_set_rest_length(c, 1.5)); }
static void short_lengths(cd_chain* c) { ok(cd_chain_set_rest_length(c, 0.25)); }
static void no_lengths(cd_chain* c) { ok(cd_chain_set_rest_length(c, 0)); }
static void pushing(cd_chain* c) { ok(cd_chain_set_push(c, 1)); }
static void rigid(cd_chain* c) {
    double length;
    ok(cd_chain_get_rest_length(c, &length));
    if (length > 0) ok(cd_chain_set_stiffness(c, INFINITY));
}
static void welds(cd_chain* c) {
    for (size_t strand = 0; strand < scene_own_strands(c); ++strand) ok(cd_chain_weld(c, strand, 3));
}
static void cuts(cd_chain* c) {
    for (size_t strand = 0; strand < scene_own_strands(c); ++strand) ok(cd_chain_cut(c, strand, 2));
}
static void tolerant(cd_chain* c) { ok(cd_chain_set_tolerance(c, 1e-2, 2)); }
static void own_masses(cd_chain* c) { ok(cd_chain_enable_field(c, CD_MASS)); }
static void own_lengths(cd_chain* c) {
    double length;
    ok(cd_chain_get_rest_length(c, &length));
    if (length == 0) return;
    ok(cd_chain_enable_field(c, CD_REST_LENGTH));
    scene_set(c, CD_REST_LENGTH, 4, 0.5);
}
static void windy(cd_chain* c) {
    const double wind[3] = {1, 2, 3};
    double length;
    ok(cd_chain_get_rest_length(c, &length));
    if (length == 0) return;
    ok(cd_chain_set_air(c, 0.1, 1));
    ok(cd_chain_set_wind(c, wind, 3));
}
static void meeting(cd_chain* c) {
    const double low[3] = {0.1, 0.2, -0.1}, up[3] = {0.5, 1, 0.25}, ball[3] = {0.5, 0.05, 0}, slow[3] = {0.25, 0, 0};
    double length;
    ok(cd_chain_get_rest_length(c, &length));
    if (length == 0) return;
    ok(cd_chain_set_thickness(c, 0.01));
    ok(cd_chain_set_colliders(c, 3));
    ok(cd_chain_set_plane(c, 0, low, up, 3, 0.5));
    ok(cd_chain_set_capsule(c, 2, ball, ball, 3, 0.1, 0.25));
    ok(cd_chain_set_collider_velocity(c, 2, slow, 3));
}
static void not_meeting(cd_chain* c) {
    double length;
    ok(cd_chain_get_rest_length(c, &length));
    if (length > 0) ok(cd_chain_set_colliders(c, 1));
}
static void pinned(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED)); }
static void tied(cd_chain* c) {
    for (size_t strand = 0; strand < scene_own_strands(c); ++strand) ok(cd_chain_attach(c, strand, 5, 30, 1, NULL, 0));
}
static void less_implicit(cd_chain* c) { ok(cd_chain_set_lambda(c, 0.75)); }
static void (*const chain_changes[])(cd_chain* c) = {
    lengths,    short_lengths, no_lengths, pushing, rigid,         welds, cuts,    tolerant,
    own_masses, own_lengths,   pinned,     tied,    less_implicit, windy, meeting, not_meeting};

/* A rope unless a change makes it none. */
static cd_chain* strands(size_t count) {
    cd_chain* c = scene_chain(count, 9, 3, CD_FLOAT64);
    ok(cd_chain_set_rest_length(c, 0.9));
    scene_lay_out(c, 0.1);
    scene_shake(c, 0.05, 3);
    return c;
}

static cd_status step(cd_chain* c, double dt, size_t count) {
    const cd_status status = cd_chain_step(c, dt, count);
    if (status != CD_ERROR_TOLERANCE) ok(status);
    return status;
}

static void a_rope_steps_as_its_fresh_copy_does(void** state) {
    (void)state;
    static const size_t counts[] = {1, 11};
    for (size_t s = 0; s < COUNT(counts); ++s)
        for (size_t first = 0; first < COUNT(chain_changes); ++first)
            for (size_t second = 0; second < COUNT(chain_changes); ++second) {
                cd_chain *c = strands(counts[s]), *fresh = scene_chain(counts[s], 9, 3, CD_FLOAT64);
                step(c, 10, 1);
                chain_changes[first](c);
                step(c, 0.01, 1);
                if (chain_changes[first] == rigid && chain_changes[second] == no_lengths)
                    ok(cd_chain_set_stiffness(c, 1)); /* or it stays a rope */
                chain_changes[second](c);
                ok(cd_chain_copy_state(fresh, c));
                const cd_status with_a_past = step(c, 0.01, 2), new = step(fresh, 0.01, 2);
                if (with_a_past != new || hash_of(c) != hash_of(fresh))
                    fail_msg("%zu strands, change %zu and then %zu: another step than a fresh copy's", counts[s], first,
                             second);
                cd_chain_destroy(c);
                cd_chain_destroy(fresh);
            }
}

/* And of cloth. */
static void shorter(cd_membrane* m) { ok(cd_membrane_set_rest_length(m, 0.7, 0.45)); }
static void no_cloth(cd_membrane* m) { ok(cd_membrane_set_rest_length(m, 0, 0)); }
static int is_cloth(const cd_membrane* m) {
    double length[2];
    ok(cd_membrane_get_rest_length(m, &length[0], &length[1]));
    return length[0] > 0;
}
static void own_cloth_lengths(cd_membrane* m) {
    if (!is_cloth(m)) return;
    ok(cd_membrane_enable_field(m, CD_REST_LENGTH_U));
    sheet_set(m, CD_REST_LENGTH_U, 3, 2, 0.0625);
}
static void sheared(cd_membrane* m) {
    if (is_cloth(m)) ok(cd_membrane_set_shear(m, 70));
}
static void uncrumpled(cd_membrane* m) {
    if (is_cloth(m)) ok(cd_membrane_set_compression(m, 300));
}
static void torn(cd_membrane* m) {
    if (is_cloth(m)) ok(cd_membrane_set_breaking_strain(m, 0.05));
}
static void seamed(cd_membrane* m) {
    if (!is_cloth(m)) return;
    ok(cd_membrane_enable_field(m, CD_BREAKING_STRAIN_V));
    sheet_set(m, CD_BREAKING_STRAIN_V, 3, 2, 1e-3);
}
static void laboured(cd_membrane* m) {
    if (is_cloth(m)) ok(cd_membrane_set_effort(m, 5, 40));
}
static void blown_at(cd_membrane* m) {
    const double wind[3] = {1, 2, 3};
    if (is_cloth(m)) ok(cd_membrane_set_air(m, 0.125, 1));
    if (is_cloth(m)) ok(cd_membrane_set_wind(m, wind, 3));
}
static void surrounded(cd_membrane* m) {
    if (is_cloth(m)) cloth_meet(m);
}
static void alone(cd_membrane* m) {
    if (is_cloth(m)) ok(cd_membrane_set_colliders(m, 0));
}
static void slower(cd_membrane* m) { ok(cd_membrane_set_lambda(m, 0.75)); }
static void posed(cd_membrane* m) { ok(cd_membrane_set_edge(m, CD_EDGE_U_LAST, CD_NODE_POSED)); }
static void tied_down(cd_membrane* m) { ok(cd_membrane_attach(m, 4, 2, 30, 1, NULL, 3)); }
static void blown_up(cd_membrane* m) { ok(cd_membrane_set_pressure(m, 0.5)); }
static change* const cloth_changes[] = {torn,    seamed,     nothing,   shorter,  no_cloth,   own_cloth_lengths,
                                        sheared, uncrumpled, laboured,  blown_at, surrounded, alone,
                                        slower,  posed,      tied_down, blown_up, plate,      tube,
                                        torus,   masses,     springs,   pins,     hole};

static cd_membrane* flat_cloth(void) {
    cd_membrane* m = cloth(COLUMNS - 1, ROWS - 1, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 0.8, 0.5));
    ok(cd_membrane_set_stiffness(m, 300, 200));
    cloth_lay_out(m, 0.1);
    cloth_shake(m, 0.05, 3);
    return m;
}

static void cloth_steps_as_its_fresh_copy_does(void** state) {
    (void)state;
    for (size_t first = 0; first < COUNT(cloth_changes); ++first)
        for (size_t second = 0; second < COUNT(cloth_changes); ++second) {
            cd_membrane *m = flat_cloth(), *fresh = cloth(COLUMNS - 1, ROWS - 1, 3, CD_FLOAT64);
            ok(cd_membrane_step(m, 10, 1));
            cloth_changes[first](m);
            ok(cd_membrane_step(m, 0.01, 1));
            cloth_changes[second](m);
            ok(cd_membrane_copy_state(fresh, m));
            ok(cd_membrane_step(m, 0.01, 2));
            ok(cd_membrane_step(fresh, 0.01, 2));
            if (hash_of(m) != hash_of(fresh))
                fail_msg("change %zu and then %zu: another step than a fresh copy's", first, second);
            cd_membrane_destroy(m);
            cd_membrane_destroy(fresh);
        }
}

/* Cloth so far away that differences from a zero beside it leave the range, though its steps do not: brought back, and
 * with other kernels, it steps as a copy that has never been there. */
static void cloth_that_was_far_away_steps_as_its_fresh_copy_does(void** state) {
    (void)state;
    static const size_t sizes[][2] = {{1, 1}, {1, 4}, {4, 1}, {6, 5}};
    static const double distances[] = {1e154, 1e250, 1e308};
    for (size_t s = 0; s < COUNT(sizes); ++s)
        for (size_t d = 0; d < COUNT(distances); ++d) FOR_RUNNABLE(there) FOR_RUNNABLE(back) {
                const double offset[3] = {0, distances[d], 1};
                cd_membrane *m = cloth(sizes[s][0], sizes[s][1], 3, CD_FLOAT64),
                            *fresh = cloth(sizes[s][0], sizes[s][1], 3, CD_FLOAT64);
                ok(cd_membrane_set_kernels(m, there));
                ok(cd_membrane_set_rest_length(m, 2.5, 1000));
                ok(cd_membrane_teleport(m, NULL, offset, 3));
                ok(cd_membrane_step(m, 4e23, 2));
                ok(cd_membrane_set_kernels(m, back));
                ok(cd_membrane_set_kernels(fresh, back));
                cloth_lay_out(m, 0.1);
                cloth_shake(m, 0.05, 3);
                ok(cd_membrane_copy_state(fresh, m));
                ok(cd_membrane_step(m, 0.005, 1));
                ok(cd_membrane_step(fresh, 0.005, 1));
                assert_int_equal(hash_of(m), hash_of(fresh));
                cd_membrane_destroy(m);
                cd_membrane_destroy(fresh);
            }
}

/* The same of sheets of springs and of strands, with and without lengths. What diverges there may do so again, where a
 * tie has gone with it. */
static void sheets_and_strands_that_were_far_away_step_as_their_fresh_copies_do(void** state) {
    (void)state;
    static const double distances[] = {1e154, 1e250, 1e308};
    for (size_t d = 0; d < COUNT(distances); ++d) FOR_RUNNABLE(there) FOR_RUNNABLE(back) {
            for (size_t change = 0; change < COUNT(changes); ++change) {
                cd_membrane *m = wild_sheet(COLUMNS, ROWS), *fresh = wild_sheet(COLUMNS, ROWS);
                changes[change](m);
                ok(cd_membrane_set_kernels(m, there));
                ok(cd_membrane_teleport(m, NULL, &distances[d], 1));
                cd_membrane_step(m, 4e23, 2);
                ok(cd_membrane_reset(m));
                ok(cd_membrane_set_kernels(m, back));
                ok(cd_membrane_set_kernels(fresh, back));
                cloth_lay_out(m, 0.1);
                cloth_shake(m, 0.05, 3);
                ok(cd_membrane_copy_state(fresh, m));
                ok(cd_membrane_step(m, 0.005, 2));
                ok(cd_membrane_step(fresh, 0.005, 2));
                assert_int_equal(hash_of(m), hash_of(fresh));
                cd_membrane_destroy(m);
                cd_membrane_destroy(fresh);
            }
            for (size_t change = 0; change < COUNT(chain_changes); ++change)
                for (size_t count = 1; count < 20; count += 9) {
                    const double offset[3] = {0, distances[d], 1};
                    cd_chain *c = strands(count), *fresh = scene_chain(count, 9, 3, CD_FLOAT64);
                    chain_changes[change](c);
                    ok(cd_chain_set_kernels(c, there));
                    for (size_t strand = 0; strand < scene_own_strands(c); ++strand)
                        ok(cd_chain_teleport(c, strand, NULL, offset, 3));
                    cd_chain_step(c, 4e23, 2);
                    ok(cd_chain_reset(c));
                    ok(cd_chain_set_kernels(c, back));
                    ok(cd_chain_set_kernels(fresh, back));
                    scene_lay_out(c, 0.1);
                    scene_shake(c, 0.05, 3);
                    ok(cd_chain_copy_state(fresh, c));
                    const cd_status with_a_past = cd_chain_step(c, 0.005, 2);
                    assert_int_equal(with_a_past, cd_chain_step(fresh, 0.005, 2));
                    assert_int_equal(hash_of(c), hash_of(fresh));
                    cd_chain_destroy(c);
                    cd_chain_destroy(fresh);
                }
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cloth_that_was_far_away_steps_as_its_fresh_copy_does),
        cmocka_unit_test(sheets_and_strands_that_were_far_away_step_as_their_fresh_copies_do),
        cmocka_unit_test(a_sheet_steps_as_its_fresh_copy_does),
        cmocka_unit_test(a_rope_steps_as_its_fresh_copy_does),
        cmocka_unit_test(cloth_steps_as_its_fresh_copy_does),
        cmocka_unit_test(a_sheet_of_another_dt_steps_as_its_fresh_copy_does),
        cmocka_unit_test(a_diverged_sheet_leaves_no_trace_after_a_reset),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
