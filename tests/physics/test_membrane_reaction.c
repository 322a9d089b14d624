/* The force of a sheet on its nodes: minus the gradient of its energy, and at rest what it carries. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "cloth.h"
#include "sheet.h"

enum { NU = 6, NV = 5 };

static double elastic(const cd_membrane* m) {
    double energy;
    ok(cd_membrane_get_energy(m, NULL, &energy, NULL));
    return energy;
}

/* The slope of the energy at one number, by differences on both sides. */
static double slope(cd_membrane* m, size_t u, size_t v, size_t components, size_t k, double step) {
    double x[4], energy[2];
    ok(cd_membrane_read_f64(m, CD_POSITION, u, v, 1, 1, x, components));
    const double here = x[k];
    for (int side = 0; side < 2; ++side) {
        x[k] = here + (side ? step : -step);
        ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, components));
        energy[side] = elastic(m);
    }
    x[k] = here;
    ok(cd_membrane_write_f64(m, CD_POSITION, u, v, 1, 1, x, components));
    return (energy[1] - energy[0]) / (2 * step);
}

static void check_forces(cd_membrane* m, const char* name) {
    const struct cloth_extent nodes = cloth_extent(m, CD_POSITION);
    const size_t components = nodes.components;
    double(*force)[4] = calloc(nodes.columns * nodes.rows, sizeof *force), largest = 0;
    for (size_t v = 0; v < nodes.rows; ++v)
        for (size_t u = 0; u < nodes.columns; ++u) {
            double* const here = force[v * nodes.columns + u];
            ok(cd_membrane_get_reaction(m, u, v, here, components));
            for (size_t k = 0; k < components; ++k) largest = fmax(largest, fabs(here[k]));
        }
    assert_true(largest > 0);
    for (size_t v = 0; v < nodes.rows; ++v)
        for (size_t u = 0; u < nodes.columns; ++u) {
            double tie, damping, x[4], target[4] = {0};
            ok(cd_membrane_get_attachment(m, u, v, &tie, &damping));
            ok(cd_membrane_read_f64(m, CD_POSITION, u, v, 1, 1, x, components));
            if (tie > 0) ok(cd_membrane_read_f64(m, CD_TARGET, u, v, 1, 1, target, components));
            for (size_t k = 0; k < components; ++k) {
                const double tied = tie > 0 ? tie * (x[k] - target[k]) : 0;
                const double is = force[v * nodes.columns + u][k];
                const double as = tied - slope(m, u, v, components, k, 1e-6);
                if (!(fabs(is - as) <= 1e-6 * largest))
                    print_message("%s, node %zu, %zu, component %zu\n", name, u, v, k);
                assert_near(is, as, 1e-6, largest);
            }
        }
    free(force);
}

static void is_the_gradient_of_energy(void** state) {
    (void)state;
    for (size_t scene = 0; scene < CLOTHS + LENGTH_CLOTHS; ++scene)
        for (size_t components = scene < CLOTHS ? 1 : 3; components <= (scene < CLOTHS ? 4 : 3); ++components) {
            const struct cloth_scene* what = scene < CLOTHS ? &cloths[scene] : &length_cloths[scene - CLOTHS];
            cd_membrane* m = cloth(NU, NV, components, CD_FLOAT64);
            what->build(m);
            cloth_shake(m, 0.02, 7 + scene);
            check_forces(m, what->name);
            cd_membrane_destroy(m);
        }
    /* Of the smallest sheets and rings a node's neighbours on both sides may be one node, or none. */
    static const struct {
        const char* name;
        size_t nu, nv;
        int ring_u, ring_v;
    } small[] = {{"a spring", 1, 0, 0, 0}, {"two springs", 0, 2, 0, 0}, {"a cell", 1, 1, 0, 0},
                 {"cells", 2, 1, 0, 0},    {"a ring", 2, 0, 1, 0},      {"a tube", 1, 2, 0, 1},
                 {"a torus", 2, 2, 1, 1},  {"a larger one", 3, 2, 1, 1}};
    for (size_t i = 0; i < COUNT(small); ++i)
        for (int lengths = 0; lengths < (small[i].nu > 0 && small[i].nv > 0 ? 2 : 1); ++lengths) {
            cd_membrane* m = cloth(small[i].nu, small[i].nv, 3, CD_FLOAT64);
            ok(cd_membrane_set_ring(m, small[i].ring_u, small[i].ring_v));
            ok(cd_membrane_set_stiffness(m, 3, 5));
            ok(cd_membrane_set_bend(m, 0.1));
            if (lengths) {
                ok(cd_membrane_set_rest_length(m, 0.9 * (double)small[i].nu, 0.8 * (double)small[i].nv));
                ok(cd_membrane_set_shear(m, 2));
            }
            cloth_lay_out(m, 1);
            cloth_shake(m, 0.3, i);
            check_forces(m, small[i].name);
            cd_membrane_destroy(m);
        }
}

/* Of all forces on held nodes, what is missing of the weight of the others: a part of it. */
static double missing_weight(cd_membrane* m, double weight) {
    double held = 0;
    for (size_t v = 0; v <= NV; ++v)
        for (size_t u = 0; u <= NU; ++u) {
            double force[3];
            ok(cd_membrane_get_reaction(m, u, v, force, 3));
            if (sheet_get(m, CD_PIN, u, v) != CD_NODE_FREE) held += force[2];
        }
    return fabs(held / weight + 1);
}

/* What holds a sheet at rest carries it: a sheet of springs without a length, and cloth, by two corners. */
static void what_holds_a_sheet_carries_it(void** state) {
    (void)state;
    for (int lengths = 0; lengths < 2; ++lengths) {
        cd_membrane* m = cloth(NU, NV, 3, CD_FLOAT64);
        cloth_lay_out(m, 0.1);
        ok(cd_membrane_set_stiffness(m, 300, 300));
        ok(cd_membrane_set_bend(m, 1e-3));
        if (lengths) {
            ok(cd_membrane_set_rest_length(m, 0.1 * NU, 0.1 * NV));
            ok(cd_membrane_set_shear(m, 100));
        }
        ok(cd_membrane_set_gravity(m, (double[3]){0, 0, -9.81}, 3));
        ok(cd_membrane_set_lambda(m, 1));
        ok(cd_membrane_set_drag(m, 3));
        ok(cd_membrane_enable_field(m, CD_PIN));
        for (size_t u = 0; u <= NU; u += NU) sheet_set(m, CD_PIN, u, 0, CD_NODE_PINNED);
        ok(cd_membrane_step(m, 1.0 / 60, 2000));
        const double nodes = (NU + 1) * (NV + 1), weight = 9.81 * (nodes - 2) / nodes;
        assert_true(missing_weight(m, weight) < 1e-6);
        cd_membrane_destroy(m);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(is_the_gradient_of_energy),
        cmocka_unit_test(what_holds_a_sheet_carries_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
