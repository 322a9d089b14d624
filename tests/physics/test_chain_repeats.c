/* A long chain that is uniform but for one place, or up to one place and beyond: what is there counts, as it does where
 * no two nodes are alike. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "reference.h"

enum { SPRINGS = 600, NODES = SPRINGS + 1, COMPONENTS = 2, PLACE = 391 };

enum change { NOTHING, HEAVY, SOFT, CUT, WELDED, STIFF_JOINT, LIMP, TIED, DAMPED, PINNED, DRIVEN, CHANGES };

struct kind {
    size_t strands;
    int bends, ring, half_ends, beyond; /* beyond: the change is made of all that follows, too */
};

/* alike: all other nodes are; else masses differ from each other by a part of 1e-12. */
static cd_chain* make(enum change change, const struct kind* kind, int alike) {
    const size_t strands = kind->strands;
    cd_chain* c = NULL;
    ok(cd_chain_create(strands, SPRINGS, COMPONENTS, CD_FLOAT64, NULL, &c));
    ok(cd_chain_set_mass(c, NODES));
    ok(cd_chain_set_stiffness(c, 3e3 / SPRINGS));
    if (kind->bends) ok(cd_chain_set_bend(c, 3e3 / ((double)SPRINGS * SPRINGS * SPRINGS)));
    ok(cd_chain_set_ring(c, kind->ring));
    if (kind->half_ends) ok(cd_chain_set_mass_rule(c, CD_MASS_HALF_ENDS));
    if (!kind->ring && !kind->half_ends) ok(cd_chain_set_end(c, CD_END_FIRST, CD_NODE_PINNED));
    if (!kind->ring && !kind->bends) ok(cd_chain_set_end(c, CD_END_LAST, CD_NODE_MATCHED));
    ok(cd_chain_set_drag(c, 0.1));
    double x[NODES * COMPONENTS];
    uint64_t seed = 5;
    if (kind->half_ends) ok(cd_chain_enable_field(c, CD_FORCE));
    for (size_t s = 0; s < strands; ++s) {
        for (size_t i = 0; i < COUNT(x); ++i) x[i] = random_number(&seed);
        ok(cd_chain_write_f64(c, CD_POSITION, s, 1, 0, NODES, x, COUNT(x)));
        if (kind->half_ends) ok(cd_chain_write_f64(c, CD_FORCE, s, 1, 0, NODES, x, COUNT(x)));
    }
    const struct {
        enum change change;
        cd_field field;
        double value;
    } fields[] = {{HEAVY, CD_MASS, 4},
                  {SOFT, CD_STIFFNESS, 0.1},
                  {CUT, CD_STIFFNESS, 0},
                  {WELDED, CD_STIFFNESS, INFINITY},
                  {STIFF_JOINT, CD_BEND, 50},
                  {LIMP, CD_BEND, 0},
                  {PINNED, CD_PIN, CD_NODE_PINNED},
                  {DRIVEN, CD_PIN, CD_NODE_DRIVEN}};
    for (size_t k = 0; k < COUNT(fields); ++k) {
        if (fields[k].change != change) continue;
        ok(cd_chain_enable_field(c, fields[k].field));
        const int per_node = fields[k].field == CD_PIN || fields[k].field == CD_MASS;
        const size_t last = kind->beyond ? (per_node ? NODES - 20 : SPRINGS - 20) : PLACE;
        for (size_t i = PLACE; i <= last; ++i)
            ok(cd_chain_write_f64(c, fields[k].field, 0, 1, i, 1, &fields[k].value, 1));
    }
    const double target[COMPONENTS] = {2, -1}, speed[COMPONENTS] = {1, 3};
    if (change == TIED || change == DAMPED)
        ok(cd_chain_attach(c, 0, PLACE, change == TIED ? 30 : 0, change == TIED ? 0 : 30, target, COMPONENTS));
    for (size_t s = 0; s < strands && change == DRIVEN; ++s)
        ok(cd_chain_write_f64(c, CD_VELOCITY, s, 1, PLACE, 1, speed, COMPONENTS));
    if (!alike) {
        double mass[NODES];
        ok(cd_chain_enable_field(c, CD_MASS));
        ok(cd_chain_read_f64(c, CD_MASS, 0, 1, 0, NODES, mass, NODES));
        for (size_t i = 0; i < NODES; ++i) mass[i] *= 1 + 1e-13 * (double)(i % 7);
        ok(cd_chain_write_f64(c, CD_MASS, 0, 1, 0, NODES, mass, NODES));
    }
    return c;
}

static void one_place_in_a_uniform_chain_counts(void** state) {
    (void)state;
    for (int change = 0; change < CHANGES; ++change)
        for (int k = 0; k < 32; ++k) {
            const struct kind kind = {k & 1 ? 6 : 1, (k & 2) != 0, (k & 4) != 0, (k & 8) != 0, (k & 16) != 0};
            const size_t count = kind.strands * NODES * COMPONENTS;
            if ((change == STIFF_JOINT || change == LIMP) && !kind.bends) continue;
            static double x[2][6 * NODES * COMPONENTS];
            double off = 0;
            for (int alike = 0; alike < 2; ++alike) {
                cd_chain* const c = make((enum change)change, &kind, alike);
                for (int step = 0; step < 10; ++step) ok(cd_chain_step(c, 0.02 + 0.001 * step, 1));
                ok(cd_chain_read_f64(c, CD_POSITION, 0, kind.strands, 0, NODES, x[alike], count));
                cd_chain_destroy(c);
            }
            for (size_t i = 0; i < count; ++i) off = fmax(off, fabs(x[0][i] - x[1][i]));
            if (!(off < 1e-9)) print_message("change %d of kind %d: off by %.1e\n", change, k, off);
            assert_true(off < 1e-9);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_place_in_a_uniform_chain_counts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
