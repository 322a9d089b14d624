/* Ropes, chains and sheets that sleep: until then they are what they would be, then they stay as they are at no cost,
 * and what changes wakes them. */
#include "jobs.h"
#include "kernels.h"
#include "sleepers.h"

static double energy(const struct body* body, const any* x) {
    double kinetic, elastic, of_gravity;
    if (body->kind == CHAIN) ok(cd_chain_get_energy(x, &kinetic, &elastic, &of_gravity));
    else ok(cd_membrane_get_energy(x, &kinetic, &elastic, &of_gravity));
    return kinetic + elastic + of_gravity;
}

/* Bit by bit what never sleeps, until it does: then it is still, and stays where it is. */
static void what_rests_sleeps(void** state) {
    (void)state;
    FOR_BODIES(body, precision) {
        const struct kind* const kind = &kinds[body->kind];
        any *const x = body->make(precision), *const never = body->make(precision);
        double before[MOST], after[MOST], v[MOST];
        ok(set_sleep(body, x, speed, seconds));
        assert_int_equal(awake(body, x), body->parts * body->nodes);
        size_t steps = 0;
        for (; awake(body, x) > 0 && steps < 4000; ++steps) {
            const size_t nodes = awake(body, x);
            step(body, x, 1), step(body, never, 1);
            if (awake(body, x) < nodes) break; /* what fell asleep has stopped */
            read_all(body, x, CD_POSITION, before), read_all(body, never, CD_POSITION, after);
            assert_memory_equal(before, after, kind_numbers(kind, x, CD_POSITION) * sizeof *before);
            read_all(body, x, CD_VELOCITY, before), read_all(body, never, CD_VELOCITY, after);
            assert_memory_equal(before, after, kind_numbers(kind, x, CD_VELOCITY) * sizeof *before);
        }
        assert_true(steps > 10);
        read_all(body, never, CD_VELOCITY, v); /* it was slow, and is for as long */
        for (size_t i = 0; i < kind_numbers(kind, x, CD_VELOCITY); ++i) assert_true(fabs(v[i]) <= speed);
        assert_true(energy(body, x) <= energy(body, never));
        rest(body, x);
        const double held = energy(body, x);
        read_all(body, x, CD_POSITION, before);
        step(body, x, 100);
        read_all(body, x, CD_POSITION, after), read_all(body, x, CD_VELOCITY, v);
        assert_memory_equal(before, after, kind_numbers(kind, x, CD_POSITION) * sizeof *before);
        for (size_t i = 0; i < kind_numbers(kind, x, CD_VELOCITY); ++i) assert_true(v[i] == 0);
        assert_true(energy(body, x) == held);
        uint64_t made, of_never;
        step(body, never, 3);
        ok(kind->get_steps(x, &made)), ok(kind->get_steps(never, &of_never));
        assert_true(made > of_never); /* time passes in sleep */
        if (body->kind == MEMBRANE) { /* and of the solver is told what it took awake */
            cd_solver taken, by_never;
            ok(cd_membrane_get_solver_taken(x, &taken)), ok(cd_membrane_get_solver_taken(never, &by_never));
            assert_int_equal(taken, by_never);
        }
        ok(set_sleep(body, x, 0, NAN)); /* off, and awake */
        assert_int_equal(awake(body, x), body->parts * body->nodes);
        kind->destroy(x), kind->destroy(never);
    }
}

/* What a call of step tells of its steps, it tells of all of them that are made. */
static void what_a_call_tells_is_of_all_its_steps(void** state) {
    (void)state;
    for (size_t b = 0; b < COUNT(bodies); ++b)
        for (int fails = 0; fails <= (b != ROPES); ++fails) {
            const struct body* const body = &bodies[b];
            const struct kind* const kind = &kinds[body->kind];
            any *const x = body->make(CD_FLOAT64), *const never = body->make(CD_FLOAT64);
            any* const both[] = {x, never};
            cd_status status[2];
            char message[2][300];
            size_t iterations[2];
            double residual[2];
            ok(set_sleep(body, x, speed, seconds));
            for (int i = 0; i < 2; ++i) {
                step(body, both[i], 1);
                if (body->kind == CHAIN) {
                    if (fails) ok(cd_chain_set_method(both[i], CD_METHOD_FORWARD_EULER));
                } else if (fails) {
                    ok(cd_membrane_set_tolerance(both[i], 1e-14, 2)); /* of a coupled one */
                    if (b != COUPLED && b != CLOTH) ok(cd_membrane_set_method(both[i], CD_METHOD_FORWARD_EULER));
                }
                const double long_dt = fails && b != COUPLED && b != CLOTH ? 1e9 : dt; /* diverges */
                status[i] = kind->step(both[i], long_dt, 30);
                snprintf(message[i], sizeof message[i], "%s", status[i] == CD_OK ? "" : cd_error_message());
                ok(body->kind == CHAIN ? cd_chain_get_convergence(both[i], &iterations[i], &residual[i])
                                       : cd_membrane_get_convergence(both[i], &iterations[i], &residual[i]));
            }
            assert_true(!fails || b == CLOTH || status[1] != CD_OK);
            assert_int_equal(status[0], status[1]);
            assert_string_equal(message[0], message[1]);
            assert_int_equal(iterations[0], iterations[1]);
            assert_true(residual[0] == residual[1]);
            kind->destroy(x), kind->destroy(never);
        }
}

/* Whatever the kernels, the hook, and how calls share the steps; and after a load or a copy at any time. */
static void who_sleeps_is_part_of_the_state(void** state) {
    (void)state;
    FOR_BODIES(body, precision) {
        const struct kind* const kind = &kinds[body->kind];
        any* const x = body->make(precision);
        struct jobs jobs = {0, 0};
        ok(set_sleep(body, x, speed, seconds));
        for (size_t s = 0; s < STRANDS && body == &bodies[ROPES]; ++s) /* so that they fall asleep one by one */
            ok(cd_chain_attach(x, s, NODES - 1, 1, 0.4 * (double)s, NULL, 0));
        any* const others[] = {body->make(precision), body->make(precision), body->make(precision)};
        const cd_parallel hook = jobs_reversed(&jobs);
        ok(kind->set_parallel(others[0], &hook));
        ok(kind->set_kernels(others[0], CD_KERNELS_PLAIN));
        for (size_t o = 0; o < COUNT(others); ++o) kind_take(kind, others[o], x, 1);
        size_t steps = 0, sleeping = 0;
        for (; awake(body, x) > 0 && steps < 4000; ++steps) {
            const size_t nodes = awake(body, x);
            step(body, x, 1), step(body, others[0], 1);
            assert_true(kind_hash(kind, x) == kind_hash(kind, others[0]));
            sleeping += awake(body, x) < nodes;
            if (steps % 16 == 5) kind_take(kind, others[1], x, steps % 32 == 5);
            step(body, others[1], 1);
            if (steps % 16 != 5) assert_true(kind_hash(kind, x) == kind_hash(kind, others[1]));
            else kind_take(kind, others[1], x, 1);
        }
        if (body == &bodies[ROPES]) assert_true(sleeping > 2);
        step(body, others[2], steps), step(body, others[2], 7), step(body, x, 7);
        assert_true(kind_hash(kind, x) == kind_hash(kind, others[2]));
        ok(kind->set_kernels(x, CD_KERNELS_PLAIN)), ok(kind->set_parallel(x, &hook)); /* neither wakes */
        assert_int_equal(awake(body, x), 0);
        for (size_t o = 0; o < COUNT(others); ++o) kind->destroy(others[o]);
        kind->destroy(x);
    }
}

/* What wakes strand 2 of ropes, or all. */
typedef void act(cd_chain* c);
static const double one[3] = {1, 0, 0}, none[3] = {0, 0, 0};
static void write_position(cd_chain* c) { ok(cd_chain_write_f64(c, CD_POSITION, 2, 1, 3, 1, one, 3)); }
static void write_nothing_new(cd_chain* c) { ok(cd_chain_write_f64(c, CD_VELOCITY, 2, 1, 3, 1, none, 3)); }
static void write_single(cd_chain* c) { ok(cd_chain_write_f32(c, CD_FORCE, 2, 1, 6, 1, (const float[]){1, 0, 0}, 3)); }
static void write_mass(cd_chain* c) { ok(cd_chain_write_f64(c, CD_MASS, 2, 1, 6, 1, one, 1)); }
static void impulse(cd_chain* c) { ok(cd_chain_impulse(c, 2, 5, one, 3)); }
static void teleport(cd_chain* c) { ok(cd_chain_teleport(c, 2, NULL, one, 3)); }
static void attach(cd_chain* c) { ok(cd_chain_attach(c, 2, 5, 10, 1, one, 3)); }
static void detach(cd_chain* c) { ok(cd_chain_detach(c, 2, 4)); }
static void cut(cd_chain* c) { ok(cd_chain_cut(c, 2, 3)); }
static void weld(cd_chain* c) { ok(cd_chain_weld(c, 2, 3)); }
static void let_go(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_FREE)); }
static void gravity_off(cd_chain* c) { ok(cd_chain_set_gravity(c, none, 3)); }
static void drag(cd_chain* c) { ok(cd_chain_set_drag(c, 0)); }
static void stiffness(cd_chain* c) { ok(cd_chain_set_stiffness(c, 10)); }
static void rigid(cd_chain* c) { ok(cd_chain_set_stiffness(c, INFINITY)); }
static void length(cd_chain* c) { ok(cd_chain_set_rest_length(c, 2)); }
static void no_ring(cd_chain* c) { ok(cd_chain_set_ring(c, 0)); } /* as it was */
static void push(cd_chain* c) { ok(cd_chain_set_push(c, 1)); }
static void strength(cd_chain* c) { ok(cd_chain_set_strength(c, 1e-3)); }
static void mass(cd_chain* c) { ok(cd_chain_set_mass(c, 2)); }
static void bend(cd_chain* c) { ok(cd_chain_set_bend(c, 2)); }
static void air(cd_chain* c) { ok(cd_chain_set_air(c, 1, 2)); }
static void wind(cd_chain* c) { ok(cd_chain_set_wind(c, one, 3)); }
static void plane(cd_chain* c) { ok(cd_chain_set_plane(c, 0, one, one, 3, 0)); }
static void removed(cd_chain* c) { ok(cd_chain_remove_collider(c, 0)); }
static void moving(cd_chain* c) { ok(cd_chain_set_collider_velocity(c, 0, one, 3)); }
static void callback(cd_chain* c) { ok(cd_chain_set_callback(c, 0, &answer, none, 3, 0)); }
static void thickness(cd_chain* c) { ok(cd_chain_set_thickness(c, 1)); }
static void no_force(cd_chain* c) { ok(cd_chain_disable_field(c, CD_FORCE)); }
static void method(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_IMPLICIT)); }
static void reset(cd_chain* c) { ok(cd_chain_reset(c)); }
static void sleep_longer(cd_chain* c) { ok(cd_chain_set_sleep(c, speed, 2 * seconds)); }

static void what_changes_a_strand_wakes_it(void** state) {
    (void)state;
    static act* const of_one[] = {
        write_position, write_nothing_new, write_single, write_mass, impulse, teleport, attach, detach, cut, weld};
    static act* const of_all[] = {no_force, method,   let_go,    gravity_off, drag,         stiffness, rigid, length,
                                  push,     strength, mass,      bend,        air,          wind,      plane, removed,
                                  moving,   callback, thickness, reset,       sleep_longer, no_ring};
    const struct body* const body = &bodies[ROPES];
    cd_chain *const asleep = ropes(CD_FLOAT64), *const c = ropes(CD_FLOAT64);
    ok(cd_chain_enable_field(asleep, CD_FORCE)), ok(cd_chain_enable_field(asleep, CD_MASS));
    ok(cd_chain_enable_field(asleep, CD_STIFFNESS)), ok(cd_chain_enable_field(asleep, CD_WIND));
    ok(cd_chain_attach(asleep, 2, 4, 0, 0, NULL, 0)), ok(cd_chain_set_colliders(asleep, 1));
    ok(cd_chain_set_sleep(asleep, speed, seconds));
    rest(body, asleep);
    for (size_t i = 0; i < COUNT(of_one) + COUNT(of_all); ++i) {
        ok(cd_chain_copy_state(c, asleep));
        (i < COUNT(of_one) ? of_one[i] : of_all[i - COUNT(of_one)])(c);
        assert_int_equal(awake(body, c), i < COUNT(of_one) ? NODES : STRANDS * NODES);
    }
    ok(cd_chain_copy_state(c,
                           asleep)); /* what was refused, or is nothing, wakes no one; nor does how steps are solved */
    refuses(c, cd_chain_write_f64(c, CD_POSITION, 0, STRANDS, 0, NODES, NULL, 1), CD_ERROR_RANGE, "count");
    ok(cd_chain_write_f64(c, CD_POSITION, 0, STRANDS, 3, 0, NULL, 0));
    ok(cd_chain_set_tolerance(c, 1e-9, 50));
    ok(cd_chain_enable_field(c, CD_FORCE)), ok(cd_chain_enable_field(c, CD_BEND)); /* as it was */
    assert_int_equal(awake(body, c), 0);
    cd_chain_destroy(asleep), cd_chain_destroy(c);
}

/* And a sheet. */
static void what_changes_a_sheet_wakes_it(void** state) {
    (void)state;
    const struct body* const body = &bodies[CLOTH];
    cd_membrane *const asleep = hung_cloth(CD_FLOAT64), *const m = hung_cloth(CD_FLOAT64);
    ok(cd_membrane_enable_field(asleep, CD_FORCE)), ok(cd_membrane_enable_field(asleep, CD_WIND));
    ok(cd_membrane_enable_field(asleep, CD_STIFFNESS_U)), ok(cd_membrane_set_colliders(asleep, 1));
    ok(cd_membrane_attach(asleep, 2, 4, 0, 0, NULL, 0));
    ok(cd_membrane_set_sleep(asleep, speed, seconds));
    rest(body, asleep);
    enum { CHANGES = 25 };
    for (int change = 0; change < CHANGES; ++change) {
        ok(cd_membrane_copy_state(m, asleep));
        if (change == 0) ok(cd_membrane_write_f64(m, CD_VELOCITY, 3, 3, 1, 1, none, 3));
        if (change == 1) ok(cd_membrane_write_f32(m, CD_FORCE, 3, 3, 1, 1, (const float[]){1, 0, 0}, 3));
        if (change == 2) ok(cd_membrane_write_f64(m, CD_STIFFNESS_U, 3, 3, 1, 1, none, 1));
        if (change == 3) ok(cd_membrane_impulse(m, 3.0, 3.0, 1, one, 3));
        if (change == 4) ok(cd_membrane_teleport(m, NULL, one, 3));
        if (change == 5) ok(cd_membrane_attach(m, 3, 3, 10, 1, one, 3));
        if (change == 6) ok(cd_membrane_detach(m, 2, 4));
        if (change == 7) ok(cd_membrane_set_edge(m, CD_EDGE_V_FIRST, CD_NODE_FREE));
        if (change == 8) ok(cd_membrane_set_gravity(m, none, 3));
        if (change == 9) ok(cd_membrane_set_drag(m, 0));
        if (change == 10) ok(cd_membrane_set_stiffness(m, 10, 100));
        if (change == 11) ok(cd_membrane_set_rest_length(m, 2, 0.6));
        if (change == 12) ok(cd_membrane_set_shear(m, 10));
        if (change == 13) ok(cd_membrane_set_compression(m, 0));
        if (change == 14) ok(cd_membrane_set_breaking_strain(m, 1e-3));
        if (change == 15) ok(cd_membrane_set_air(m, 1, 2));
        if (change == 16) ok(cd_membrane_set_wind(m, one, 3));
        if (change == 17) ok(cd_membrane_set_plane(m, 0, one, one, 3, 0));
        if (change == 18) ok(cd_membrane_set_collider_velocity(m, 0, one, 3));
        if (change == 19) ok(cd_membrane_set_thickness(m, 1));
        if (change == 20) ok(cd_membrane_set_pressure(m, 3));
        if (change == 21) ok(cd_membrane_set_bend(m, 3));
        if (change == 22) ok(cd_membrane_set_mass_rule(m, CD_MASS_HALF_ENDS));
        if (change == 23) ok(cd_membrane_reset(m));
        if (change == 24) ok(cd_membrane_set_ring(m, 0, 0)); /* as it was */
        assert_int_equal(awake(body, m), SIDE * SIDE);
    }
    ok(cd_membrane_copy_state(m, asleep));
    ok(cd_membrane_write_f64(m, CD_POSITION, 3, 3, 0, 1, NULL, 0));
    ok(cd_membrane_set_effort(m, 3, 30));
    assert_int_equal(awake(body, m), 0);
    cd_membrane_destroy(asleep), cd_membrane_destroy(m);
}

/* Thrown up, it is slow for 2 speed / g: who asks for less time has it hang in the air, and who asks for more has not. */
static void what_it_neglects_is_an_acceleration(void** state) {
    (void)state;
    const double v = 1, up[3] = {0, 1.5 * v, 0};
    double slow = -1; /* steps between the first and the last that end slow */
    for (int k = 1; k < 64; ++k) slow += fabs(up[1] + gravity[1] * dt * k) <= v;
    assert_true(fabs(slow * dt - 2 * v / 9.81) < 1.5 * dt);
    const double asked[] = {dt, 0.5 * slow * dt, (slow - 0.5) * dt, (slow + 0.5) * dt, 2 * slow * dt, 1e60};
    for (size_t k = 0; k < COUNT(asked); ++k) FOR_BODIES(body, precision) {
            const struct kind* const kind = &kinds[body->kind];
            any* const x = body->make(precision);
            double thrown[MOST];
            if (body->kind == CHAIN) {
                ok(cd_chain_set_end(x, CD_END_FIRST, CD_NODE_FREE));
                ok(cd_chain_set_drag(x, 0)), ok(cd_chain_set_stiffness(x, 0));
            } else {
                ok(cd_membrane_set_edge(x, CD_EDGE_V_FIRST, CD_NODE_FREE));
                ok(cd_membrane_set_drag(x, 0)), ok(cd_membrane_set_stiffness(x, 0, 0));
                if (body == &bodies[CLOTH]) ok(cd_membrane_set_compression(x, 0));
            }
            for (size_t i = 0; i < kind_numbers(kind, x, CD_VELOCITY); ++i) thrown[i] = up[i % 3];
            ok(kind->write(x, CD_VELOCITY, thrown, kind_numbers(kind, x, CD_VELOCITY)));
            ok(set_sleep(body, x, v, asked[k]));
            for (size_t steps = 0; steps < 64; ++steps) step(body, x, 1);
            assert_int_equal(awake(body, x), asked[k] < slow * dt ? 0 : body->parts * body->nodes);
            kind->destroy(x);
        }
}

/* A node that is moved keeps its strand awake, however slow; once it stops, all may sleep. */
static void what_is_held_must_not_move(void** state) {
    (void)state;
    const double driven = CD_NODE_DRIVEN, creeps[3] = {1e-6, 0, 0};
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        const struct body* const body = &bodies[ROPES];
        cd_chain* const c = ropes(precision);
        ok(cd_chain_write_f64(c, CD_PIN, 1, 1, 0, 1, &driven, 1));
        ok(cd_chain_write_f64(c, CD_VELOCITY, 1, 1, 0, 1, creeps, 3));
        ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_FREE)), ok(cd_chain_enable_field(c, CD_TARGET));
        const double posed = CD_NODE_POSED;
        double target[3];
        ok(cd_chain_read_f64(c, CD_POSITION, 3, 1, 0, 1, target, 3));
        ok(cd_chain_write_f64(c, CD_PIN, 3, 1, 0, 1, &posed, 1));
        ok(cd_chain_set_sleep(c, speed, seconds));
        for (int i = 0; i < 2000; ++i) { /* a pose that is written wakes */
            target[0] += 1e-6;
            if (i < 1900) ok(cd_chain_write_f64(c, CD_TARGET, 3, 1, 0, 1, target, 3));
            step(body, c, 1);
            assert_true(awake(body, c) >= (i < 1900 ? 2 : 1) * NODES);
        }
        assert_int_equal(awake(body, c), NODES);
        double v[3];
        ok(cd_chain_read_f64(c, CD_VELOCITY, 1, 1, 0, 1, v, 3));
        assert_true(fabs(v[0] - creeps[0]) < 1e-12);
        ok(cd_chain_write_f64(c, CD_VELOCITY, 1, 1, 0, 1, none, 3));
        rest(body, c);
        cd_chain_destroy(c);
    }
}

/* A pose is reached, and then stands still, however many steps a call makes and whatever rounding they go by. */
static void what_is_posed_comes_to_rest(void** state) {
    (void)state;
    FOR_BODIES(body, precision) {
        const struct kind* const kind = &kinds[body->kind];
        for (size_t count = 3; count <= 7; count += 4) {
            any* const x = body->make(precision);
            double target[3];
            ok(set_sleep(body, x, speed, seconds));
            if (body->kind == CHAIN) ok(cd_chain_set_end(x, CD_END_FIRST, CD_NODE_POSED));
            else ok(cd_membrane_set_edge(x, CD_EDGE_V_FIRST, CD_NODE_POSED));
            for (int call = 0; call < 20; ++call) {
                if (body->kind == CHAIN) ok(cd_chain_read_f64(x, CD_TARGET, 0, 1, 0, 1, target, 3));
                else ok(cd_membrane_read_f64(x, CD_TARGET, 0, 0, 1, 1, target, 3));
                for (int k = 0; k < 3; ++k) target[k] += 0.0037 * (k + 1);
                if (body->kind == CHAIN) ok(cd_chain_write_f64(x, CD_TARGET, 0, 1, 0, 1, target, 3));
                else ok(cd_membrane_write_f64(x, CD_TARGET, 0, 0, 1, 1, target, 3));
                step(body, x, count);
            }
            for (int call = 0; call < 2000 && awake(body, x) > 0; ++call) step(body, x, count);
            assert_int_equal(awake(body, x), 0);
            kind->destroy(x);
        }
    }
}

/* What breaks in the step that would let it fall asleep, falls. */
static void what_breaks_is_awake(void** state) {
    (void)state;
    for (int is_cloth = 0; is_cloth <= 1; ++is_cloth) {
        const struct body* const body = &bodies[is_cloth ? CLOTH : ROPES];
        for (double asked = 0, first = 0; asked == 0 || first > 0; asked = (first - 1.5) * dt) {
            any* const x = body->make(CD_FLOAT64);
            if (is_cloth) ok(cd_membrane_set_breaking_strain(x, 0.02)), ok(cd_membrane_set_drag(x, 40));
            else ok(cd_chain_set_strength(x, 8)), ok(cd_chain_set_drag(x, 40));
            if (asked > 0) ok(set_sleep(body, x, 1e6, asked));
            size_t broken = 0, steps = 0;
            for (; broken == 0 && steps < 1000; ++steps) {
                step(body, x, 1);
                ok(is_cloth ? cd_membrane_get_broken(x, &broken) : cd_chain_get_broken(x, &broken));
            }
            assert_true(broken > 0);
            if (asked > 0) {
                assert_int_equal(first, steps);
                assert_int_equal(awake(body, x), (is_cloth ? 1 : broken) * body->nodes);
                kinds[body->kind].destroy(x);
                break;
            }
            first = (double)steps;
            assert_true(first > 3);
            kinds[body->kind].destroy(x);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_rests_sleeps),
        cmocka_unit_test(what_a_call_tells_is_of_all_its_steps),
        cmocka_unit_test(who_sleeps_is_part_of_the_state),
        cmocka_unit_test(what_changes_a_strand_wakes_it),
        cmocka_unit_test(what_changes_a_sheet_wakes_it),
        cmocka_unit_test(what_it_neglects_is_an_acceleration),
        cmocka_unit_test(what_is_held_must_not_move),
        cmocka_unit_test(what_is_posed_comes_to_rest),
        cmocka_unit_test(what_breaks_is_awake),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
