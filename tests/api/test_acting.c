/* Acting on a chain and measuring it: impulses, soft ties, samples, energy and momentum, against their definitions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 2, ALL = STRANDS * NODES * COMPONENTS };

static cd_chain* everything(scene_build* build, cd_precision precision) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    build(chain);
    return chain;
}

static size_t place(size_t strand, size_t node, size_t component) {
    return (strand * NODES + node) * COMPONENTS + component;
}

/* The nodes that welds join to a node, it among them. */
static void group_of(const cd_chain* chain, size_t node, int* in_group) {
    memset(in_group, 0, NODES * sizeof *in_group);
    in_group[node] = 1;
    for (size_t pass = 0; pass < NODES; ++pass)
        for (size_t s = 0; s < scene_springs(chain); ++s)
            if (isinf(scene_get(chain, CD_STIFFNESS, s)) && (in_group[s] || in_group[(s + 1) % NODES]))
                in_group[s] = in_group[(s + 1) % NODES] = 1;
}

static void an_impulse_changes_velocity_by_impulse_over_mass(void** state) {
    (void)state;
    scene_build* const builds[] = {scene_everything, scene_everything_ring};
    for (size_t b = 0; b < COUNT(builds); ++b) {
        cd_chain* chain = everything(builds[b], CD_FLOAT64);
        size_t free_nodes = 0, in_welds = 0;
        for (size_t node = 0; node < NODES; ++node) {
            const double impulse[COMPONENTS] = {0.75, -0.5 - (double)node};
            double before[ALL], after[ALL], mass = 0, momentum[2 * COMPONENTS];
            int group[NODES];
            group_of(chain, node, group);
            int held = 0;
            size_t members = 0;
            for (size_t i = 0; i < NODES; ++i) {
                if (!group[i]) continue;
                const double kind = scene_get(chain, CD_PIN, i);
                held |= kind == CD_NODE_PINNED || kind == CD_NODE_DRIVEN;
                mass += scene_get(chain, CD_MASS, i);
                ++members;
            }
            free_nodes += !held;
            in_welds += members > 1;
            scene_read(chain, CD_VELOCITY, before);
            ok(cd_chain_get_momentum(chain, momentum, COMPONENTS));
            ok(cd_chain_impulse(chain, 1, node, impulse, COMPONENTS));
            scene_read(chain, CD_VELOCITY, after);
            ok(cd_chain_get_momentum(chain, momentum + COMPONENTS, COMPONENTS));
            for (size_t strand = 0; strand < STRANDS; ++strand)
                for (size_t i = 0; i < NODES; ++i)
                    for (size_t c = 0; c < COMPONENTS; ++c) {
                        const size_t at = place(strand, i, c);
                        if (strand == 1 && group[i] && !held)
                            assert_near(after[at], before[at] + impulse[c] / mass, 1e-14, 1);
                        else assert_true(after[at] == before[at]);
                    }
            for (size_t c = 0; c < COMPONENTS; ++c)
                assert_near(momentum[COMPONENTS + c], momentum[c] + (held ? 0 : impulse[c]), 1e-13, 1);
        }
        assert_true(free_nodes >= 6 && free_nodes < NODES && in_welds == 2);
        cd_chain_destroy(chain);
    }
}

struct one_node {
    double mass, stiffness, damping, drag, gravity; /* of a node tied to the origin */
};

/* A step of one node: the equations of chain.h, with numbers for matrices. */
static void step_one_node(const struct one_node* p, cd_method method, double lambda, double dt, double* x, double* v) {
    const double C = p->drag * p->mass + p->damping, K = p->stiffness, f = p->mass * p->gravity;
    if (method != CD_METHOD_IMPLICIT) lambda = 0;
    const double resists = p->mass + lambda * dt * C + lambda * lambda * dt * dt * K;
    const double dv = dt * (f - K * (*x + lambda * dt * *v) - C * *v) / resists;
    *x += dt * (method == CD_METHOD_SYMPLECTIC_EULER ? *v + dv : *v + lambda * dv);
    *v += dv;
}

static void a_tied_node_moves_as_the_equation_says(void** state) {
    (void)state;
    static const struct {
        cd_method method;
        double lambda;
    } ways[] = {{CD_METHOD_IMPLICIT, 0.5},      {CD_METHOD_IMPLICIT, 1},           {CD_METHOD_IMPLICIT, 0.75},
                {CD_METHOD_FORWARD_EULER, 0.5}, {CD_METHOD_SYMPLECTIC_EULER, 0.5}, {CD_METHOD_IMPLICIT, 0}};
    const struct one_node p = {.mass = 0.5, .stiffness = 30, .damping = 0.75, .drag = 0.25, .gravity = -9.81};
    for (size_t i = 0; i < COUNT(ways); ++i) {
        cd_chain* chain = scene_chain(1, 0, 1, CD_FLOAT64);
        const double target = 3, start = 0.25;
        double x = start - target, v = 0, got;
        scene_write(chain, CD_POSITION, &start);
        ok(cd_chain_set_mass(chain, p.mass));
        ok(cd_chain_set_drag(chain, p.drag));
        ok(cd_chain_set_gravity(chain, &p.gravity, 1));
        ok(cd_chain_attach(chain, 0, 0, p.stiffness, p.damping, &target, 1));
        ok(cd_chain_set_method(chain, ways[i].method));
        ok(cd_chain_set_lambda(chain, ways[i].lambda));
        for (int step = 0; step < 50; ++step) {
            ok(cd_chain_step(chain, 0.01, 1));
            step_one_node(&p, ways[i].method, ways[i].lambda, 0.01, &x, &v);
            scene_read(chain, CD_POSITION, &got);
            assert_near(got, x + target, 1e-13, 1);
            scene_read(chain, CD_VELOCITY, &got);
            assert_near(got, v, 1e-12, 1);
        }
        cd_chain_destroy(chain);
    }
}

static void a_tiny_lambda_is_nearly_zero_lambda(void** state) {
    (void)state;
    static const double tiny[] = {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-18, 1e-300};
    for (size_t i = 0; i < COUNT(tiny); ++i) {
        cd_chain* chain = scene_chain(1, 0, 1, CD_FLOAT64);
        const double gravity = -1;
        double v = 1;
        scene_write(chain, CD_VELOCITY, &v);
        ok(cd_chain_set_gravity(chain, &gravity, 1));
        ok(cd_chain_set_lambda(chain, tiny[i]));
        ok(cd_chain_step(chain, 0.01, 100));
        scene_read(chain, CD_VELOCITY, &v);
        assert_near(v, 0, 1e-6, 1);
        cd_chain_destroy(chain);
    }
}

static void a_damped_tie_comes_to_rest_where_forces_balance(void** state) {
    (void)state;
    for (cd_method method = CD_METHOD_IMPLICIT; method <= CD_METHOD_STIFF_SECOND; ++method) {
        cd_chain* chain = scene_chain(2, 0, 1, CD_FLOAT64);
        const double gravity = -8, target = 2, moved[2] = {-1, 5};
        double x[2];
        ok(cd_chain_set_gravity(chain, &gravity, 1));
        ok(cd_chain_set_method(chain, method));
        ok(cd_chain_attach(chain, 0, 0, 16, 4, &target, 1));
        ok(cd_chain_step(chain, 0.0625, 400));
        scene_read(chain, CD_POSITION, x);
        assert_near(x[0], 1.5, 1e-12, 1);
        assert_near(x[1], 1.5, 1e-12, 1);
        scene_write(chain, CD_TARGET, moved); /* the tie follows, in each strand its own */
        ok(cd_chain_step(chain, 0.0625, 400));
        scene_read(chain, CD_POSITION, x);
        assert_near(x[0], -1.5, 1e-12, 1);
        assert_near(x[1], 4.5, 1e-12, 1);
        ok(cd_chain_attach(chain, 0, 0, 32, 4, NULL, 1)); /* again: other numbers, the present place */
        ok(cd_chain_step(chain, 0.0625, 400));
        scene_read(chain, CD_POSITION, x);
        assert_near(x[0], -1.75, 1e-12, 1);
        assert_near(x[1], 4.25, 1e-12, 1);
        cd_chain_destroy(chain);
    }
}

static void ties_are_told_and_loosened(void** state) {
    (void)state;
    for (int how = 0; how < 2; ++how) {
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
        cd_chain* never = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
        scene_rope(chain);
        scene_rope(never);
        double stiffness = -1, damping = -1, x[ALL], target[ALL], y[ALL];
        ok(cd_chain_attach(chain, 0, 4, 12, 0.5, NULL, COMPONENTS));
        ok(cd_chain_get_attachment(chain, 0, 4, &stiffness, &damping));
        assert_true(stiffness == 12 && damping == 0.5);
        ok(cd_chain_get_attachment(chain, 0, 5, &stiffness, &damping));
        assert_true(stiffness == 0 && damping == 0);
        scene_read(chain, CD_POSITION, x);
        scene_read(chain, CD_TARGET, target);
        for (size_t s = 0; s < STRANDS; ++s)
            for (size_t c = 0; c < COMPONENTS; ++c) assert_true(target[place(s, 4, c)] == x[place(s, 4, c)]);
        if (how == 0) ok(cd_chain_detach(chain, 0, 4));
        else ok(cd_chain_disable_field(chain, CD_TARGET));
        ok(cd_chain_detach(chain, 0, 4)); /* nothing is tied there: no error */
        ok(cd_chain_get_attachment(chain, 0, 4, &stiffness, &damping));
        assert_true(stiffness == 0 && damping == 0);
        ok(cd_chain_step(chain, 0.01, 50));
        ok(cd_chain_step(never, 0.01, 50));
        scene_read(chain, CD_POSITION, x);
        scene_read(never, CD_POSITION, y);
        for (size_t i = 0; i < ALL; ++i) assert_near(x[i], y[i], 1e-12, 1);
        cd_chain_destroy(chain);
        cd_chain_destroy(never);
    }
}

static void samples_lie_on_the_straight_lines_between_nodes(void** state) {
    (void)state;
    for (int32_t ring = 0; ring <= 1; ++ring) {
        cd_chain* chain = everything(ring ? scene_everything_ring : scene_everything, CD_FLOAT64);
        enum { PARTS = 8, MOST = NODES * PARTS + 1 };
        const size_t n = (size_t)(SPRINGS + ring) * PARTS + 1;
        double at[MOST], sampled[MOST * COMPONENTS], x[ALL];
        for (size_t j = 0; j < n; ++j) at[j] = (double)(n - 1 - j) / PARTS; /* any order */
        scene_read(chain, CD_POSITION, x);
        for (size_t strand = 0; strand < STRANDS; ++strand) {
            ok(cd_chain_sample(chain, strand, at, n, CD_OUTSIDE_REFUSED, sampled, n * COMPONENTS));
            for (size_t j = 0; j < n; ++j)
                for (size_t c = 0; c < COMPONENTS; ++c) {
                    const size_t node = (size_t)at[j];
                    const double share = at[j] - (double)node, a = x[place(strand, node % NODES, c)];
                    const double b = x[place(strand, (node + 1) % NODES, c)];
                    if (share == 0) assert_true(sampled[j * COMPONENTS + c] == a);
                    else assert_near(sampled[j * COMPONENTS + c], a + share * (b - a), 1e-15, 1);
                }
        }
        cd_chain_destroy(chain);
    }
    cd_chain* one = scene_chain(1, 0, 1, CD_FLOAT32);
    const double x = 3.5, zero = 0;
    double sampled;
    scene_write(one, CD_POSITION, &x);
    ok(cd_chain_sample(one, 0, &zero, 1, CD_OUTSIDE_REFUSED, &sampled, 1));
    assert_true(sampled == 3.5);
    cd_chain_destroy(one);
}

static void places_outside_are_refused_or_the_nearest(void** state) {
    (void)state;
    cd_chain* chain = everything(scene_everything, CD_FLOAT64);
    const double outside[4] = {-1e300, -INFINITY, SPRINGS + 1e-9, INFINITY}, ends[4] = {0, 0, SPRINGS, SPRINGS};
    const double none[2] = {1, NAN};
    double told[4 * COMPONENTS], wanted[4 * COMPONENTS];
    ok(cd_chain_sample(chain, 1, ends, 4, CD_OUTSIDE_REFUSED, wanted, 4 * COMPONENTS));
    ok(cd_chain_sample(chain, 1, outside, 4, CD_OUTSIDE_NEAREST, told, 4 * COMPONENTS));
    assert_memory_equal(told, wanted, sizeof told);
    for (int k = 0; k < 4; ++k)
        refuses(chain, cd_chain_sample(chain, 1, outside + k, 1, CD_OUTSIDE_REFUSED, told, COMPONENTS), CD_ERROR_VALUE,
                "at");
    refuses(chain, cd_chain_sample(chain, 1, none, 2, CD_OUTSIDE_NEAREST, told, 2 * COMPONENTS), CD_ERROR_VALUE,
            "at[1]|nan");
    refuses(chain, cd_chain_sample(chain, 1, none, 1, 2, told, COMPONENTS), CD_ERROR_ENUM, "outside|2");
    assert_memory_equal(told, wanted, sizeof told);
    cd_chain_destroy(chain);
}

static void energy_and_momentum_are_the_sums_of_the_header(void** state) {
    (void)state;
    scene_build* const builds[] = {scene_everything, scene_everything_ring};
    for (size_t b = 0; b < COUNT(builds); ++b) {
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
            cd_chain* chain = everything(builds[b], precision);
            ok(cd_chain_step(chain, 0.01, 5));
            double x[ALL], v[ALL], target[ALL], g[COMPONENTS];
            scene_read(chain, CD_POSITION, x);
            scene_read(chain, CD_VELOCITY, v);
            scene_read(chain, CD_TARGET, target);
            ok(cd_chain_get_gravity(chain, g, COMPONENTS));
            long double kinetic = 0, stretch = 0, bend = 0, ties = 0, fall = 0, momentum[COMPONENTS] = {0};
            for (size_t j = 0; j < ALL; ++j) {
                const size_t strand = j / COMPONENTS / NODES, node = j / COMPONENTS % NODES, c = j % COMPONENTS;
                const double next = x[place(strand, (node + 1) % NODES, c)], m = scene_get(chain, CD_MASS, node);
                const double last = x[place(strand, (node + NODES - 1) % NODES, c)];
                const double kind = scene_get(chain, CD_PIN, node);
                if (kind == CD_NODE_FREE || kind == CD_NODE_MATCHED) {
                    kinetic += 0.5 * m * v[j] * v[j];
                    fall -= m * g[c] * x[j];
                    momentum[c] += m * v[j];
                }
                if (node < scene_springs(chain)) {
                    const double k = scene_get(chain, CD_STIFFNESS, node);
                    if (!isinf(k)) stretch += 0.5 * k * (next - x[j]) * (next - x[j]);
                }
                if ((node > 0 && node < NODES - 1) || scene_springs(chain) == NODES) {
                    const double curve = next - 2 * x[j] + last;
                    bend += 0.5 * scene_get(chain, CD_BEND, node) * curve * curve;
                }
                double k, damping;
                ok(cd_chain_get_attachment(chain, 0, node, &k, &damping));
                ties += 0.5 * k * (x[j] - target[j]) * (x[j] - target[j]);
            }
            double told[3], told_momentum[COMPONENTS];
            ok(cd_chain_get_energy(chain, &told[0], &told[1], &told[2]));
            ok(cd_chain_get_momentum(chain, told_momentum, COMPONENTS));
            assert_true(kinetic > 0 && stretch > 0 && bend > 0 && ties > 0 && fall != 0);
            assert_near(told[0], (double)kinetic, 1e-14, 0);
            assert_near(told[1], (double)(stretch + bend + ties), 1e-13, 0);
            assert_near(told[2], (double)fall, 1e-13, 1);
            for (size_t c = 0; c < COMPONENTS; ++c) assert_near(told_momentum[c], (double)momentum[c], 1e-13, 1);
            double alone = -1;
            ok(cd_chain_get_energy(chain, NULL, &alone, NULL));
            assert_true(alone == told[1]);
            cd_chain_destroy(chain);
        }
    }
}

/* What has no stiffness holds no energy, however long it is; what else overflows is told as infinite. */
static void what_is_cut_or_loose_holds_no_energy_at_any_length(void** state) {
    (void)state;
    static const double x[] = {0, 1, 1e300}, targets[] = {0, 1, 0};
    cd_chain* chain = scene_chain(1, 2, 1, CD_FLOAT64);
    double elastic;
    scene_write(chain, CD_POSITION, x);
    ok(cd_chain_enable_field(chain, CD_TARGET));
    scene_write(chain, CD_TARGET, targets);
    ok(cd_chain_get_energy(chain, NULL, &elastic, NULL));
    assert_true(elastic == HUGE_VAL);
    ok(cd_chain_cut(chain, 0, 1));
    ok(cd_chain_get_energy(chain, NULL, &elastic, NULL));
    assert_near(elastic, 0.5 * scene_get(chain, CD_STIFFNESS, 0), 1e-15, 0);
    cd_chain_destroy(chain);
}

static void forces_act_until_they_are_overwritten(void** state) {
    (void)state;
    cd_chain* chain = scene_chain(2, 0, 1, CD_FLOAT64);
    const double force[2] = {3, -1}, none[2] = {0, 0};
    double v[2];
    ok(cd_chain_set_mass(chain, 0.5));
    ok(cd_chain_enable_field(chain, CD_FORCE));
    scene_write(chain, CD_FORCE, force);
    ok(cd_chain_step(chain, 0.125, 8));
    scene_read(chain, CD_VELOCITY, v);
    assert_true(v[0] == 6 && v[1] == -2);
    scene_write(chain, CD_FORCE, none);
    ok(cd_chain_step(chain, 0.125, 8));
    scene_read(chain, CD_VELOCITY, v);
    assert_true(v[0] == 6 && v[1] == -2);
    cd_chain_destroy(chain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_impulse_changes_velocity_by_impulse_over_mass),
        cmocka_unit_test(a_tied_node_moves_as_the_equation_says),
        cmocka_unit_test(a_tiny_lambda_is_nearly_zero_lambda),
        cmocka_unit_test(a_damped_tie_comes_to_rest_where_forces_balance),
        cmocka_unit_test(ties_are_told_and_loosened),
        cmocka_unit_test(samples_lie_on_the_straight_lines_between_nodes),
        cmocka_unit_test(places_outside_are_refused_or_the_nearest),
        cmocka_unit_test(energy_and_momentum_are_the_sums_of_the_header),
        cmocka_unit_test(what_is_cut_or_loose_holds_no_energy_at_any_length),
        cmocka_unit_test(forces_act_until_they_are_overwritten),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
