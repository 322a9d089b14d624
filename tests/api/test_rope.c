/* Springs that have a length: when a chain has them, what it then refuses, and what it tells. What they do as they move
 * is tried in tests/physics. */
#include <math.h>
#include <string.h>

#include "check.h"
#include "scene.h"

enum { STRANDS = 3, SPRINGS = 9, NODES = SPRINGS + 1, COMPONENTS = 3, ALL = STRANDS * NODES * COMPONENTS };

static cd_chain* plain(void) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, CD_FLOAT64);
    scene_lay_out(chain, 0.1);
    return chain;
}

/* Straight, at rest, each spring as long as it should be. */
static cd_chain* rope(void) {
    cd_chain* chain = plain();
    ok(cd_chain_set_rest_length(chain, 0.1 * SPRINGS));
    return chain;
}

static void a_length_is_dealt_out_to_the_springs(void** state) {
    (void)state;
    cd_chain* chain = rope();
    double length = 0, lengths[STRANDS * SPRINGS], positions[2][ALL];
    scene_read(chain, CD_POSITION, positions[0]);
    ok(cd_chain_get_rest_length(chain, &length));
    assert_true(length == 0.1 * SPRINGS);
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
    scene_read(chain, CD_REST_LENGTH, lengths);
    for (size_t i = 0; i < STRANDS * SPRINGS; ++i) assert_true(lengths[i] == length / SPRINGS);
    scene_set(chain, CD_REST_LENGTH, 4, 0.5);
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH)); /* on already: nothing happens */
    assert_true(scene_get(chain, CD_REST_LENGTH, 4) == 0.5);
    ok(cd_chain_get_rest_length(chain, &length)); /* the total last set */
    assert_true(length == 0.1 * SPRINGS);
    ok(cd_chain_set_rest_length(chain, 18)); /* writes the field anew */
    scene_read(chain, CD_REST_LENGTH, lengths);
    for (size_t i = 0; i < STRANDS * SPRINGS; ++i) assert_true(lengths[i] == 2);
    scene_read(chain, CD_POSITION, positions[1]); /* nodes stay where they are */
    assert_same_bits(positions[0], positions[1], ALL);
    ok(cd_chain_set_rest_length(chain, 0));
    refuses(chain, cd_chain_read_f64(chain, CD_REST_LENGTH, 0, 1, 0, 1, out.number, 1), CD_ERROR_UNSUPPORTED, "field");
    ok(cd_chain_set_rest_length(chain, 1));
    refuses(chain, cd_chain_read_f64(chain, CD_REST_LENGTH, 0, 1, 0, 1, out.number, 1), CD_ERROR_DISABLED, "field");
    cd_chain_destroy(chain);
}

static void lengths_in_a_ring_are_dealt_out_to_one_spring_more(void** state) {
    (void)state;
    cd_chain* chain = rope();
    ok(cd_chain_enable_field(chain, CD_REST_LENGTH));
    scene_set(chain, CD_TENSION, 2, 3);
    ok(cd_chain_set_ring(chain, 1));
    double values[STRANDS * NODES];
    scene_read(chain, CD_REST_LENGTH, values);
    for (size_t i = 0; i < NODES; ++i) assert_true(values[i] == 0.1 * SPRINGS / NODES);
    scene_read(chain, CD_TENSION, values);
    for (size_t i = 0; i < STRANDS * NODES; ++i) assert_true(values[i] == 0);
    ok(cd_chain_set_ring(chain, 0));
    assert_true(scene_get(chain, CD_REST_LENGTH, 0) == 0.1 * SPRINGS / SPRINGS);
    cd_chain_destroy(chain);
}

static void tensions_are_each_strands_own_and_begin_at_0(void** state) {
    (void)state;
    cd_chain* chain = rope();
    double tension[STRANDS * SPRINGS], again[STRANDS * SPRINGS];
    float singles[2] = {7, 7};
    scene_read(chain, CD_TENSION, tension);
    for (size_t i = 0; i < STRANDS * SPRINGS; ++i) assert_true(tension[i] == 0);
    for (size_t i = 0; i < STRANDS * SPRINGS; ++i) tension[i] = 0.5 + (double)i;
    scene_write(chain, CD_TENSION, tension);
    scene_read(chain, CD_TENSION, again);
    assert_same_bits(tension, again, STRANDS * SPRINGS);
    ok(cd_chain_read_f32(chain, CD_TENSION, 2, 1, 3, 2, singles, 2));
    assert_true(singles[0] == (float)tension[2 * SPRINGS + 3] && singles[1] == (float)tension[2 * SPRINGS + 4]);
    ok(cd_chain_set_rest_length(chain, 5)); /* another length is no reason to forget them */
    scene_read(chain, CD_TENSION, again);
    assert_same_bits(tension, again, STRANDS * SPRINGS);
    ok(cd_chain_reset(chain));
    scene_read(chain, CD_TENSION, again);
    for (size_t i = 0; i < STRANDS * SPRINGS; ++i) assert_true(again[i] == 0);
    scene_write(chain, CD_TENSION, tension);
    ok(cd_chain_set_rest_length(chain, 0));
    ok(cd_chain_set_rest_length(chain, 5));
    scene_read(chain, CD_TENSION, again);
    for (size_t i = 0; i < STRANDS * SPRINGS; ++i) assert_true(again[i] == 0);
    cd_chain_destroy(chain);
}

/* A rope that hangs at rest, from a guess far off and from none: the tension is the weight below. */
static void a_step_starts_from_the_tension_and_leaves_another(void** state) {
    (void)state;
    const double gravity[COMPONENTS] = {8, 0, 0};
    for (int guessed = 0; guessed <= 1; ++guessed) {
        cd_chain* chain = rope();
        double tension[STRANDS * SPRINGS];
        ok(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_PINNED));
        ok(cd_chain_set_gravity(chain, gravity, COMPONENTS));
        ok(cd_chain_set_stiffness(chain, INFINITY));
        for (size_t i = 0; i < STRANDS * SPRINGS; ++i) tension[i] = guessed ? 100.0 * (double)(i + 1) : 0;
        scene_write(chain, CD_TENSION, tension);
        ok(cd_chain_step(chain, 0.01, 1));
        scene_read(chain, CD_TENSION, tension);
        for (size_t strand = 0; strand < STRANDS; ++strand)
            for (size_t i = 0; i < SPRINGS; ++i)
                assert_near(tension[strand * SPRINGS + i], 8.0 * (double)(SPRINGS - i) / NODES, 1e-9, 0);
        cd_chain_destroy(chain);
    }
}

/* What there is no rope of. */
static void four_components_and_no_spring_make_no_rope(void** state) {
    (void)state;
    cd_chain *four = scene_chain(1, 3, 4, CD_FLOAT32), *none = scene_chain(2, 0, 3, CD_FLOAT64);
    refuses(four, cd_chain_set_rest_length(four, 1.5), CD_ERROR_UNSUPPORTED, "length|1.5|4 components|1 to 3");
    refuses(none, cd_chain_set_rest_length(none, 1.5), CD_ERROR_UNSUPPORTED, "length|1.5|0 springs|needs a spring");
    ok(cd_chain_set_rest_length(four, 0));
    ok(cd_chain_set_rest_length(none, 0));
    ok(cd_chain_set_push(four, 1));
    ok(cd_chain_set_tolerance(none, 1e-3, 5));
    ok(cd_chain_step(four, 0.01, 1));
    ok(cd_chain_step(none, 0.01, 1));
    cd_chain_destroy(four);
    cd_chain_destroy(none);
}

static void forward(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_FORWARD_EULER)); }
static void symplectic(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_SYMPLECTIC_EULER)); }
static void stiff_second(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_STIFF_SECOND)); }
static void implicit(cd_chain* c) { ok(cd_chain_set_method(c, CD_METHOD_IMPLICIT)); }
static void explicit_lambda(cd_chain* c) { ok(cd_chain_set_lambda(c, 0)); }
static void low_lambda(cd_chain* c) { ok(cd_chain_set_lambda(c, nextafter(0.5, 0))); }
static void half(cd_chain* c) { ok(cd_chain_set_lambda(c, 0.5)); }
static void ring(cd_chain* c) { ok(cd_chain_set_ring(c, 1)); }
static void no_ring(cd_chain* c) { ok(cd_chain_set_ring(c, 0)); }
static void damping(cd_chain* c) { ok(cd_chain_set_stiffness_damping(c, 1e-3)); }
static void no_damping(cd_chain* c) { ok(cd_chain_set_stiffness_damping(c, 0)); }
static void first_matched(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_MATCHED)); }
static void first_free(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_FREE)); }
static void last_matched(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_MATCHED)); }
static void last_free(cd_chain* c) { ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_FREE)); }

static const struct lack {
    void (*make)(cd_chain*);
    void (*undo)(cd_chain*);
    const char* text;
} lacks[] = {
    {forward, implicit, "~|length|CD_METHOD_IMPLICIT: see cd_chain_set_method"},
    {symplectic, implicit, "~|length|CD_METHOD_IMPLICIT: see cd_chain_set_method"},
    {stiff_second, implicit, "~|length|CD_METHOD_IMPLICIT: see cd_chain_set_method"},
    {explicit_lambda, half, "~|length|lambda below 1/2: see cd_chain_set_lambda"},
    {low_lambda, half, "~|length|lambda below 1/2: see cd_chain_set_lambda"},
    {ring, no_ring, "~|length|ring: see cd_chain_set_ring"},
    {damping, no_damping, "~|length|stiffness damping: see cd_chain_set_stiffness_damping"},
    {first_matched, first_free, "~|length|matched end: see cd_chain_set_end"},
    {last_matched, last_free, "~|length|matched end: see cd_chain_set_end"},
};

/* In whatever order it comes; and it is the step that says so, unless it makes no steps. */
static void what_ropes_cannot_have_is_told_by_the_step(void** state) {
    (void)state;
    for (size_t i = 0; i < COUNT(lacks); ++i) {
        for (int rope_first = 0; rope_first <= 1; ++rope_first) {
            cd_chain* chain = rope_first ? rope() : plain();
            lacks[i].make(chain);
            if (!rope_first) ok(cd_chain_step(chain, 1e-3, 1));
            ok(cd_chain_set_rest_length(chain, 1));
            refuses(chain, cd_chain_step(chain, 1e-3, 1), CD_ERROR_UNSUPPORTED, lacks[i].text);
            refuses(chain, cd_chain_step(chain, 1e-3, 1000), CD_ERROR_UNSUPPORTED, lacks[i].text);
            ok(cd_chain_step(chain, 1e-3, 0));
            refuses(chain, cd_chain_step(chain, NAN, 1), CD_ERROR_VALUE, "dt|nan");
            lacks[i].undo(chain);
            ok(cd_chain_step(chain, 1e-3, 1));
            lacks[i].make(chain);
            ok(cd_chain_set_rest_length(chain, 0));
            ok(cd_chain_step(chain, 1e-4, 1));
            cd_chain_destroy(chain);
        }
    }
}

static void ropes_have_no_longest_step(void** state) {
    (void)state;
    cd_chain* chain = rope();
    double dt = 0;
    refuses(chain, cd_chain_stable_dt(chain, &out.number[0]), CD_ERROR_UNSUPPORTED, "~|length");
    ok(cd_chain_set_rest_length(chain, 0));
    ok(cd_chain_stable_dt(chain, &dt));
    assert_true(dt > 0);
    cd_chain_destroy(chain);
}

static void only_ropes_have_an_infinite_total_stiffness(void** state) {
    (void)state;
    cd_chain* chain = plain();
    double stiffness = 0;
    refuses(chain, cd_chain_set_stiffness(chain, INFINITY), CD_ERROR_VALUE, "stiffness|inf");
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_get_stiffness(chain, &stiffness));
    assert_true(isinf(stiffness));
    ok(cd_chain_enable_field(chain, CD_STIFFNESS));
    for (size_t i = 0; i < SPRINGS; ++i) assert_true(isinf(scene_get(chain, CD_STIFFNESS, i)));
    for (size_t i = 0; i < SPRINGS; ++i) scene_set(chain, CD_STIFFNESS, i, 2); /* the total is what it was */
    refuses(chain, cd_chain_set_rest_length(chain, 0), CD_ERROR_UNSUPPORTED, "length|0|infinite");
    ok(cd_chain_set_rest_length(chain, 2));
    ok(cd_chain_set_stiffness(chain, 3));
    ok(cd_chain_set_rest_length(chain, 0));
    cd_chain_destroy(chain);
}

/* Without lengths rigid springs are welds, and a welded group holds one held node at the most. */
static void lengths_stay_where_a_weld_would_join_held_nodes(void** state) {
    (void)state;
    for (cd_node a = CD_NODE_PINNED; a <= CD_NODE_DRIVEN; ++a) {
        for (cd_node b = CD_NODE_PINNED; b <= CD_NODE_DRIVEN; ++b) {
            cd_chain* chain = rope();
            double v[STRANDS * COMPONENTS];
            scene_set(chain, CD_PIN, 2, a);
            scene_set(chain, CD_PIN, 4, b);
            for (size_t s = 0; s < STRANDS; ++s) ok(cd_chain_weld(chain, s, 2)); /* only its length is fixed */
            for (size_t s = 0; s < STRANDS; ++s) ok(cd_chain_weld(chain, s, 3));
            scene_set(chain, CD_STIFFNESS, 3, INFINITY);
            refuses(chain, cd_chain_set_rest_length(chain, 0), CD_ERROR_UNSUPPORTED, "length|0|welded");
            refuses(chain, cd_chain_set_rest_length(chain, -0.0), CD_ERROR_UNSUPPORTED, "length|0");
            ok(cd_chain_set_rest_length(chain, 2));
            scene_set(chain, CD_PIN, 4, CD_NODE_FREE);
            for (size_t i = 0; i < STRANDS * COMPONENTS; ++i) v[i] = 1 + (double)i;
            ok(cd_chain_write_f64(chain, CD_VELOCITY, 0, STRANDS, 4, 1, v, STRANDS * COMPONENTS));
            ok(cd_chain_set_rest_length(chain, 0)); /* from now on welded: the group has the held node's velocity */
            double group[STRANDS * COMPONENTS], held[STRANDS * COMPONENTS];
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, STRANDS, 2, 1, held, STRANDS * COMPONENTS));
            ok(cd_chain_read_f64(chain, CD_VELOCITY, 0, STRANDS, 4, 1, group, STRANDS * COMPONENTS));
            assert_same_bits(held, group, STRANDS * COMPONENTS);
            scene_set(chain, CD_PIN, 5, b);
            refuses(chain, cd_chain_weld(chain, 0, 4), CD_ERROR_UNSUPPORTED, "spring|4");
            cd_chain_destroy(chain);
        }
    }
}

static void rigid_springs_of_ropes_are_no_welds(void** state) {
    (void)state;
    const double push[COMPONENTS] = {0, 1, 0};
    double before[ALL], after[ALL];
    cd_chain* chain = rope();
    ok(cd_chain_weld(chain, 0, 3));
    ok(cd_chain_impulse(chain, 1, 4, push, COMPONENTS)); /* takes that node alone along */
    scene_read(chain, CD_VELOCITY, before);
    assert_near(before[(NODES + 4) * COMPONENTS + 1], (double)NODES, 1e-15, 0);
    assert_true(before[(NODES + 3) * COMPONENTS + 1] == 0);
    scene_set(chain, CD_PIN, 3, CD_NODE_PINNED);
    scene_read(chain, CD_VELOCITY, after);
    assert_same_bits(before, after, ALL);
    cd_chain_destroy(chain);
}

/* A length that is switched on and off as it moves, with all that a chain may have besides. */
static void lengths_come_and_go_as_the_chain_moves(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
        size_t plain_bytes = 0, bytes;
        scene_attached(chain);
        for (int round = 0; round < 5; ++round) {
            ok(cd_chain_step(chain, 0.01, 3));
            ok(cd_chain_get_memory(chain, &bytes));
            if (round == 0) plain_bytes = bytes;
            assert_int_equal(bytes, plain_bytes);
            ok(cd_chain_set_rest_length(chain, 0.5 + round));
            ok(cd_chain_step(chain, 0.01, 3));
            ok(cd_chain_set_rest_length(chain, 0));
        }
        cd_chain_destroy(chain);
    }
}

/* Springs of fixed length, masses of all sizes, nodes that fly in all directions: no single iteration solves that. */
static cd_chain* hard(cd_precision precision) {
    cd_chain* chain = scene_chain(STRANDS, SPRINGS, COMPONENTS, precision);
    uint64_t seed = 4;
    ok(cd_chain_set_rest_length(chain, 1));
    ok(cd_chain_set_stiffness(chain, INFINITY));
    ok(cd_chain_enable_field(chain, CD_MASS));
    for (size_t i = 0; i < NODES; ++i) scene_set(chain, CD_MASS, i, pow(10, 3 * scene_noise(&seed)));
    scene_lay_out(chain, 0.11);
    scene_shake(chain, 0.005, 5);
    double v[ALL];
    for (size_t i = 0; i < ALL; ++i) v[i] = 30 * scene_noise(&seed);
    scene_write(chain, CD_VELOCITY, v);
    return chain;
}

static void steps_that_miss_the_tolerance_are_made_all_the_same(void** state) {
    (void)state;
    for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision) {
        cd_chain *chain = hard(precision), *patient = hard(precision);
        uint64_t steps = 0;
        size_t iterations = 0;
        double time = 0, error = 0, x[ALL];
        const uint64_t before = hash_of(chain);
        ok(cd_chain_set_tolerance(chain, 1e-14, 1));
        assert_int_equal(cd_chain_step(chain, 0.125, 4), CD_ERROR_TOLERANCE);
        assert_non_null(strstr(cd_error_message(), "cd_chain_step: "));
        assert_non_null(strstr(cd_error_message(), " iterations, more than the tolerance of 1e-14"));
        ok(cd_chain_get_convergence(chain, NULL, &error));
        assert_non_null(strstr(cd_error_message(), text_of(" %g times a spring's rest length", error)));
        ok(cd_chain_get_steps(chain, &steps));
        ok(cd_chain_get_time(chain, &time));
        assert_int_equal(steps, 4);
        assert_true(time == 0.5 && hash_of(chain) != before);
        ok(cd_chain_get_convergence(chain, &iterations, &error));
        assert_true(error > 1e-14 && iterations >= 1);
        scene_read(chain, CD_POSITION, x);
        for (size_t i = 0; i < ALL; ++i) assert_true(isfinite(x[i]));
        ok(cd_chain_set_tolerance(chain, 1e-4, 1000)); /* and it goes on from there */
        ok(cd_chain_step(chain, 0.125, 1));
        ok(cd_chain_get_convergence(chain, &iterations, &error));
        assert_true(error <= 1e-4 && iterations >= 1);
        ok(cd_chain_set_tolerance(patient, 1e-4, 1000));
        ok(cd_chain_step(patient, 0.125, 4));
        cd_chain_destroy(chain);
        cd_chain_destroy(patient);
    }
}

static void springs_of_no_stiffness_are_cut(void** state) {
    (void)state;
    static const double none[] = {0.0, -0.0}, x[] = {0, 1, 2, 9, 10};
    for (size_t k = 0; k < COUNT(none); ++k)
        for (int push = 0; push < 2; ++push) {
            cd_chain* chain = NULL;
            double error = 1, tension[4], after[5];
            ok(cd_chain_create(1, 4, 1, CD_FLOAT64, NULL, &chain));
            ok(cd_chain_set_rest_length(chain, 4));
            ok(cd_chain_set_push(chain, push));
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 5, x, 5));
            ok(cd_chain_enable_field(chain, CD_STIFFNESS));
            ok(cd_chain_write_f64(chain, CD_STIFFNESS, 0, 1, 2, 1, &none[k], 1));
            ok(cd_chain_step(chain, 0.1, 3));
            ok(cd_chain_get_convergence(chain, NULL, &error));
            assert_true(error == 0);
            ok(cd_chain_read_f64(chain, CD_TENSION, 0, 1, 0, 4, tension, 4));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 5, after, 5));
            for (int i = 0; i < 4; ++i) assert_true(tension[i] == 0);
            for (int i = 0; i < 5; ++i) assert_true(after[i] == x[i]);
            cd_chain_destroy(chain);
        }
}

/* Lengths whose squares are no numbers: nothing can be solved, and the step says so; held nodes stay. */
static void lengths_beyond_all_numbers_are_told(void** state) {
    (void)state;
    const double x[] = {3, 1e200, -1e200, 2e200};
    for (int pinned = 0; pinned < 2; ++pinned)
        for (int push = 0; push < 2; ++push) {
            cd_chain* chain = NULL;
            double error = 0, after[4];
            ok(cd_chain_create(1, 3, 1, CD_FLOAT64, NULL, &chain));
            ok(cd_chain_set_rest_length(chain, 1));
            ok(cd_chain_set_push(chain, push));
            ok(cd_chain_set_end(chain, CD_END_FIRST, pinned ? CD_NODE_PINNED : CD_NODE_FREE));
            ok(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, 4, x, 4));
            assert_int_equal(cd_chain_step(chain, 1e-3, 1), CD_ERROR_TOLERANCE);
            ok(cd_chain_get_convergence(chain, NULL, &error));
            assert_true(isinf(error));
            ok(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, 4, after, 4));
            for (int i = 0; i < 4; ++i) assert_true(after[i] == x[i]);
            cd_chain_destroy(chain);
        }
}

static void convergence_is_told_of_the_last_call(void** state) {
    (void)state;
    cd_chain* chain = hard(CD_FLOAT64);
    size_t iterations = 9;
    double error = 9;
    ok(cd_chain_get_convergence(chain, &iterations, &error));
    assert_true(iterations == 0 && error == 0);
    ok(cd_chain_set_tolerance(chain, 0.5, 1000));
    ok(cd_chain_step(chain, 0.01, 2));
    ok(cd_chain_get_convergence(chain, &iterations, NULL));
    ok(cd_chain_get_convergence(chain, NULL, &error));
    assert_true(iterations >= 1 && error >= 0 && error <= 0.5);
    ok(cd_chain_set_stiffness(chain, 1));
    ok(cd_chain_set_rest_length(chain, 0));
    ok(cd_chain_step(chain, 0.01, 2));
    ok(cd_chain_get_convergence(chain, &iterations, &error));
    assert_true(iterations == 0 && error == 0);
    cd_chain_destroy(chain);
}

/* Energy: of what is longer than its length, and of what is shorter too where springs push; none of rigid springs. */
static void energy_counts_what_springs_are_longer(void** state) {
    (void)state;
    for (int push = 0; push <= 1; ++push) {
        cd_chain* chain = scene_chain(1, 2, 2, CD_FLOAT64);
        const double x[] = {0, 0, 3, 4, 3, 3}; /* 5 and 1 long */
        double kinetic, elastic, gravity;
        ok(cd_chain_set_rest_length(chain, 4)); /* 2 each */
        ok(cd_chain_set_stiffness(chain, 3));   /* 6 each */
        ok(cd_chain_set_push(chain, push));
        scene_write(chain, CD_POSITION, x);
        ok(cd_chain_get_energy(chain, &kinetic, &elastic, &gravity));
        assert_true(kinetic == 0 && gravity == 0 && elastic == 3 * 9 + (push ? 3 * 1 : 0));
        ok(cd_chain_weld(chain, 0, 0));
        ok(cd_chain_get_energy(chain, NULL, &elastic, NULL));
        assert_true(elastic == (push ? 3 * 1 : 0));
        cd_chain_destroy(chain);
    }
}

/* Whatever the tension that a step is told to start from, what lies slack and at rest stays so. */
static void a_wrong_tension_moves_nothing_that_is_slack(void** state) {
    (void)state;
    for (size_t components = 1; components <= 3; ++components) {
        for (int spread = 0; spread <= 1; ++spread) {
            cd_chain* chain = scene_chain(STRANDS, SPRINGS, components, CD_FLOAT64);
            double tension[STRANDS * SPRINGS], x[ALL], after[ALL], kinetic;
            const size_t count = STRANDS * NODES * components;
            if (spread) scene_lay_out(chain, 0.1);
            ok(cd_chain_set_rest_length(chain, 2 * SPRINGS));
            scene_read(chain, CD_POSITION, x);
            for (size_t i = 0; i < STRANDS * SPRINGS; ++i) tension[i] = 100 + (double)i;
            scene_write(chain, CD_TENSION, tension);
            ok(cd_chain_step(chain, 0.01, 3));
            ok(cd_chain_get_energy(chain, &kinetic, NULL, NULL));
            scene_read(chain, CD_POSITION, after);
            for (size_t i = 0; i < count; ++i) assert_near(after[i], x[i], 1e-9, 1);
            assert_true(kinetic < 1e-12);
            cd_chain_destroy(chain);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_length_is_dealt_out_to_the_springs),
        cmocka_unit_test(lengths_in_a_ring_are_dealt_out_to_one_spring_more),
        cmocka_unit_test(tensions_are_each_strands_own_and_begin_at_0),
        cmocka_unit_test(a_step_starts_from_the_tension_and_leaves_another),
        cmocka_unit_test(four_components_and_no_spring_make_no_rope),
        cmocka_unit_test(what_ropes_cannot_have_is_told_by_the_step),
        cmocka_unit_test(ropes_have_no_longest_step),
        cmocka_unit_test(only_ropes_have_an_infinite_total_stiffness),
        cmocka_unit_test(lengths_stay_where_a_weld_would_join_held_nodes),
        cmocka_unit_test(rigid_springs_of_ropes_are_no_welds),
        cmocka_unit_test(lengths_come_and_go_as_the_chain_moves),
        cmocka_unit_test(steps_that_miss_the_tolerance_are_made_all_the_same),
        cmocka_unit_test(springs_of_no_stiffness_are_cut),
        cmocka_unit_test(lengths_beyond_all_numbers_are_told),
        cmocka_unit_test(convergence_is_told_of_the_last_call),
        cmocka_unit_test(energy_counts_what_springs_are_longer),
        cmocka_unit_test(a_wrong_tension_moves_nothing_that_is_slack),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
