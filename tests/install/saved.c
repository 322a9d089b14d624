/* States that need the parts of the library which can be left out.
 *
 *   saved write FOLDER   saves each, with the whole library
 *   saved load FOLDER    loads each, and prints its part and the status
 *   saved touch .        prints what colliders of a chain without rest lengths are refused for */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 1 << 20 };
static unsigned char bytes[MOST];

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

static cd_chain* new_chain(void) {
    cd_chain* chain;
    must(cd_chain_create(1, 8, 2, CD_FLOAT64, NULL, &chain));
    return chain;
}
static cd_membrane* new_membrane(void) {
    cd_membrane* membrane;
    must(cd_membrane_create(4, 4, 3, CD_FLOAT64, NULL, &membrane));
    must(cd_membrane_set_solver(membrane, CD_SOLVER_ALTERNATING));
    return membrane;
}
static cd_water* new_water(void) {
    cd_water* water;
    must(cd_water_create(4, 4, 1, 1, CD_FLOAT64, NULL, &water));
    return water;
}

static FILE* opened(const char* folder, const char* part, int k, const char* mode) {
    char path[1000];
    snprintf(path, sizeof path, "%s/%s.%d", folder, part, k);
    FILE* file = fopen(path, mode);
    if (!file) perror(path), exit(1);
    return file;
}

/* Writes or loads one state, made by `change`. */
#define STATE(part, k, kind, change)                                                   \
    do {                                                                               \
        cd_##kind* const x = new_##kind();                                             \
        FILE* const file = opened(folder, part, k, writes ? "wb" : "rb");              \
        size_t size = 0;                                                               \
        if (writes) {                                                                  \
            change;                                                                    \
            must(cd_##kind##_save(x, bytes, MOST, &size));                             \
            if (fwrite(bytes, 1, size, file) != size) exit(1);                         \
        } else {                                                                       \
            size = fread(bytes, 1, MOST, file);                                        \
            printf("%s %s\n", part, cd_status_name(cd_##kind##_load(x, bytes, size))); \
        }                                                                              \
        fclose(file);                                                                  \
        cd_##kind##_destroy(x);                                                        \
    } while (0)

int main(int count, char** words) {
    if (count != 3) return 2;
    const int writes = strcmp(words[1], "write") == 0;
    const char* const folder = words[2];
    if (strcmp(words[1], "touch") == 0) {
        cd_chain* const chain = new_chain();
        if (cd_chain_set_colliders(chain, 1) != CD_OK) puts(cd_error_message());
        cd_chain_destroy(chain);
        return 0;
    }
    STATE("none", 0, chain, must(cd_chain_set_mass(x, 2)));
    STATE("none", 1, membrane, must(cd_membrane_set_mass(x, 2)));
    STATE("none", 2, water, must(cd_water_set_drag(x, 2)));
    STATE("ROPE", 0, chain, must(cd_chain_set_rest_length(x, 1)));
    STATE("CLOTH", 0, membrane, must(cd_membrane_set_rest_length(x, 1, 1)));
    STATE("HULL", 0, water, must(cd_water_set_hulls(x, 1, 2, 2)));
    STATE("BEND", 0, chain, must(cd_chain_set_bend(x, 1)));
    STATE("BEND", 1, chain, must(cd_chain_enable_field(x, CD_BEND)));
    STATE("BEND", 2, chain, must(cd_chain_set_ring(x, 1)));
    STATE("BEND", 3, membrane, must(cd_membrane_set_bend(x, 1)));
    STATE("BEND", 4, membrane, must(cd_membrane_set_ring(x, 0, 1)));
    STATE("CONTACT", 0, chain, (must(cd_chain_set_rest_length(x, 1)), must(cd_chain_set_colliders(x, 1))));
    STATE("CONTACT", 1, membrane, (must(cd_membrane_set_rest_length(x, 1, 1)), must(cd_membrane_set_colliders(x, 1))));
    STATE("COUPLED", 0, membrane, must(cd_membrane_set_solver(x, CD_SOLVER_COUPLED)));
    STATE("SLEEP", 0, chain, must(cd_chain_set_sleep(x, 1, 1)));
    STATE("SLEEP", 1, membrane, must(cd_membrane_set_sleep(x, 1, 1)));
    STATE("SLEEP", 2, water, must(cd_water_set_sleep(x, 1)));
    STATE("ADVECTED", 0, water, must(cd_water_set_momentum(x, CD_MOMENTUM_ADVECTED)));
    return 0;
}
