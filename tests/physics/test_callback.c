/* Ropes and cloth that touch shapes by callback: those that there are otherwise too, hollow ones, some that move, and
 * answers that are none. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "cloth.h"
#include "reference.h"

enum { NODES = 41, SPRINGS = 12, SHEET = (SPRINGS + 1) * (SPRINGS + 1) };
static const double nowhere[3] = {0, 0, 0}, weight[3] = {0, -9.81, 0};

/* ---- shapes ------------------------------------------------------------------------------------------------------ */

struct shape {
    double normal[3], radius;
    size_t calls, asked; /* how often it was asked, and about how much the last time */
};
static void plane(void* user, double time, size_t count, size_t components, const double* x, double* distances,
                  double* normals) {
    struct shape* const s = user;
    (void)time;
    ++s->calls, s->asked = count;
    for (size_t i = 0; i < count; ++i) {
        distances[i] = 0;
        for (size_t k = 0; k < components; ++k) {
            distances[i] += s->normal[k] * x[i * components + k];
            normals[i * components + k] = s->normal[k];
        }
    }
}
static void ball_of(const struct shape* s, double inside, size_t count, size_t components, const double* x,
                    double* distances, double* normals) {
    for (size_t i = 0; i < count; ++i) {
        double square = 0;
        for (size_t k = 0; k < components; ++k) square += x[i * components + k] * x[i * components + k];
        const double r = sqrt(square);
        distances[i] = inside * (r - s->radius);
        for (size_t k = 0; k < components; ++k)
            normals[i * components + k] = r > 0 ? inside * x[i * components + k] / r : k == 0;
    }
}
static void ball(void* user, double time, size_t count, size_t components, const double* x, double* distances,
                 double* normals) {
    (void)time;
    ball_of(user, 1, count, components, x, distances, normals);
}
static void bowl(void* user, double time, size_t count, size_t components, const double* x, double* distances,
                 double* normals) {
    (void)time;
    ball_of(user, -1, count, components, x, distances, normals);
}
/* A ball that goes along the first axis at 0.5 m/s by itself. */
static void wanderer(void* user, double time, size_t count, size_t components, const double* x, double* distances,
                     double* normals) {
    double moved[3 * SHEET];
    memcpy(moved, x, count * components * sizeof *x);
    for (size_t i = 0; i < count; ++i) moved[i * components] -= 0.5 * time;
    ball_of(user, 1, count, components, moved, distances, normals);
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

static cd_chain* rope_of(size_t strands, double lambda) {
    cd_chain* c;
    ok(cd_chain_create(strands, NODES - 1, 3, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_rest_length(c, 2));
    ok(cd_chain_set_stiffness(c, INFINITY));
    ok(cd_chain_set_lambda(c, lambda));
    ok(cd_chain_set_gravity(c, weight, 3));
    ok(cd_chain_set_colliders(c, 1));
    for (size_t s = 0; s < strands; ++s)
        for (size_t i = 0; i < NODES; ++i) {
            const double at = (double)i / (NODES - 1);
            const double x[3] = {1.9 * at - 0.9, 0.9 + 0.1 * sin(5 * at + (double)s), 0.1 * (double)s};
            ok(cd_chain_write_f64(c, CD_POSITION, s, 1, i, 1, x, 3));
        }
    return c;
}
static void positions(const cd_chain* c, size_t strands, double* x) {
    ok(cd_chain_read_f64(c, CD_POSITION, 0, strands, 0, NODES, x, strands * NODES * 3));
}
static cd_membrane* sheet(void) {
    cd_membrane* m = cloth(SPRINGS, SPRINGS, 3, CD_FLOAT64);
    ok(cd_membrane_set_rest_length(m, 1, 1));
    ok(cd_membrane_set_mass(m, 0.2));
    ok(cd_membrane_set_stiffness(m, 1000, 1000));
    ok(cd_membrane_set_shear(m, 50));
    ok(cd_membrane_set_gravity(m, weight, 3));
    ok(cd_membrane_set_colliders(m, 1));
    for (size_t v = 0; v <= SPRINGS; ++v)
        for (size_t u = 0; u <= SPRINGS; ++u) {
            const double x[3] = {(double)u / SPRINGS - 0.45, 0.8, (double)v / SPRINGS - 0.53};
            ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, 3));
        }
    return m;
}
static double energy_of(const cd_chain* c) {
    double e[3];
    ok(cd_chain_get_energy(c, &e[0], &e[1], &e[2]));
    return e[0] + e[1] + e[2];
}

/* The shapes that there are otherwise, each as a callback: a leaning plane and a ball, both on their way. Without
 * friction, whose 1% of freedom depends on the way iterations take, a rope goes the same to rounding, cloth always. */
static void what_callbacks_tell_is_met_as_the_same_shape_is(void** state) {
    (void)state;
    const double normal[3] = {0.28, 0.96, 0}, velocity[3] = {0.125, 0.25, -0.0625}, origin[3] = {0.125, -0.25, 0};
    struct shape leaning = {{0.28, 0.96, 0}, 0, 0, 0}, round = {{0}, 0.5, 0, 0};
    const cd_distance tables[2] = {{&leaning, plane}, {&round, ball}};
    for (int way = 0; way < 4; ++way) {
        const int is_ball = way % 2;
        const double friction = way < 2 ? 0 : 0.4;
        double x[2][NODES * 3], y[2][SHEET * 3];
        for (int called = 0; called < 2; ++called) {
            cd_chain* c = rope_of(1, way % 2 ? 1 : 0.5);
            cd_membrane* m = sheet();
            ok(cd_chain_set_tolerance(c, 1e-10, 1000));
            ok(cd_chain_set_thickness(c, 0.02));
            ok(cd_membrane_set_thickness(m, 0.02));
            ok(cd_membrane_set_effort(m, 3, 12)); /* where iterations end as needed is rounding's choice sometimes */
            if (called) {
                ok(cd_chain_set_callback(c, 0, &tables[is_ball], origin, 3, friction));
                ok(cd_membrane_set_callback(m, 0, &tables[is_ball], origin, 3, friction));
            } else if (is_ball) {
                ok(cd_chain_set_capsule(c, 0, origin, origin, 3, 0.5, friction));
                ok(cd_membrane_set_capsule(m, 0, origin, origin, 3, 0.5, friction));
            } else {
                ok(cd_chain_set_plane(c, 0, origin, normal, 3, friction));
                ok(cd_membrane_set_plane(m, 0, origin, normal, 3, friction));
            }
            ok(cd_chain_set_collider_velocity(c, 0, velocity, 3));
            ok(cd_membrane_set_collider_velocity(m, 0, velocity, 3));
            ok(cd_chain_step(c, 1 / 60.0, way < 2 ? 45 : 30));
            ok(cd_membrane_step(m, 1 / 60.0, 30));
            positions(c, 1, x[called]);
            cloth_read(m, CD_POSITION, y[called]);
            cd_chain_destroy(c);
            cd_membrane_destroy(m);
        }
        for (int i = 0; i < NODES * 3; ++i) assert_near(x[0][i], x[1][i], friction > 0 ? 1e-4 : 1e-8, 1);
        for (int i = 0; i < SHEET * 3; ++i) assert_near(y[0][i], y[1][i], 1e-9, 1);
    }
}

/* One call for all nodes of a strand, and for all of a sheet. */
static void a_callback_is_asked_for_a_strand_or_a_sheet_at_once(void** state) {
    (void)state;
    struct shape floor = {{0, 1, 0}, 0, 0, 0};
    const cd_distance table = {&floor, plane};
    cd_chain* c = rope_of(5, 1);
    size_t iterations;
    ok(cd_chain_set_callback(c, 0, &table, nowhere, 3, 0.5));
    ok(cd_chain_step(c, 1e-3, 1));
    ok(cd_chain_get_convergence(c, &iterations, NULL));
    assert_int_equal(floor.asked, NODES);
    assert_true(floor.calls <= 5 * (iterations + 2)); /* at the start, at its guess, and after each iteration */
    cd_chain_destroy(c);
    floor.calls = 0;
    cd_membrane* m = sheet();
    ok(cd_membrane_set_callback(m, 0, &table, nowhere, 3, 0.5));
    ok(cd_membrane_step(m, 1e-3, 7));
    assert_true(floor.calls == 7 && floor.asked == SHEET);
    cd_membrane_destroy(m);
}

/* Strands side by side go as each alone does, bit by bit. */
static void strands_do_not_feel_what_others_ask(void** state) {
    (void)state;
    enum { STRANDS = 11 };
    static double all[STRANDS][NODES * 3], alone[NODES * 3];
    struct shape round = {{0}, 0.5, 0, 0};
    const cd_distance table = {&round, ball};
    for (int hollow = 0; hollow < 2; ++hollow) {
        const cd_distance inside = {&(struct shape){{0}, 1.5, 0, 0}, bowl};
        cd_chain* many = rope_of(STRANDS, 0.5);
        ok(cd_chain_set_callback(many, 0, hollow ? &inside : &table, nowhere, 3, 0.3));
        ok(cd_chain_step(many, 1 / 60.0, 30));
        positions(many, STRANDS, all[0]);
        for (size_t s = 0; s < STRANDS; ++s) {
            cd_chain* one = rope_of(1, 0.5);
            double x[NODES * 3];
            for (size_t i = 0; i < NODES; ++i) {
                const double at = (double)i / (NODES - 1);
                x[3 * i] = 1.9 * at - 0.9, x[3 * i + 1] = 0.9 + 0.1 * sin(5 * at + (double)s);
                x[3 * i + 2] = 0.1 * (double)s;
            }
            ok(cd_chain_write_f64(one, CD_POSITION, 0, 1, 0, NODES, x, NODES * 3));
            ok(cd_chain_set_callback(one, 0, hollow ? &inside : &table, nowhere, 3, 0.3));
            ok(cd_chain_step(one, 1 / 60.0, 30));
            positions(one, 1, alone);
            assert_same_bits(alone, all[s], NODES * 3);
            cd_chain_destroy(one);
        }
        cd_chain_destroy(many);
    }
}

/* In a bowl, with friction and without, at long steps: at rest at last, never outside by more than a step leads out of
 * the tangent, and with no more energy than that. */
static void a_bowl_holds_what_falls_into_it(void** state) {
    (void)state;
    static const double frictions[] = {0, 0.5}, dts[] = {1 / 30.0, 1 / 120.0};
    struct shape round = {{0}, 1.5, 0, 0};
    const cd_distance table = {&round, bowl};
    for (size_t f = 0; f < 2; ++f)
        for (size_t d = 0; d < 2; ++d) {
            cd_chain* c = rope_of(1, 0.5);
            double x[NODES * 3], least = energy_of(c), risen = 0, outside = 0;
            ok(cd_chain_set_callback(c, 0, &table, nowhere, 3, frictions[f]));
            for (int step = 0; step < (int)(10 / dts[d]); ++step) {
                ok(cd_chain_step(c, dts[d], 1));
                const double now = energy_of(c);
                risen = fmax(risen, now - least), least = fmin(least, now);
                positions(c, 1, x);
                for (int i = 0; i < NODES; ++i)
                    outside = fmax(
                        outside,
                        sqrt(x[3 * i] * x[3 * i] + x[3 * i + 1] * x[3 * i + 1] + x[3 * i + 2] * x[3 * i + 2]) - 1.5);
            }
            print_message("friction %g, dt %.4f: energy risen by %.1e J, outside by %.1e m\n", frictions[f], dts[d],
                          risen, outside);
            assert_true(risen < (d == 0 ? 0.1 : 0.03)); /* of some 20: what went outside is lifted */
            assert_true(outside < (d == 0 ? 0.05 : 0.005));
            cd_chain_destroy(c);
        }
}

/* A shape may change with the time that it is told, and is then met about where it was when a step began; where a
 * velocity leads it, it is met where that leads. */
static void a_shape_may_depend_on_time(void** state) {
    (void)state;
    struct shape round = {{0}, 0.5, 0, 0};
    const cd_distance table = {&round, wanderer}, still = {&round, ball};
    double x[2][NODES * 3], y[2][SHEET * 3];
    for (int moves = 0; moves < 2; ++moves) { /* by itself, or by its velocity, without friction */
        const double velocity[3] = {0.5, 0, 0};
        cd_chain* c = rope_of(1, 1);
        cd_membrane* m = sheet();
        ok(cd_chain_set_tolerance(c, 1e-10, 1000));
        ok(cd_chain_set_callback(c, 0, moves ? &still : &table, nowhere, 3, 0));
        ok(cd_membrane_set_callback(m, 0, moves ? &still : &table, nowhere, 3, 0));
        if (moves) ok(cd_chain_set_collider_velocity(c, 0, velocity, 3));
        if (moves) ok(cd_membrane_set_collider_velocity(m, 0, velocity, 3));
        ok(cd_chain_step(c, 1 / 60.0, 40));
        ok(cd_membrane_step(m, 1 / 60.0, 40));
        positions(c, 1, x[moves]);
        cloth_read(m, CD_POSITION, y[moves]);
        cd_chain_destroy(c);
        cd_membrane_destroy(m);
    }
    double apart[2] = {0, 0};
    for (int i = 0; i < NODES * 3; ++i) apart[0] = fmax(apart[0], fabs(x[0][i] - x[1][i]));
    for (int i = 0; i < SHEET * 3; ++i) apart[1] = fmax(apart[1], fabs(y[0][i] - y[1][i]));
    print_message("a step behind: %.4f m of a rope, %.4f m of cloth\n", apart[0], apart[1]);
    assert_true(apart[0] < 0.03 && apart[1] < 0.1);
    assert_true(apart[0] > 1e-4 && apart[1] > 1e-4); /* it is no still shape either */
}

/* Where nothing is told of, beyond the largest distance that may be told. */
static void the_end_of_the_world_is_no_callback_s_fault(void** state) {
    (void)state;
    struct shape round = {.radius = 1};
    const cd_distance distance = {&round, ball};
    const double nowhere[3] = {0, 0, 0}, far_off[3] = {9e59, -9e59, 9e59};
    cd_chain* c = rope_of(1, 1);
    ok(cd_chain_set_callback(c, 0, &distance, nowhere, 3, 0));
    for (size_t i = 0; i < NODES; ++i) ok(cd_chain_write_f64(c, CD_POSITION, 0, 1, i, 1, far_off, 3));
    ok(cd_chain_step(c, 1 / 60.0, 1));
    cd_chain_destroy(c);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_callbacks_tell_is_met_as_the_same_shape_is),
        cmocka_unit_test(a_callback_is_asked_for_a_strand_or_a_sheet_at_once),
        cmocka_unit_test(strands_do_not_feel_what_others_ask),
        cmocka_unit_test(a_bowl_holds_what_falls_into_it),
        cmocka_unit_test(a_shape_may_depend_on_time),
        cmocka_unit_test(the_end_of_the_world_is_no_callback_s_fault),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
