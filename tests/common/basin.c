#include "basin.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "reference.h"

const struct way ways[WAYS] = {
    [LINEAR] = {"linear 0.55", CD_METHOD_IMPLICIT, CD_MOMENTUM_LINEAR, 0.55},
    [LINEAR_HALF] = {"linear 1/2", CD_METHOD_IMPLICIT, CD_MOMENTUM_LINEAR, 0.5},
    [LINEAR_ONE] = {"linear 1", CD_METHOD_IMPLICIT, CD_MOMENTUM_LINEAR, 1},
    [ADVECTED] = {"advected", CD_METHOD_IMPLICIT, CD_MOMENTUM_ADVECTED, 0.5},
    [EXPLICIT] = {"explicit", CD_METHOD_SYMPLECTIC_EULER, CD_MOMENTUM_LINEAR, 0.5},
    [EXPLICIT_ADVECTED] = {"explicit advected", CD_METHOD_SYMPLECTIC_EULER, CD_MOMENTUM_ADVECTED, 0.5},
};

cd_water* basin(size_t nx, size_t ny, double dx, double dy, cd_precision precision) {
    cd_water* w = NULL;
    ok(cd_water_create(nx, ny, dx, dy, precision, NULL, &w));
    return w;
}

void basin_set_way(cd_water* w, const struct way* way) {
    ok(cd_water_set_method(w, way->method));
    ok(cd_water_set_momentum(w, way->momentum));
    ok(cd_water_set_lambda(w, way->lambda));
}

int basin_is_explicit(const struct way* way) { return way->method != CD_METHOD_IMPLICIT; }

/* ---- fields ------------------------------------------------------------------------------------------------------ */

static int is_x_face(cd_field f) { return f == CD_VELOCITY_X || f == CD_FORCE_X || f == CD_WALL_X; }
static int is_y_face(cd_field f) { return f == CD_VELOCITY_Y || f == CD_FORCE_Y || f == CD_WALL_Y; }

static void extent(const cd_water* w, cd_field field, size_t out[2]) {
    ok(cd_water_get_shape(w, &out[0], &out[1], NULL, NULL, NULL));
    out[0] += is_x_face(field), out[1] += is_y_face(field);
}

size_t basin_count(const cd_water* w, cd_field field) {
    size_t n[2];
    extent(w, field, n);
    return n[0] * n[1];
}

void basin_read(const cd_water* w, cd_field field, double* out_values) {
    size_t n[2];
    extent(w, field, n);
    ok(cd_water_read_f64(w, field, 0, 0, n[0], n[1], out_values, n[0] * n[1]));
}

void basin_write(cd_water* w, cd_field field, const double* values) {
    size_t n[2];
    extent(w, field, n);
    ok(cd_water_write_f64(w, field, 0, 0, n[0], n[1], values, n[0] * n[1]));
}

double basin_get(const cd_water* w, cd_field field, size_t i, size_t j) {
    double value;
    ok(cd_water_read_f64(w, field, i, j, 1, 1, &value, 1));
    return value;
}

void basin_set(cd_water* w, cd_field field, size_t i, size_t j, double value) {
    ok(cd_water_write_f64(w, field, i, j, 1, 1, &value, 1));
}

void basin_fill(cd_water* w, cd_field field, basin_shape* shape, const void* user) {
    size_t n[2];
    double dx, dy;
    extent(w, field, n);
    ok(cd_water_get_shape(w, NULL, NULL, &dx, &dy, NULL));
    double* values = malloc(n[0] * n[1] * sizeof *values);
    assert_non_null(values);
    for (size_t j = 0; j < n[1]; ++j)
        for (size_t i = 0; i < n[0]; ++i) {
            const double x = ((double)i + (is_x_face(field) ? 0 : 0.5)) * dx;
            const double y = ((double)j + (is_y_face(field) ? 0 : 0.5)) * dy;
            values[j * n[0] + i] = shape(x, y, user);
        }
    basin_write(w, field, values);
    free(values);
}

/* ---- time and measures ------------------------------------------------------------------------------------------- */

void basin_step(cd_water* w, double dt, size_t count) { ok(cd_water_step(w, dt, count)); }

double basin_volume(const cd_water* w) {
    double volume;
    ok(cd_water_get_volume(w, &volume));
    return volume;
}

double basin_volume_off(const cd_water* w) {
    double initial, in, out, error;
    ok(cd_water_get_account(w, &initial, &in, &out, &error));
    const double all = initial + in;
    const double off = fabs((basin_volume(w) - initial - in) + out);
    return all > 0 ? fmax(off, fabs(error)) / all : off;
}

double basin_energy(const cd_water* w) {
    double kinetic, potential;
    ok(cd_water_get_energy(w, &kinetic, &potential));
    return kinetic + potential;
}

double basin_kinetic(const cd_water* w) {
    double kinetic;
    ok(cd_water_get_energy(w, &kinetic, NULL));
    return kinetic;
}

static double over_all(const cd_water* w, cd_field field, double start, double (*of)(double, double), int size) {
    const size_t count = basin_count(w, field);
    double* values = malloc(count * sizeof *values);
    assert_non_null(values);
    basin_read(w, field, values);
    for (size_t i = 0; i < count; ++i) {
        assert_true(isfinite(values[i]));
        start = of(start, size ? fabs(values[i]) : values[i]);
    }
    free(values);
    return start;
}

double basin_largest(const cd_water* w, cd_field field) { return over_all(w, field, 0, fmax, 1); }
double basin_least(const cd_water* w, cd_field field) { return over_all(w, field, INFINITY, fmin, 0); }

double basin_stable_dt(const cd_water* w) {
    double dt;
    ok(cd_water_stable_dt(w, &dt));
    return dt;
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

cd_water* line_basin(int along_y, size_t n, size_t across, double size, cd_precision precision) {
    return along_y ? basin(across, n, size, size, precision) : basin(n, across, size, size, precision);
}

cd_field line_field(int along_y, cd_field of_x) {
    if (!along_y) return of_x;
    if (of_x == CD_VELOCITY_X) return CD_VELOCITY_Y;
    if (of_x == CD_FORCE_X) return CD_FORCE_Y;
    return of_x == CD_WALL_X ? CD_WALL_Y : of_x;
}

cd_side line_side(int along_y, int last) { return (along_y ? CD_SIDE_Y_FIRST : CD_SIDE_X_FIRST) + (last ? 1 : 0); }

void line_write(cd_water* w, int along_y, cd_field of_x, const double* values) {
    const cd_field field = line_field(along_y, of_x);
    size_t n[2];
    extent(w, field, n);
    double* all = malloc(n[0] * n[1] * sizeof *all);
    assert_non_null(all);
    for (size_t k = 0; k < n[0] * n[1]; ++k) all[k] = values[along_y ? k / n[0] : k % n[0]];
    basin_write(w, field, all);
    free(all);
}

void line_read(const cd_water* w, int along_y, cd_field of_x, double noise, double* out_values) {
    const cd_field field = line_field(along_y, of_x);
    size_t n[2];
    extent(w, field, n);
    const size_t length = along_y ? n[1] : n[0], across = along_y ? n[0] : n[1], middle = across / 2;
    double* all = malloc(n[0] * n[1] * sizeof *all);
    assert_non_null(all);
    basin_read(w, field, all);
    for (size_t i = 0; i < length; ++i) out_values[i] = all[along_y ? i * n[0] + middle : middle * n[0] + i];
    for (size_t k = 0; k < n[0] * n[1]; ++k) {
        const double here = out_values[along_y ? k / n[0] : k % n[0]];
        if (!(fabs(all[k] - here) <= noise)) assert_near(all[k], here, 0, 0);
    }
    free(all);
}

/* ---- beds -------------------------------------------------------------------------------------------------------- */

void basin_random_bed(cd_water* w, double height, double length, uint64_t seed) {
    enum { WAVES = 12 };
    size_t n[2];
    double dx, dy, a[WAVES][3];
    ok(cd_water_get_shape(w, &n[0], &n[1], &dx, &dy, NULL));
    double* bed = malloc(n[0] * n[1] * sizeof *bed);
    assert_non_null(bed);
    for (int k = 0; k < WAVES; ++k)
        for (int c = 0; c < 3; ++c) a[k][c] = 3.14159265358979 * random_number(&seed);
    double least = INFINITY, most = -INFINITY;
    for (size_t j = 0; j < n[1]; ++j)
        for (size_t i = 0; i < n[0]; ++i) {
            double b = 0;
            for (int k = 0; k < WAVES && length > 0; ++k)
                b += sin((a[k][0] * (double)i * dx + a[k][1] * (double)j * dy) / length + a[k][2]);
            if (!(length > 0)) b = random_number(&seed);
            bed[j * n[0] + i] = b;
            least = fmin(least, b), most = fmax(most, b);
        }
    const double scale = most > least ? height / (most - least) : 0;
    for (size_t k = 0; k < n[0] * n[1]; ++k) bed[k] = fmin(height, (bed[k] - least) * scale);
    basin_write(w, CD_BED, bed);
    free(bed);
}
