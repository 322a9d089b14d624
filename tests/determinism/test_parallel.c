/* The result depends neither on who runs the tasks and in what order, nor on a strand's neighbours, nor on how steps
 * are dealt out over calls and threads. */
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>

#include "check.h"
#include "jobs.h"
#include "scene.h"

static const cd_method methods[] = {CD_METHOD_IMPLICIT, CD_METHOD_FORWARD_EULER, CD_METHOD_SYMPLECTIC_EULER,
                                    CD_METHOD_STIFF_SECOND};
static const double dts[] = {0.01, 0.0002, 0.001, 0.01};

static cd_chain* begin(scene_build* build, size_t strands, size_t springs, size_t components, cd_precision precision,
                       cd_method method) {
    cd_chain* chain = scene_chain(strands, springs, components, precision);
    build(chain);
    ok(cd_chain_set_method(chain, method));
    return chain;
}

static void the_job_system_leaves_no_trace(void** state) {
    (void)state;
    static const size_t strands[] = {1, 3, 17, 8192};
    static scene_build* const builds[] = {scene_welded, scene_everything, scene_everything_ring};
    for (size_t b = 0; b < COUNT(builds); ++b) {
        for (size_t s = 0; s < COUNT(strands); ++s) {
            for (size_t components = 1; components <= 4; ++components) {
                for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                    cd_chain* begun =
                        begin(builds[b], strands[s], 8, components, precision, CD_METHOD_IMPLICIT);
                    cd_chain* chain = scene_chain(strands[s], 8, components, precision);
                    for (size_t m = 0; m < COUNT(methods); ++m) {
                        struct jobs jobs[2] = {{0}};
                        const cd_parallel ways[] = {jobs_reversed(&jobs[0]), jobs_threads(&jobs[1])};
                        uint64_t hashes[3];
                        for (size_t way = 0; way < 3; ++way) {
                            ok(cd_chain_copy_state(chain, begun));
                            ok(cd_chain_set_method(chain, methods[m]));
                            ok(cd_chain_set_parallel(chain, way == 0 ? NULL : &ways[way - 1]));
                            ok(cd_chain_step(chain, dts[m], 7));
                            hashes[way] = hash_of(chain);
                        }
                        assert_int_equal(hashes[1], hashes[0]);
                        assert_int_equal(hashes[2], hashes[0]);
                        assert_true(hashes[0] != hash_of(begun));
                        if (strands[s] == 8192) assert_true(jobs[0].tasks > 100 && jobs[1].tasks > 100);
                    }
                    cd_chain_destroy(chain);
                    cd_chain_destroy(begun);
                }
            }
        }
    }
}

/* Strands that fill bundles, tasks and groups of them, and such as do not. */
static void the_job_system_leaves_no_trace_in_ropes(void** state) {
    (void)state;
    static const size_t strands[] = {1, 2, 7, 8, 9, 17, 129, 200};
    for (size_t scene = 0; scene < ROPE_SCENES; ++scene) {
        for (size_t s = 0; s < COUNT(strands); ++s) {
            for (size_t components = 1; components <= 3; ++components) {
                const cd_precision precision = (cd_precision)((s + components) % 2);
                struct jobs jobs[2] = {{0}};
                const cd_parallel ways[] = {jobs_reversed(&jobs[0]), jobs_threads(&jobs[1])};
                uint64_t hashes[3];
                for (size_t way = 0; way < 3; ++way) {
                    cd_chain* chain =
                        begin(rope_scenes[scene].build, strands[s], 12, components, precision, CD_METHOD_IMPLICIT);
                    ok(cd_chain_set_parallel(chain, way == 0 ? NULL : &ways[way - 1]));
                    ok(cd_chain_step(chain, 0.01, 7));
                    hashes[way] = hash_of(chain);
                    cd_chain_destroy(chain);
                }
                assert_int_equal(hashes[1], hashes[0]);
                assert_int_equal(hashes[2], hashes[0]);
                if (strands[s] > 128) assert_true(jobs[0].tasks > 1 && jobs[1].tasks > 1);
            }
        }
    }
}

static void the_parallel_table_is_copied_and_can_be_taken_back(void** state) {
    (void)state;
    struct jobs jobs = {0};
    cd_parallel parallel = jobs_reversed(&jobs);
    cd_chain* chain = begin(scene_rope, 100, 9, 3, CD_FLOAT64, CD_METHOD_IMPLICIT);
    ok(cd_chain_set_parallel(chain, &parallel));
    parallel.run = NULL;
    ok(cd_chain_step(chain, 0.01, 2));
    const size_t tasks = jobs.tasks;
    assert_true(tasks > 1);
    ok(cd_chain_set_parallel(chain, NULL));
    ok(cd_chain_step(chain, 0.01, 2));
    assert_int_equal(jobs.tasks, tasks);
    cd_chain_destroy(chain);
}

/* Gives `alone`, of one strand, the numbers of a strand of `many`. */
static void copy_strand(cd_chain* alone, const cd_chain* many, size_t strand) {
    static const cd_field fields[] = {CD_PIN,   CD_MASS,   CD_STIFFNESS, CD_REST_LENGTH, CD_POSITION,
                                      CD_VELOCITY, CD_FORCE, CD_TARGET,    CD_WIND};
    double values[64], stiffness, damping;
    for (size_t i = 0; i < COUNT(fields); ++i) {
        const size_t items = scene_field_items(many, fields[i]), strands = scene_field_strands(many, fields[i]);
        const size_t count = scene_field_count(many, fields[i]) / strands;
        assert_true(count <= COUNT(values));
        if (cd_chain_read_f64(many, fields[i], strands > 1 ? strand : 0, 1, 0, items, values, count) != CD_OK) continue;
        ok(cd_chain_enable_field(alone, fields[i]));
        ok(cd_chain_write_f64(alone, fields[i], 0, 1, 0, items, values, count));
    }
    for (size_t node = 0; node < scene_nodes(many) && scene_own_strands(many) > 1; ++node) {
        ok(cd_chain_get_attachment(many, strand, node, &stiffness, &damping));
        ok(cd_chain_get_attachment(alone, 0, node, &values[0], &values[1]));
        if (stiffness == values[0] && damping == values[1]) continue;
        const size_t components = scene_components(many);
        if (stiffness > 0 || damping > 0)
            ok(cd_chain_read_f64(many, CD_TARGET, strand, 1, node, 1, values, components));
        else ok(cd_chain_read_f64(alone, CD_TARGET, 0, 1, node, 1, values, components));
        ok(cd_chain_attach(alone, 0, node, stiffness, damping, values, components));
    }
}

static scene_build* builder_of(size_t scene) {
    return scene < SCENES ? scenes[scene].build : rope_scenes[scene - SCENES].build;
}
/* Ropes have one method, and no fourth component. */
static bool can_be(size_t scene, size_t components, cd_method method) {
    return scene < SCENES || (components <= 3 && method == CD_METHOD_IMPLICIT);
}

static void a_strand_does_not_feel_its_neighbours(void** state) {
    (void)state;
    enum { STRANDS = 37, SPRINGS = 11, NODES = SPRINGS + 1 };
    static const size_t some[] = {0, 1, 15, 16, 31, 36};
    for (size_t scene = 0; scene < SCENES + ROPE_SCENES; ++scene) {
        for (size_t components = 1; components <= 4; ++components) {
            for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
                for (size_t m = 0; m < COUNT(methods); ++m) {
                    if (!can_be(scene, components, methods[m])) continue;
                    cd_chain* many =
                        begin(builder_of(scene), STRANDS, SPRINGS, components, precision, methods[m]);
                    cd_chain* alone[COUNT(some)];
                    for (size_t i = 0; i < COUNT(some); ++i) {
                        alone[i] = begin(builder_of(scene), 1, SPRINGS, components, precision, methods[m]);
                        copy_strand(alone[i], many, some[i]);
                        ok(cd_chain_step(alone[i], dts[m], 40));
                    }
                    ok(cd_chain_step(many, dts[m], 40));
                    for (size_t i = 0; i < COUNT(some); ++i) {
                        for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
                            double x[NODES * 4], y[NODES * 4];
                            const size_t count = NODES * components;
                            ok(cd_chain_read_f64(many, field, some[i], 1, 0, NODES, x, count));
                            ok(cd_chain_read_f64(alone[i], field, 0, 1, 0, NODES, y, count));
                            assert_same_bits(x, y, count);
                        }
                        cd_chain_destroy(alone[i]);
                    }
                    cd_chain_destroy(many);
                }
            }
        }
    }
}

/* A ball that moves through the strands, and a plane that they fall on. */
static void put_things(cd_chain* chain) {
    const double low[3] = {-0.1, -0.2, -0.3}, up[3] = {3, 1, 0.5}, place[3] = {0.4, 3, 0.1}, last[3] = {0.5, 9, 0.2};
    const double slow[3] = {0.1, -0.3, 0.2};
    const size_t components = scene_components(chain);
    ok(cd_chain_set_thickness(chain, 0.01));
    ok(cd_chain_set_colliders(chain, 2));
    ok(cd_chain_set_plane(chain, 0, low, up, components, 0.5));
    ok(cd_chain_set_capsule(chain, 1, place, last, components, 0.1, 0.75));
    ok(cd_chain_set_collider_velocity(chain, 1, slow, components));
}

/* Strands of a rope that differ in all that they may: each moves to the bit as one alone does. */
static void strands_of_ropes_are_individuals(void** state) {
    (void)state;
    enum { STRANDS = 21, SPRINGS = 9, NODES = SPRINGS + 1 };
    for (uint64_t number = 0; number < 60; ++number) {
        const size_t components = 1 + number % 3;
        const double dt = number % 5 == 0 ? 1 : 0.02, gravity[3] = {-9.81, 1, 0.5};
        uint64_t seed = 900 + number;
        cd_chain* many = scene_chain(STRANDS, SPRINGS, components, number % 2 ? CD_FLOAT64 : CD_FLOAT32);
        ok(cd_chain_set_rest_length(many, 1));
        ok(cd_chain_set_gravity(many, gravity, components));
        ok(cd_chain_set_lambda(many, number % 4 == 0 ? 1 : 0.5));
        if (number % 3 == 0) ok(cd_chain_set_air(many, 0.1, 1));
        if (number % 4 >= 2) put_things(many);
        ok(cd_chain_enable_field(many, CD_MASS));
        ok(cd_chain_enable_field(many, CD_STIFFNESS));
        ok(cd_chain_enable_field(many, CD_REST_LENGTH));
        scene_lay_out(many, 0.1);
        scene_shake(many, 0.03, number);
        for (size_t s = 0; s < STRANDS; ++s)
            for (size_t i = 0; i < NODES; ++i) {
                const double kind = 4 * scene_noise(&seed), mass = pow(10, scene_noise(&seed));
                const double pin = kind > 3.3 ? CD_NODE_PINNED : kind < -3.6 ? CD_NODE_DRIVEN : CD_NODE_FREE;
                const double firm = scene_noise(&seed), length = 0.11 * (1 + 0.2 * scene_noise(&seed));
                const double stiffness = firm > 0.5 ? INFINITY : firm < -0.8 ? 0 : 1000 * (2 + firm);
                ok(cd_chain_write_f64(many, CD_PIN, s, 1, i, 1, &pin, 1));
                ok(cd_chain_write_f64(many, CD_MASS, s, 1, i, 1, &mass, 1));
                if (kind > -0.1 && kind < 0.1) ok(cd_chain_attach(many, s, i, 30 * mass, 0.5, NULL, 0));
                if (i == SPRINGS) continue;
                ok(cd_chain_write_f64(many, CD_STIFFNESS, s, 1, i, 1, &stiffness, 1));
                ok(cd_chain_write_f64(many, CD_REST_LENGTH, s, 1, i, 1, &length, 1));
            }
        cd_chain* alone[STRANDS];
        for (size_t s = 0; s < STRANDS; ++s) {
            alone[s] = scene_chain(1, SPRINGS, components, number % 2 ? CD_FLOAT64 : CD_FLOAT32);
            ok(cd_chain_set_rest_length(alone[s], 1));
            ok(cd_chain_set_gravity(alone[s], gravity, components));
            ok(cd_chain_set_lambda(alone[s], number % 4 == 0 ? 1 : 0.5));
            if (number % 3 == 0) ok(cd_chain_set_air(alone[s], 0.1, 1));
            if (number % 4 >= 2) put_things(alone[s]);
            copy_strand(alone[s], many, s);
        }
        double energy[3] = {0}, of_all[3], of_one[3];
        for (int step = 0; step < 10; ++step) {
            int short_of = 0, wrong = cd_chain_step(many, dt, 1) == CD_ERROR_TOLERANCE; /* held nodes may drift apart */
            for (size_t s = 0; s < STRANDS; ++s) short_of |= cd_chain_step(alone[s], dt, 1) == CD_ERROR_TOLERANCE;
            assert_int_equal(wrong, short_of);
        }
        ok(cd_chain_get_energy(many, &of_all[0], &of_all[1], &of_all[2]));
        for (size_t s = 0; s < STRANDS; ++s) {
            double x[2][NODES * 3], tension[2][SPRINGS];
            for (cd_field field = CD_POSITION; field <= CD_VELOCITY; ++field) {
                ok(cd_chain_read_f64(many, field, s, 1, 0, NODES, x[0], NODES * components));
                ok(cd_chain_read_f64(alone[s], field, 0, 1, 0, NODES, x[1], NODES * components));
                assert_same_bits(x[0], x[1], NODES * components);
            }
            ok(cd_chain_read_f64(many, CD_TENSION, s, 1, 0, SPRINGS, tension[0], SPRINGS));
            ok(cd_chain_read_f64(alone[s], CD_TENSION, 0, 1, 0, SPRINGS, tension[1], SPRINGS));
            assert_same_bits(tension[0], tension[1], SPRINGS);
            ok(cd_chain_get_energy(alone[s], &of_one[0], &of_one[1], &of_one[2]));
            for (int k = 0; k < 3; ++k) energy[k] += of_one[k];
            cd_chain_destroy(alone[s]);
        }
        for (int k = 0; k < 3; ++k) assert_near(of_all[k], energy[k], 1e-9 * (1 + fabs(energy[k])), 0);
        cd_chain_destroy(many);
    }
}

static void components_do_not_mix(void** state) {
    (void)state;
    enum { SPRINGS = 11, NODES = SPRINGS + 1, COMPONENTS = 4 };
    for (size_t scene = 0; scene < SCENES; ++scene) {
        for (size_t m = 0; m < COUNT(methods); ++m) {
            cd_chain* chains[2];
            double x[2][NODES * COMPONENTS];
            for (size_t i = 0; i < 2; ++i) {
                chains[i] = begin(scenes[scene].build, 1, SPRINGS, COMPONENTS, CD_FLOAT32, methods[m]);
                scene_read(chains[i], CD_POSITION, x[i]);
                for (size_t node = 0; node < NODES && i == 1; ++node) x[1][node * COMPONENTS + 2] += 3;
                scene_write(chains[i], CD_POSITION, x[i]);
                ok(cd_chain_step(chains[i], dts[m], 40));
                scene_read(chains[i], CD_POSITION, x[i]);
                cd_chain_destroy(chains[i]);
            }
            for (size_t j = 0; j < COUNT(x[0]); ++j) {
                if (j % COMPONENTS == 2) assert_true(x[0][j] != x[1][j]);
                else assert_same_bits(&x[0][j], &x[1][j], 1);
            }
        }
    }
}

static void ten_steps_at_once_are_ten_steps(void** state) {
    (void)state;
    for (size_t scene = 0; scene < SCENES + ROPE_SCENES; ++scene) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            for (size_t m = 0; m < COUNT(methods); ++m) {
                if (!can_be(scene, 3, methods[m])) continue;
                cd_chain* at_once = begin(builder_of(scene), 3, 12, 3, precision, methods[m]);
                cd_chain* singly = begin(builder_of(scene), 3, 12, 3, precision, methods[m]);
                ok(cd_chain_step(at_once, dts[m], 10));
                for (int i = 0; i < 10; ++i) ok(cd_chain_step(singly, dts[m], 1));
                assert_int_equal(hash_of(at_once), hash_of(singly));
                cd_chain_destroy(at_once);
                cd_chain_destroy(singly);
            }
        }
    }
}

struct worker {
    pthread_t thread;
    cd_chain* chain;
    int wrong; /* calls that did not do what they should */
};

static void* work(void* argument) { /* asserts nothing: that is for the main thread */
    struct worker* worker = argument;
    for (int i = 0; i < 300; ++i) {
        double dt;
        worker->wrong += cd_chain_step(worker->chain, 0.01 + 0.0001 * (i % 3), 2) != CD_OK;
        worker->wrong += cd_chain_step(worker->chain, -1, 1) != CD_ERROR_VALUE;
        worker->wrong += cd_chain_stable_dt(worker->chain, &dt) != CD_OK;
    }
    return NULL;
}

static void distinct_chains_can_be_stepped_at_the_same_time(void** state) {
    (void)state;
    struct worker workers[4] = {{0}}; /* the first two one after the other, the others, alike, at once */
    for (size_t i = 0; i < 4; ++i)
        workers[i].chain = begin(i % 2 ? scene_everything_ring : scene_everything, 5, 40, 3,
                                 i % 2 ? CD_FLOAT64 : CD_FLOAT32, CD_METHOD_IMPLICIT);
    work(&workers[0]);
    work(&workers[1]);
    for (size_t i = 2; i < 4; ++i) assert_int_equal(pthread_create(&workers[i].thread, NULL, work, &workers[i]), 0);
    for (size_t i = 2; i < 4; ++i) assert_int_equal(pthread_join(workers[i].thread, NULL), 0);
    for (size_t i = 0; i < 4; ++i) {
        assert_int_equal(workers[i].wrong, 0);
        assert_int_equal(hash_of(workers[i].chain), hash_of(workers[i % 2].chain));
    }
    for (size_t i = 0; i < 4; ++i) cd_chain_destroy(workers[i].chain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_job_system_leaves_no_trace),
        cmocka_unit_test(the_job_system_leaves_no_trace_in_ropes),
        cmocka_unit_test(the_parallel_table_is_copied_and_can_be_taken_back),
        cmocka_unit_test(a_strand_does_not_feel_its_neighbours),
        cmocka_unit_test(strands_of_ropes_are_individuals),
        cmocka_unit_test(components_do_not_mix),
        cmocka_unit_test(ten_steps_at_once_are_ten_steps),
        cmocka_unit_test(distinct_chains_can_be_stepped_at_the_same_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
