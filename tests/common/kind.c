#include "kind.h"

#include <math.h>

#define SAME(kind)                                                                                                    \
    static void kind##_destroy(any* o) { cd_##kind##_destroy(o); }                                                    \
    static cd_status kind##_step(any* o, double dt, size_t count) { return cd_##kind##_step(o, dt, count); }          \
    static cd_status kind##_reset(any* o) { return cd_##kind##_reset(o); }                                            \
    static cd_status kind##_get_time(const any* o, double* out) { return cd_##kind##_get_time(o, out); }              \
    static cd_status kind##_get_steps(const any* o, uint64_t* out) { return cd_##kind##_get_steps(o, out); }          \
    static cd_status kind##_get_memory(const any* o, size_t* out) { return cd_##kind##_get_memory(o, out); }          \
    static cd_status kind##_hash(const any* o, uint64_t* out) { return cd_##kind##_hash(o, out); }                    \
    static cd_status kind##_save_size(const any* o, size_t* out) { return cd_##kind##_save_size(o, out); }            \
    static cd_status kind##_save(const any* o, void* buffer, size_t size, size_t* out) {                              \
        return cd_##kind##_save(o, buffer, size, out);                                                                \
    }                                                                                                                 \
    static cd_status kind##_load(any* o, const void* bytes, size_t size) { return cd_##kind##_load(o, bytes, size); } \
    static cd_status kind##_copy_state(any* o, const any* from) { return cd_##kind##_copy_state(o, from); }           \
    static cd_status kind##_enable_field(any* o, cd_field field) { return cd_##kind##_enable_field(o, field); }       \
    static cd_status kind##_disable_field(any* o, cd_field field) { return cd_##kind##_disable_field(o, field); }     \
    static cd_status kind##_set_method(any* o, cd_method method) { return cd_##kind##_set_method(o, method); }        \
    static cd_status kind##_set_kernels(any* o, cd_kernels kernels) { return cd_##kind##_set_kernels(o, kernels); }   \
    static cd_status kind##_set_parallel(any* o, const cd_parallel* p) { return cd_##kind##_set_parallel(o, p); }     \
    static cd_status kind##_read(const any* o, cd_field field, double* out, size_t count) {                           \
        size_t part[4];                                                                                               \
        kind##_extent(o, field, part);                                                                                \
        return cd_##kind##_read_f64(o, field, part[0], part[1], part[2], part[3], out, count);                        \
    }                                                                                                                 \
    static cd_status kind##_write(any* o, cd_field field, const double* values, size_t count) {                       \
        size_t part[4];                                                                                               \
        kind##_extent(o, field, part);                                                                                \
        return cd_##kind##_write_f64(o, field, part[0], part[1], part[2], part[3], values, count);                    \
    }

static bool has_components(cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET || field == CD_WIND;
}

/* Each returns the number of numbers that the part of the whole field has, if it is on. */
static size_t chain_extent(const any* o, cd_field field, size_t* part) {
    size_t strands, springs, components;
    double length;
    ok(cd_chain_get_shape(o, &strands, &springs, &components, NULL));
    ok(cd_chain_get_rest_length(o, &length));
    const bool shared =
        length == 0 && (field == CD_MASS || field == CD_STIFFNESS || field == CD_BEND || field == CD_PIN);
    const bool of_springs = field == CD_STIFFNESS || field == CD_REST_LENGTH || field == CD_TENSION ||
                            field == CD_STRENGTH || field == CD_STRAIN;
    part[0] = part[2] = 0, part[1] = shared ? 1 : strands, part[3] = springs + !of_springs;
    return part[1] * part[3] * (has_components(field) ? components : 1);
}

static size_t membrane_extent(const any* o, cd_field field, size_t* part) {
    size_t nu, nv, components;
    int32_t ring[2];
    ok(cd_membrane_get_shape(o, &nu, &nv, &components, NULL));
    ok(cd_membrane_get_ring(o, &ring[0], &ring[1]));
    const bool along_u = field == CD_STIFFNESS_U || field == CD_REST_LENGTH_U || field == CD_TENSION_U ||
                         field == CD_STRAIN_U || field == CD_BREAKING_STRAIN_U;
    const bool along_v = field == CD_STIFFNESS_V || field == CD_REST_LENGTH_V || field == CD_TENSION_V ||
                         field == CD_STRAIN_V || field == CD_BREAKING_STRAIN_V;
    part[0] = part[1] = 0, part[2] = nu + (along_u ? (size_t)ring[0] : 1),
    part[3] = nv + (along_v ? (size_t)ring[1] : 1);
    return part[2] * part[3] * (has_components(field) ? components : 1);
}

static size_t water_extent(const any* o, cd_field field, size_t* part) {
    size_t nx, ny;
    ok(cd_water_get_shape(o, &nx, &ny, NULL, NULL, NULL));
    const bool along_x = field == CD_VELOCITY_X || field == CD_FORCE_X || field == CD_WALL_X;
    const bool along_y = field == CD_VELOCITY_Y || field == CD_FORCE_Y || field == CD_WALL_Y;
    part[0] = part[1] = 0, part[2] = nx + along_x, part[3] = ny + along_y;
    return part[2] * part[3];
}

SAME(chain)
SAME(membrane)
SAME(water)

static cd_status chain_create(size_t first, size_t second, size_t components, cd_precision precision,
                              const cd_allocator* allocator, any** out) {
    cd_chain* made = *out;
    const cd_status status = cd_chain_create(first, second, components, precision, allocator, &made);
    *out = made;
    return status;
}
static cd_status membrane_create(size_t first, size_t second, size_t components, cd_precision precision,
                                 const cd_allocator* allocator, any** out) {
    cd_membrane* made = *out;
    const cd_status status = cd_membrane_create(first, second, components, precision, allocator, &made);
    *out = made;
    return status;
}
static cd_status water_create(size_t first, size_t second, size_t components, cd_precision precision,
                              const cd_allocator* allocator, any** out) {
    cd_water* made = *out;
    (void)components;
    const cd_status status = cd_water_create(first, second, 1, 1, precision, allocator, &made);
    *out = made;
    return status;
}

#define KIND(kind, number, state)                                                                                \
    {                                                                                                            \
#kind, number, state, kind##_create, kind##_destroy, kind##_step, kind##_reset, kind##_get_time,         \
            kind##_get_steps, kind##_get_memory, kind##_hash, kind##_save_size, kind##_save, kind##_load,        \
            kind##_copy_state, kind##_enable_field, kind##_disable_field, kind##_set_method, kind##_set_kernels, \
            kind##_set_parallel, kind##_read, kind##_write                                                       \
    }
const struct kind kinds[KINDS] = {KIND(chain, CD_KIND_CHAIN, CD_POSITION),
                                  KIND(membrane, CD_KIND_MEMBRANE, CD_POSITION), KIND(water, CD_KIND_WATER, CD_DEPTH)};

size_t kind_numbers(const struct kind* kind, const any* object, cd_field field) {
    size_t part[4];
    const size_t count = kind->number == CD_KIND_CHAIN      ? chain_extent(object, field, part)
                         : kind->number == CD_KIND_MEMBRANE ? membrane_extent(object, field, part)
                                                            : water_extent(object, field, part);
    static double numbers[1 << 16];
    assert_true(count <= COUNT(numbers));
    return kind->read(object, field, numbers, count) == CD_OK ? count : 0;
}

uint64_t kind_hash(const struct kind* kind, const any* object) {
    uint64_t hash = 0;
    ok(kind->hash(object, &hash));
    return hash;
}

size_t kind_memory(const struct kind* kind, const any* object) {
    size_t bytes = 0;
    ok(kind->get_memory(object, &bytes));
    return bytes;
}

bool kind_is_finite(const struct kind* kind, const any* object) {
    static const cd_field fields[KINDS][3] = {
        {CD_POSITION, CD_VELOCITY}, {CD_POSITION, CD_VELOCITY}, {CD_DEPTH, CD_VELOCITY_X, CD_VELOCITY_Y}};
    static double numbers[1 << 14];
    for (size_t f = 0; f < (kind == &kinds[WATER] ? 3 : 2); ++f) {
        const size_t count = kind_numbers(kind, object, fields[kind - kinds][f]);
        ok(kind->read(object, fields[kind - kinds][f], numbers, count));
        for (size_t i = 0; i < count; ++i)
            if (!isfinite(numbers[i])) return false;
    }
    return true;
}

hash_function* kind_hash_function(const struct kind* kind) {
    static hash_function* const functions[KINDS] = {hash_of_chain, hash_of_membrane, hash_of_water};
    return functions[kind - kinds];
}
