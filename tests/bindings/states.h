/* States of the scenes' objects: saved, loaded, and where two of them differ. */
#ifndef STATES_H
#define STATES_H

#include "reader.h"

/* One of three; the others are null. */
struct object {
    cd_chain* chain;
    cd_membrane* membrane;
    cd_water* water;
};

/* What one field has in an object's own memory. */
struct seen {
    const char* data;
    size_t counts[3], strides[3];
};

/* Whether the object shows the field. */
static int see(const struct object* object, cd_field field, struct seen* out) {
    const void* data = NULL;
    size_t* const n = out->counts;
    size_t* const stride = out->strides;
    n[2] = 1, stride[2] = 0;
    cd_status status;
    if (object->chain) {
        status = cd_chain_view(object->chain, field, &data, &stride[0], &stride[1], &stride[2]);
        cd_chain_get_shape(object->chain, &n[0], &n[1], &n[2], NULL);
        ++n[1]; /* nodes are one more than springs */
    } else if (object->membrane) {
        status = cd_membrane_view(object->membrane, field, &data, &stride[0], &stride[1], &stride[2]);
        cd_membrane_get_shape(object->membrane, &n[0], &n[1], &n[2], NULL);
        ++n[0], ++n[1];
    } else {
        status = cd_water_view(object->water, field, &data, &stride[0], &stride[1]);
        cd_water_get_shape(object->water, &n[0], &n[1], NULL, NULL, NULL);
        n[0] += field == CD_VELOCITY_X || field == CD_FORCE_X; /* faces are one more than cells */
        n[1] += field == CD_VELOCITY_Y || field == CD_FORCE_Y;
    }
    out->data = data;
    return status == CD_OK;
}

static double value_at(const char* data, cd_precision precision) {
    float single;
    double number;
    memcpy(&single, data, sizeof single);
    if (precision == CD_FLOAT32) return single;
    memcpy(&number, data, sizeof number);
    return number;
}

/* Prints the first place in which a field of the two differs. */
static void print_difference(const struct object* here, const struct object* there, cd_precision precision) {
    const size_t size = precision == CD_FLOAT32 ? sizeof(float) : sizeof(double);
    for (cd_field field = CD_POSITION; field <= CD_BREAKING_STRAIN_V; ++field) {
        struct seen a, b;
        if (!see(here, field, &a) || !see(there, field, &b)) continue;
        for (size_t i = 0; i < a.counts[0]; ++i)
            for (size_t j = 0; j < a.counts[1]; ++j)
                for (size_t k = 0; k < a.counts[2]; ++k) {
                    const char* x = a.data + i * a.strides[0] + j * a.strides[1] + k * a.strides[2];
                    const char* y = b.data + i * b.strides[0] + j * b.strides[1] + k * b.strides[2];
                    if (memcmp(x, y, size) == 0) continue;
                    fprintf(stderr, "field %d at (%zu, %zu), component %zu: %.17g here, %.17g there\n", (int)field, i,
                            j, k, value_at(x, precision), value_at(y, precision));
                    return;
                }
    }
    fprintf(stderr, "the saved bytes differ, and no field that has a view\n");
}

/* The object's state, *out_size bytes for the caller to free. */
static cd_status save(const struct object* object, char** out_bytes, size_t* out_size) {
    size_t written = 0;
    cd_status status = object->chain      ? cd_chain_save_size(object->chain, out_size)
                       : object->membrane ? cd_membrane_save_size(object->membrane, out_size)
                                          : cd_water_save_size(object->water, out_size);
    if (status) return status;
    *out_bytes = (char*)malloc(*out_size);
    status = !*out_bytes        ? CD_ERROR_MEMORY
             : object->chain    ? cd_chain_save(object->chain, *out_bytes, *out_size, &written)
             : object->membrane ? cd_membrane_save(object->membrane, *out_bytes, *out_size, &written)
                                : cd_water_save(object->water, *out_bytes, *out_size, &written);
    if (status || written != *out_size) exit((fprintf(stderr, "saving: %s\n", cd_error_message()), 1));
    return CD_OK;
}

static cd_status load(const struct object* object, const char* bytes, size_t size) {
    return object->chain      ? cd_chain_load(object->chain, bytes, size)
           : object->membrane ? cd_membrane_load(object->membrane, bytes, size)
                              : cd_water_load(object->water, bytes, size);
}

#endif
