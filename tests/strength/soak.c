/* Plays a scene as a game does, 60 frames a second, for as long as asked, and looks for what grows.
 *
 *   soak chain|membrane|water MINUTES          in real time
 *   soak chain|membrane|water --frames COUNT   as fast as it goes
 *
 * Beside the scene, which something moves for ever, stands a body without damping that is left alone: what it should
 * keep must not drift. Every frame the scene is read; every second it is saved, and what is loaded must have the same
 * hash and the same bytes; every ten seconds a scene is made anew beside it and thrown away.
 * Printed every minute: memory, the drift so far, and the median time of a frame. Exit status 0: the scene's memory is
 * as large as at the start, all that the library took is given back at the end, nothing drifts, all numbers are finite,
 * and in ten minutes or more the program's memory has not grown since the first tenth. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum {
    kFramesPerSecond = 60,
    kFramesPerMinute = 3600,
    kMostNumbers = 3 * 64 * 64,
    kMostGrowth = 256 /* [kB], of what malloc keeps */
};

static const double kDt = 1.0 / kFramesPerSecond;

static void must(cd_status status, const char* what) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s: %s\n", what, cd_error_message());
    exit(1);
}
#define MUST(call) must(call, #call)

static void fail(const char* what) {
    printf("FAILS: %s\n", what);
    exit(1);
}

/* All memory of the library. */
static size_t taken;
static void* take(void* user, size_t size, size_t alignment) {
    void* pointer = NULL;
    (void)user;
    if (posix_memalign(&pointer, alignment < sizeof(void*) ? sizeof(void*) : alignment, size)) return NULL;
    taken += size;
    return pointer;
}
static void give_back(void* user, void* pointer, size_t size, size_t alignment) {
    (void)user, (void)alignment;
    taken -= size;
    free(pointer);
}
static const cd_allocator counted = {NULL, take, give_back};

static double now(clockid_t clock) {
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double random_in(double first, double last) {
    static unsigned state = 1;
    state = state * 1664525u + 1013904223u;
    return first + (last - first) * (state >> 8) / (1 << 24);
}

/* What the three objects have in common. */
typedef struct soaked {
    void* (*make)(void);       /* the scene */
    void* (*make_quiet)(void); /* the body that nothing touches */
    void (*frame)(void* scene, long frame);
    double (*drift)(void* quiet); /* how far it is from what it was, as a fraction; steps it by a frame */
    double most_drift;
    size_t (*read)(void* scene, float* numbers);
    size_t (*memory)(void* scene);
    uint64_t (*hash)(void* scene);
    size_t (*save)(void* scene, void** bytes); /* allocates; caller frees */
    void (*load)(void* scene, const void* bytes, size_t size);
    void (*destroy)(void* scene);
} soaked;

#define COMMON(kind)                                                       \
    static size_t kind##_memory(void* scene) {                             \
        size_t bytes;                                                      \
        MUST(cd_##kind##_get_memory(scene, &bytes));                       \
        return bytes;                                                      \
    }                                                                      \
    static uint64_t kind##_hash(void* scene) {                             \
        uint64_t hash;                                                     \
        MUST(cd_##kind##_hash(scene, &hash));                              \
        return hash;                                                       \
    }                                                                      \
    static size_t kind##_save(void* scene, void** bytes) {                 \
        size_t size;                                                       \
        MUST(cd_##kind##_save_size(scene, &size));                         \
        *bytes = malloc(size);                                             \
        if (!*bytes) fail("no memory");                                    \
        MUST(cd_##kind##_save(scene, *bytes, size, &size));                \
        return size;                                                       \
    }                                                                      \
    static void kind##_load(void* scene, const void* bytes, size_t size) { \
        MUST(cd_##kind##_load(scene, bytes, size));                        \
    }                                                                      \
    static void kind##_destroy(void* scene) { cd_##kind##_destroy(scene); }

/* ---- chains: hair on a head that turns, in gusts; a string that swings for ever ---------------------------------- */

COMMON(chain)

enum { kStrands = 24, kSprings = 15 };

static void roots_at(double time, float* roots) {
    for (int s = 0; s < kStrands; ++s) {
        const double angle = 0.26 * s + sin(1.3 * time);
        roots[3 * s] = (float)(0.1 * cos(angle)), roots[3 * s + 1] = (float)(0.1 * sin(angle)),
                  roots[3 * s + 2] = 0.05f;
    }
}

static void* make_hair(void) {
    const double gravity[3] = {0, 0, -9.81}, middle[3] = {0, 0, 0};
    float x[kStrands][kSprings + 1][3], roots[3 * kStrands];
    cd_chain* hair;
    roots_at(0, roots);
    for (int s = 0; s < kStrands; ++s)
        for (int i = 0; i <= kSprings; ++i)
            for (int k = 0; k < 3; ++k) x[s][i][k] = roots[3 * s + k] * (k < 2 ? 1 + 2.0f * (float)i / kSprings : 1);
    MUST(cd_chain_create(kStrands, kSprings, 3, CD_FLOAT32, &counted, &hair));
    MUST(cd_chain_write_f32(hair, CD_POSITION, 0, kStrands, 0, kSprings + 1, x[0][0], sizeof x / sizeof(float)));
    MUST(cd_chain_set_rest_length(hair, 0.2));
    MUST(cd_chain_set_stiffness(hair, INFINITY));
    MUST(cd_chain_set_mass(hair, 1e-4));
    MUST(cd_chain_set_bend(hair, 1e-6));
    MUST(cd_chain_set_gravity(hair, gravity, 3));
    MUST(cd_chain_set_air(hair, 1e-4, 1e-3));
    MUST(cd_chain_set_end(hair, CD_END_FIRST, CD_NODE_POSED));
    MUST(cd_chain_set_colliders(hair, 1));
    MUST(cd_chain_set_capsule(hair, 0, middle, middle, 3, 0.1, 0.3));
    return hair;
}

static void hair_frame(void* hair, long frame) {
    float roots[3 * kStrands];
    roots_at((double)(frame + 1) * kDt, roots);
    MUST(cd_chain_write_f32(hair, CD_TARGET, 0, kStrands, 0, 1, roots, 3 * kStrands));
    if (frame % 90 == 0) {
        const double wind[3] = {random_in(-6, 6), random_in(-6, 6), random_in(-1, 1)};
        MUST(cd_chain_set_wind(hair, wind, 3));
    }
    const cd_status stepped = cd_chain_step(hair, kDt, 1);
    if (stepped != CD_ERROR_TOLERANCE) must(stepped, "a step of hair");
}

static size_t read_hair(void* hair, float* numbers) {
    const size_t count = (size_t)kStrands * (kSprings + 1) * 3;
    MUST(cd_chain_read_f32(hair, CD_POSITION, 0, kStrands, 0, kSprings + 1, numbers, count));
    return count;
}

static double chain_energy(void* chain) {
    double kinetic, elastic;
    MUST(cd_chain_get_energy(chain, &kinetic, &elastic, NULL));
    return kinetic + elastic;
}

static void* make_string(void) {
    double x[200];
    cd_chain* string;
    for (int i = 0; i < 200; ++i) x[i] = random_in(-1, 1);
    x[0] = x[199] = 0;
    MUST(cd_chain_create(1, 199, 1, CD_FLOAT64, &counted, &string));
    MUST(cd_chain_write_f64(string, CD_POSITION, 0, 1, 0, 200, x, 200));
    MUST(cd_chain_set_stiffness(string, 1e4));
    MUST(cd_chain_set_end(string, CD_END_FIRST, CD_NODE_PINNED));
    MUST(cd_chain_set_end(string, CD_END_LAST, CD_NODE_PINNED));
    return string;
}

static double string_drift(void* string) {
    static double first = -1;
    if (first < 0) first = chain_energy(string);
    MUST(cd_chain_step(string, kDt, 1));
    return chain_energy(string) / first - 1;
}

/* ---- membranes: a cape on a body that runs round; a drum that sounds for ever ------------------------------------ */

COMMON(membrane)

enum { kAcross = 20, kDown = 24 };

static void* make_cape(void) {
    static float x[kDown + 1][kAcross + 1][3];
    const double gravity[3] = {0, 0, -9.81};
    cd_membrane* cape;
    for (int j = 0; j <= kDown; ++j)
        for (int i = 0; i <= kAcross; ++i) {
            x[j][i][0] = 0.03f * (float)(i - kAcross / 2), x[j][i][1] = -0.22f,
            x[j][i][2] = 1.5f - 1.1f * (float)j / kDown;
        }
    MUST(cd_membrane_create(kAcross, kDown, 3, CD_FLOAT32, &counted, &cape));
    MUST(cd_membrane_write_f32(cape, CD_POSITION, 0, 0, kAcross + 1, kDown + 1, x[0][0], sizeof x / sizeof(float)));
    MUST(cd_membrane_set_mass(cape, 0.3));
    MUST(cd_membrane_set_rest_length(cape, 0.03 * kAcross, 1.1));
    MUST(cd_membrane_set_stiffness(cape, 3000, 1500));
    MUST(cd_membrane_set_shear(cape, 100));
    MUST(cd_membrane_set_gravity(cape, gravity, 3));
    MUST(cd_membrane_set_air(cape, 0.05, 2));
    MUST(cd_membrane_set_edge(cape, CD_EDGE_V_FIRST, CD_NODE_POSED));
    MUST(cd_membrane_set_colliders(cape, 1));
    MUST(cd_membrane_set_thickness(cape, 0.005));
    return cape;
}

static void cape_frame(void* cape, long frame) {
    const double time = (double)frame * kDt, at[2] = {2 * sin(0.5 * time), 2 * sin(0.35 * time)};
    const double next[2] = {2 * sin(0.5 * (time + kDt)), 2 * sin(0.35 * (time + kDt))};
    const double first[3] = {at[0], at[1], 0.2}, last[3] = {at[0], at[1], 1.4};
    const double velocity[3] = {(next[0] - at[0]) / kDt, (next[1] - at[1]) / kDt, 0};
    float collar[kAcross + 1][3];
    for (int i = 0; i <= kAcross; ++i)
        collar[i][0] = (float)next[0] + 0.03f * (float)(i - kAcross / 2), collar[i][1] = (float)next[1] - 0.22f,
        collar[i][2] = 1.5f;
    MUST(cd_membrane_write_f32(cape, CD_TARGET, 0, 0, kAcross + 1, 1, collar[0], sizeof collar / sizeof(float)));
    MUST(cd_membrane_set_capsule(cape, 0, first, last, 3, 0.2, 0.3));
    MUST(cd_membrane_set_collider_velocity(cape, 0, velocity, 3));
    const cd_status stepped = cd_membrane_step(cape, kDt, 1);
    if (stepped != CD_ERROR_TOLERANCE) must(stepped, "a step of the cape");
}

static size_t read_cape(void* cape, float* numbers) {
    const size_t count = (size_t)(kAcross + 1) * (kDown + 1) * 3;
    MUST(cd_membrane_read_f32(cape, CD_POSITION, 0, 0, kAcross + 1, kDown + 1, numbers, count));
    return count;
}

static double membrane_energy(void* membrane) {
    double kinetic, elastic;
    MUST(cd_membrane_get_energy(membrane, &kinetic, &elastic, NULL));
    return kinetic + elastic;
}

static void* make_drum(void) {
    double x[24][24];
    cd_membrane* drum;
    for (int j = 0; j < 24; ++j)
        for (int i = 0; i < 24; ++i) x[j][i] = i % 23 == 0 || j % 23 == 0 ? 0 : random_in(-1, 1);
    MUST(cd_membrane_create(23, 23, 1, CD_FLOAT64, &counted, &drum));
    MUST(cd_membrane_write_f64(drum, CD_POSITION, 0, 0, 24, 24, x[0], 24 * 24));
    MUST(cd_membrane_set_stiffness(drum, 100, 100));
    MUST(cd_membrane_set_solver(drum, CD_SOLVER_COUPLED));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        MUST(cd_membrane_set_edge(drum, edge, CD_NODE_PINNED));
    return drum;
}

static double drum_drift(void* drum) {
    static double first = -1;
    if (first < 0) first = membrane_energy(drum);
    MUST(cd_membrane_step(drum, kDt, 1));
    return membrane_energy(drum) / first - 1;
}

/* ---- water: a bay with a river, a tide and a boat, in the rain; a pool that rocks for ever ----------------------- */

COMMON(water)

enum { kCells = 64 };

static void* make_bay(void) {
    static double bed[kCells][kCells];
    const double floor[4] = {0, 0, 0, 0};
    cd_water* bay;
    for (int j = 0; j < kCells; ++j)
        for (int i = 0; i < kCells; ++i) bed[j][i] = 0.04 * i + 0.3 * sin(0.3 * i) * cos(0.2 * j);
    MUST(cd_water_create(kCells, kCells, 0.25, 0.25, CD_FLOAT32, &counted, &bay));
    MUST(cd_water_write_f64(bay, CD_BED, 0, 0, kCells, kCells, bed[0], kCells * kCells));
    MUST(cd_water_set_momentum(bay, CD_MOMENTUM_ADVECTED));
    MUST(cd_water_set_manning(bay, 0.02));
    MUST(cd_water_set_side(bay, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 1, 0));
    MUST(cd_water_add_volume_rectangle(bay, 0, 0, kCells / 2, kCells, 80, NULL));
    MUST(cd_water_add_source(bay, 15, 8, 0.5, 0.2));
    MUST(cd_water_set_hulls(bay, 1, 2, 2));
    MUST(cd_water_set_hull(bay, 0, 100, 1.6, 0.8, floor, 4));
    MUST(cd_water_launch_hull(bay, 0, 4, 8, 1, 0));
    return bay;
}

static void bay_frame(void* bay, long frame) {
    const double time = (double)frame * kDt;
    MUST(cd_water_set_side(bay, CD_SIDE_X_FIRST, CD_BORDER_OPEN, 1 + 0.3 * sin(0.1 * time), 0));
    MUST(cd_water_add_volume(bay, random_in(0, 16), random_in(0, 16), 0.3, 0.002, NULL));
    MUST(cd_water_step(bay, kDt, 1));
}

static size_t read_bay(void* bay, float* numbers) {
    MUST(cd_water_read_f32(bay, CD_DEPTH, 0, 0, kCells, kCells, numbers, (size_t)kCells * kCells));
    for (size_t i = 0; i < (size_t)kCells * kCells; ++i)
        if (numbers[i] < 0) fail("a depth below zero");
    return (size_t)kCells * kCells;
}

static void* make_pool(void) {
    double depth[32][32];
    cd_water* pool;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i) depth[j][i] = i < 8 ? 2 : j < 8 ? 0 : 1;
    MUST(cd_water_create(32, 32, 1, 1, CD_FLOAT64, &counted, &pool));
    MUST(cd_water_write_f64(pool, CD_DEPTH, 0, 0, 32, 32, depth[0], 32 * 32));
    MUST(cd_water_restart_account(pool));
    return pool;
}

static double pool_drift(void* pool) {
    double initial, error, volume;
    MUST(cd_water_step(pool, kDt, 1));
    MUST(cd_water_get_account(pool, &initial, NULL, NULL, &error));
    MUST(cd_water_get_volume(pool, &volume));
    return fmax(fabs(error), fabs(volume - initial)) / initial;
}

/* ---- the soak ---------------------------------------------------------------------------------------------------- */

static const soaked kObjects[] = {
    {make_hair, make_string, hair_frame, string_drift, 1e-9, read_hair, chain_memory, chain_hash, chain_save,
     chain_load, chain_destroy},
    {make_cape, make_drum, cape_frame, drum_drift, 1e-9, read_cape, membrane_memory, membrane_hash, membrane_save,
     membrane_load, membrane_destroy},
    {make_bay, make_pool, bay_frame, pool_drift, 1e-12, read_bay, water_memory, water_hash, water_save, water_load,
     water_destroy},
};
static const char* const kNames[] = {"chain", "membrane", "water"};

static long resident_kilobytes(void) {
    long pages = 0, resident = 0;
    FILE* const file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%ld %ld", &pages, &resident) != 2) fail("/proc/self/statm cannot be read");
    fclose(file);
    return resident * (sysconf(_SC_PAGESIZE) / 1024);
}

static int ascending(const void* a, const void* b) {
    const double x = *(const double*)a, y = *(const double*)b;
    return (x > y) - (x < y);
}

/* What is loaded is what was saved. */
static void check_saved(const soaked* object, void* scene, void* other) {
    void* bytes;
    void* again;
    const size_t size = object->save(scene, &bytes);
    object->load(other, bytes, size);
    if (object->hash(scene) != object->hash(other)) fail("what was loaded has another hash");
    const size_t size_again = object->save(other, &again);
    if (size_again != size || memcmp(bytes, again, size) != 0) fail("what was loaded is saved as other bytes");
    free(bytes);
    free(again);
}

static void soak(const soaked* object, long frames, int in_real_time) {
    static float numbers[kMostNumbers];
    static double took[kFramesPerMinute];
    void* const scene = object->make();
    void* const other = object->make();
    void* const quiet = object->make_quiet();
    const size_t held = object->memory(scene);
    const double began = now(CLOCK_MONOTONIC);
    double most_drift = 0;
    long resident = 0;
    printf("minute   memory [kB]   of it the scene's [kB]   drift     a frame [microseconds]\n");
    for (long frame = 0; frame < frames; ++frame) {
        const double start = now(CLOCK_PROCESS_CPUTIME_ID);
        object->frame(scene, frame);
        const size_t count = object->read(scene, numbers);
        took[frame % kFramesPerMinute] = 1e6 * (now(CLOCK_PROCESS_CPUTIME_ID) - start);
        for (size_t i = 0; i < count; ++i)
            if (!isfinite(numbers[i])) fail("a number that is not finite");
        most_drift = fmax(most_drift, fabs(object->drift(quiet)));
        if (!(most_drift <= object->most_drift)) fail("what nothing touches drifts");
        if (frame % kFramesPerSecond == 0) check_saved(object, scene, other);
        if (frame % (10 * kFramesPerSecond) == 0) object->destroy(object->make());
        if (object->memory(scene) != held) fail("the scene holds another amount of memory");
        if (frame == frames / 10) resident = resident_kilobytes();
        if ((frame + 1) % kFramesPerMinute == 0) {
            qsort(took, kFramesPerMinute, sizeof *took, ascending);
            printf("%6ld %13ld %24zu %7.1e %26.1f\n", (frame + 1) / kFramesPerMinute, resident_kilobytes(), held / 1024,
                   most_drift, took[kFramesPerMinute / 2]);
            fflush(stdout);
        }
        while (in_real_time && now(CLOCK_MONOTONIC) < began + (double)(frame + 1) * kDt) usleep(1000);
    }
    const long at_end = resident_kilobytes();
    if (frames >= 10 * kFramesPerMinute && at_end > resident + kMostGrowth) fail("the program's memory grows");
    object->destroy(scene);
    object->destroy(other);
    object->destroy(quiet);
    if (taken != 0) fail("the library has not given back all that it took");
    printf("%ld frames: memory %ld kB after a tenth and %ld kB at the end, drift %.1e\n", frames, resident, at_end,
           most_drift);
}

int main(int argc, char** argv) {
    const int by_frames = argc == 4 && strcmp(argv[2], "--frames") == 0;
    if (argc != 3 && !by_frames) return fprintf(stderr, "soak chain|membrane|water MINUTES | --frames COUNT\n"), 2;
    const double many = strtod(argv[argc - 1], NULL);
    for (size_t i = 0; i < sizeof kObjects / sizeof *kObjects; ++i)
        if (strcmp(argv[1], kNames[i]) == 0)
            return soak(&kObjects[i], (long)(by_frames ? many : many * kFramesPerMinute), !by_frames), 0;
    return fprintf(stderr, "no such object: %s\n", argv[1]), 2;
}
