/* Plays the scenes that every binding plays, in C, by all kernels that this processor runs, and compares the hashes of
 * their states.
 *
 *   conformance SCENES.TXT              fails where a hash differs
 *   conformance --update SCENES.TXT     writes the hashes that came out into the file
 *   conformance --left-out SCENES.TXT   for a library without some part: a scene ends where a call says
 *                                       CD_ERROR_UNSUPPORTED that should not. Fails, too, unless some scenes end so and
 *                                       some do not
 *   conformance --flushed SCENES.TXT    where the processor takes denormal numbers for 0, as game engines have it do;
 *                                       exits with 77 if this program cannot tell it to
 *   conformance --write STATES SCENES.TXT    writes the state after every statement, and after every single step, into a
 *                                            file, and compares no hashes
 *   conformance --compare STATES SCENES.TXT  fails at the first state that differs from another machine's in such a file,
 *                                            or that cannot be loaded, and tells the step, the field and the place */
#include <inttypes.h>

#include "states.h"

#ifdef __SSE2__
#include <xmmintrin.h>
static int flush_denormal_numbers(void) {
    _mm_setcsr(_mm_getcsr() | 0x8040); /* FTZ and DAZ */
    return 1;
}
#else
static int flush_denormal_numbers(void) { return 0; }
#endif

static cd_status create_kind(const struct arguments* call, struct object* out) {
    const char* kind = call->statement->words[1];
    memset(out, 0, sizeof *out);
    if (strcmp(kind, "chain") == 0)
        return cd_chain_create(size_argument(call, 0), size_argument(call, 1), size_argument(call, 2), call->precision,
                               NULL, &out->chain);
    if (strcmp(kind, "membrane") == 0)
        return cd_membrane_create(size_argument(call, 0), size_argument(call, 1), size_argument(call, 2),
                                  call->precision, NULL, &out->membrane);
    if (strcmp(kind, "water") == 0)
        return cd_water_create(size_argument(call, 0), size_argument(call, 1), number_argument(call, 2),
                               number_argument(call, 3), call->precision, NULL, &out->water);
    fail_at(call->statement, "no object", kind);
    return CD_OK;
}

static cd_status create(const struct arguments* call, cd_kernels kernels, struct object* out) {
    const cd_status status = create_kind(call, out);
    if (status) return status;
    return out->chain      ? cd_chain_set_kernels(out->chain, kernels)
           : out->membrane ? cd_membrane_set_kernels(out->membrane, kernels)
                           : cd_water_set_kernels(out->water, kernels);
}

static void destroy(const struct object* object) {
    cd_chain_destroy(object->chain);
    cd_membrane_destroy(object->membrane);
    cd_water_destroy(object->water);
}

static uint64_t hash_of(const struct object* object) {
    uint64_t hash = 0;
    const cd_status status = object->chain      ? cd_chain_hash(object->chain, &hash)
                             : object->membrane ? cd_membrane_hash(object->membrane, &hash)
                                                : cd_water_hash(object->water, &hash);
    if (status) exit((fprintf(stderr, "%s\n", cd_error_message()), 1));
    return hash;
}

static cd_status copy_state(const struct object* to, const struct object* from) {
    if (from->chain) return cd_chain_copy_state(to->chain, from->chain);
    if (from->membrane) return cd_membrane_copy_state(to->membrane, from->membrane);
    return cd_water_copy_state(to->water, from->water);
}

static cd_status save_and_load(const struct object* to, const struct object* from) {
    size_t size;
    char* bytes;
    const cd_status saved = save(from, &bytes, &size);
    if (saved) return saved;
    const cd_status status = load(to, bytes, size);
    free(bytes);
    return status;
}

/* ---- calls --------------------------------------------------------------------------------------------------- */

#define D(k) number_argument(call, k)
#define Z(k) size_argument(call, k)
#define I(k) (int32_t) number_argument(call, k)
#define E(type, k) enum_argument(call, k)
#define P(k) arrays[k].null ? NULL : arrays[k].values
#define A(k) P(k), arrays[k].count
#define F(k) arrays[k].singles, arrays[k].count
#define OUT , NULL
#define CHAIN(name, ...) TRY(chain, name, cd_chain_##name(object->chain, __VA_ARGS__))
#define CHAIN_0(name) TRY(chain, name, cd_chain_##name(object->chain))
#define MEMBRANE(name, ...) TRY(membrane, name, cd_membrane_##name(object->membrane, __VA_ARGS__))
#define MEMBRANE_0(name) TRY(membrane, name, cd_membrane_##name(object->membrane))
#define WATER(name, ...) TRY(water, name, cd_water_##name(object->water, __VA_ARGS__))
#define WATER_0(name) TRY(water, name, cd_water_##name(object->water))
#define TRY(kind, name, call_of_it) \
    if (object->kind && strcmp(word, #name) == 0) return call_of_it;

enum { MOST_ARGUMENTS = 8 };

/* Sets arrays[k] to argument k where that is an array, to null where it is none. */
static void read_arrays(const struct arguments* call, struct numbers* arrays) {
    static const struct numbers none = {{0}, {0}, 0, 1};
    for (size_t k = 0; k < MOST_ARGUMENTS; ++k) arrays[k] = none;
    size_t word = call->first + 1;
    for (size_t k = 0; k < MOST_ARGUMENTS && word < call->statement->count; ++k, ++word) {
        if (strcmp(call->statement->words[word], "[") != 0) continue;
        arrays[k] = array_argument(call, k);
        while (strcmp(call->statement->words[word], "]") != 0) ++word;
    }
}

static cd_status perform(const struct object* object, const struct arguments* call) {
    const char* word = call->statement->words[call->first];
    static struct numbers arrays[MOST_ARGUMENTS];
    read_arrays(call, arrays);
#include "calls.h"
    fail_at(call->statement, "no call", word);
    return CD_OK;
}

/* ---- scenes -------------------------------------------------------------------------------------------------- */

static int parts_are_left_out;
static size_t ended, played; /* scenes */

/* Whether the scene goes on. */
static int hold(const struct statement* statement, cd_status got, cd_status wanted) {
    if (got == wanted) return 1;
    if (parts_are_left_out && got == CD_ERROR_UNSUPPORTED) return 0;
    fprintf(stderr, "line %zu: %s, not %s: %s\n", statement->line, cd_status_name(got), cd_status_name(wanted),
            cd_error_message());
    exit(1);
}

/* ---- states on another machine --------------------------------------------------------------------------------- */

static FILE *written, *compared_with; /* at most one of them */

static uint32_t read_count(void) {
    unsigned char b[4];
    if (fread(b, 1, sizeof b, compared_with) != sizeof b) exit((fprintf(stderr, "fewer states than here\n"), 1));
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* Compares the bytes with the other machine's, which an object like this one must be able to load. */
static void compare_state(const struct statement* statement, size_t step, const struct statement* made,
                          cd_precision precision, const struct object* object, const char* bytes, size_t size) {
    const struct arguments again = {made, 1, precision};
    const uint32_t count = read_count();
    char* others = (char*)malloc(count);
    struct object there;
    if (!others || fread(others, 1, count, compared_with) != count || create(&again, CD_KERNELS_PLAIN, &there)) exit(1);
    const cd_status loaded = load(&there, others, count);
    if (loaded || count != size || memcmp(bytes, others, size) != 0) {
        fprintf(stderr, "line %zu, step %zu, float%d: ", statement->line, step, precision == CD_FLOAT64 ? 64 : 32);
        if (loaded) fprintf(stderr, "the other machine's state: %s\n", cd_error_message());
        else print_difference(object, &there, precision);
        exit(1);
    }
    destroy(&there);
    free(others);
}

static void keep_state(const struct statement* statement, size_t step, const struct statement* made,
                       cd_precision precision, const struct object* object) {
    size_t size;
    char* bytes;
    if (save(object, &bytes, &size)) exit((fprintf(stderr, "saving: %s\n", cd_error_message()), 1));
    if (written) {
        const unsigned char count[4] = {size & 255, size >> 8 & 255, size >> 16 & 255, size >> 24 & 255};
        fwrite(count, 1, sizeof count, written);
        fwrite(bytes, 1, size, written);
    } else {
        compare_state(statement, step, made, precision, object, bytes, size);
    }
    free(bytes);
}

/* A call that should succeed, and the states that it gives; of many steps each by itself. Whether the scene goes on. */
static int perform_and_keep(const struct statement* statement, const struct statement* made, cd_precision precision,
                            const struct object* object) {
    static struct statement single;
    const struct arguments call = {&single, 0, precision};
    single = *statement;
    for (size_t i = 0; i < single.count; ++i) single.words[i] = single.text + (statement->words[i] - statement->text);
    const int steps = strcmp(single.words[0], "step") == 0;
    const size_t times = steps ? strtoull(single.words[2], NULL, 10) : 1;
    if (steps) strcpy(single.words[2], "1");
    for (size_t k = 1; k <= times; ++k) {
        if (!hold(statement, perform(object, &call), CD_OK)) return 0;
        keep_state(statement, steps ? k : 0, made, precision, object);
    }
    return 1;
}

static uint64_t wanted_hash(const struct statement* statement, cd_precision precision) {
    if (statement->count != 3) fail_at(statement, "not two hashes", statement->words[0]);
    return strtoull(statement->words[precision == CD_FLOAT64 ? 2 : 1], NULL, 16);
}

/* One statement; a scene's new object takes the place of the last one. Whether the scene goes on. */
static int play(const struct statement* statement, cd_precision precision, cd_kernels kernels, struct object* object,
                struct statement* made) {
    struct arguments call = {statement, 0, precision};
    const char* word = statement->words[0];
    if (strcmp(word, "scene") == 0) {
        destroy(object);
        memset(object, 0, sizeof *object);
    } else if (strcmp(word, "create") == 0) {
        call.first = 1;
        if (!hold(statement, create(&call, kernels, object), CD_OK)) return 0;
        *made = *statement;
        for (size_t i = 0; i < statement->count; ++i)
            made->words[i] = made->text + (statement->words[i] - statement->text);
    } else if (strcmp(word, "copy") == 0 || strcmp(word, "save_and_load") == 0) {
        const struct arguments again = {made, 1, precision};
        struct object other;
        hold(statement, create(&again, kernels, &other), CD_OK);
        const int goes_on =
            hold(statement, word[0] == 'c' ? copy_state(&other, object) : save_and_load(&other, object), CD_OK);
        destroy(object);
        *object = other;
        return goes_on;
    } else if (strcmp(word, "refused") == 0) {
        call.first = 2;
        return hold(statement, perform(object, &call), enumerator_of(statement, statement->words[1]));
    } else if (written || compared_with) {
        return perform_and_keep(statement, made, precision, object);
    } else {
        return hold(statement, perform(object, &call), CD_OK);
    }
    return 1;
}

enum { MOST_HASHES = 1000 };
static uint64_t hashes[MOST_HASHES][2]; /* as they came out, float32 and float64 */

/* All scenes once; adds how many hashes were compared and wrong. With `update` those of the plain kernels are right. */
static void play_all(const char* text, cd_precision precision, cd_kernels kernels, int update, size_t* compared,
                     size_t* wrong) {
    static struct statement statement, made;
    struct object object = {NULL, NULL, NULL};
    char scene[64] = "";
    int goes_on = 1;
    for (size_t at = 0, line = 1, number = 0; next_statement(text, &at, &line, &statement);) {
        if (strcmp(statement.words[0], "scene") == 0 && statement.count == 2) {
            snprintf(scene, sizeof scene, "%s", statement.words[1]);
            goes_on = 1;
            ++played;
        }
        if (!goes_on) continue;
        if (strcmp(statement.words[0], "hash") != 0) {
            goes_on = play(&statement, precision, kernels, &object, &made);
            ended += !goes_on;
            continue;
        }
        ++*compared;
        if (written || compared_with)
            continue; /* nodes with targets go there in one call of step, not in each of many */
        if (number == MOST_HASHES) fail_at(&statement, "too many hashes", scene);
        const uint64_t hash = hash_of(&object);
        if (kernels == CD_KERNELS_PLAIN) hashes[number][precision] = hash;
        const uint64_t wanted = update ? hashes[number][precision] : wanted_hash(&statement, precision);
        ++number;
        if (hash == wanted) continue;
        fprintf(stderr, "%s, line %zu, float%d, %s: 0x%016" PRIx64 ", not 0x%016" PRIx64 "\n", scene, statement.line,
                precision == CD_FLOAT64 ? 64 : 32, cd_kernels_name(kernels), hash, wanted);
        ++*wrong;
    }
    destroy(&object);
}

int main(int count, char** arguments) {
    const char* option = count > 2 ? arguments[1] : "";
    const int update = strcmp(option, "--update") == 0, writes = strcmp(option, "--write") == 0,
              compares = strcmp(option, "--compare") == 0, flushed = strcmp(option, "--flushed") == 0;
    parts_are_left_out = strcmp(option, "--left-out") == 0;
    if (count != 2 + update + parts_are_left_out + flushed + 2 * (writes || compares))
        return fprintf(
                   stderr,
                   "conformance [--update | --left-out | --flushed | --write STATES | --compare STATES] SCENES.TXT\n"),
               2;
    if (flushed && !flush_denormal_numbers()) return puts("SKIPPED: not known how to flush denormal numbers here"), 77;
    if (writes && !(written = fopen(arguments[2], "wb"))) return perror(arguments[2]), 1;
    if (compares && !(compared_with = fopen(arguments[2], "rb"))) return perror(arguments[2]), 1;
    const char* path = arguments[count - 1];
    char* text = read_text(path);
    size_t wrong = 0, compared = 0;

    const int all_kernels = written || compared_with ? 1 : cd_runnable_kernels();
    for (cd_kernels kernels = CD_KERNELS_PLAIN; all_kernels >> kernels; ++kernels)
        for (cd_precision precision = CD_FLOAT32; precision <= CD_FLOAT64; ++precision)
            if (all_kernels >> kernels & 1) play_all(text, precision, kernels, update, &compared, &wrong);

    if (update) {
        FILE* file = fopen(path, "wb");
        if (!file) return perror(path), 1;
        static struct statement statement;
        size_t kept = 0;
        for (size_t at = 0, line = 1, number = 0; next_statement(text, &at, &line, &statement);) {
            if (strcmp(statement.words[0], "hash") != 0) continue;
            fwrite(text + kept, 1, statement.begin - kept, file);
            fprintf(file, "hash 0x%016" PRIx64 " 0x%016" PRIx64, hashes[number][0], hashes[number][1]);
            kept = statement.end;
            ++number;
        }
        fputs(text + kept, file);
        if (fclose(file)) return perror(path), 1;
    }
    free(text);
    if (written && fclose(written)) return perror(arguments[2]), 1;
    if (compared_with && fgetc(compared_with) != EOF) return fprintf(stderr, "more states than here\n"), 1;
    printf("%zu hashes %s, %zu wrong", compared,
           update               ? "written"
           : writes || compares ? "passed by"
                                : "compared",
           wrong);
    if (parts_are_left_out) printf("; %zu of %zu scenes ended where a part is left out", ended, played);
    puts(writes ? "; all states written" : compares ? "; all states are the same" : "");
    return wrong || compared == 0 || (parts_are_left_out && (ended == 0 || ended == played));
}
