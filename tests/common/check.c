#include "check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "refusals.h"

struct outputs out;

static uint64_t hash_before;
static struct outputs out_before;

static void stop(const char* file, int line) { _fail(file, line); }

void check_ok(cd_status status, const char* call, const char* file, int line) {
    if (status == CD_OK) return;
    print_error("%s\n    gives %s: %s\n", call, cd_status_name(status), cd_error_message());
    stop(file, line);
}

uint64_t hash_of_chain(const void* object) {
    uint64_t hash = 0;
    ok(cd_chain_hash(object, &hash));
    return hash;
}

uint64_t hash_of_membrane(const void* object) {
    uint64_t hash = 0;
    ok(cd_membrane_hash(object, &hash));
    return hash;
}

uint64_t hash_of_water(const void* object) {
    uint64_t hash = 0;
    ok(cd_water_hash(object, &hash));
    return hash;
}

uint64_t hash_of_nothing(const void* object) {
    assert_null(object);
    return 0;
}

static size_t name_length(const char* call) { return strcspn(call, "( \n"); }

void refusal_begin(const void* object, hash_function* hash, const char* call) {
    hash_before = hash(object);
    memset(&out, 0xA5, sizeof out);
    memcpy(&out_before, &out, sizeof out);
    /* a message of another function, so that one left over from before is not taken for this call's */
    if (strncmp(call, "cd_saved_shape(", 15) == 0) cd_chain_get_time(NULL, NULL);
    else cd_saved_shape(NULL, 1, NULL, NULL, NULL, NULL, NULL);
}

const struct bad_number not_finite[NOT_FINITE] = {{NAN, "nan"}, {INFINITY, "inf"}, {-INFINITY, "-inf"}};
const struct bad_number negative[NEGATIVE] = {{-1, "-1"}, {-0x1p-1000, ""}};
const struct bad_number too_large[TOO_LARGE] = {{1.0625e60, "1.0625e+60"}, {1e300, "1e+300"}};
const struct bad_number too_small[TOO_SMALL] = {{0.5e-60, "5e-61"}, {0x1p-1074, ""}};

static bool is_name_character(char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/* Does `message` hold the piece, not as a part of a longer word or number? */
static bool holds(const char* message, const char* piece, size_t length) {
    for (const char* at = message; *at; ++at) {
        if (strncmp(at, piece, length) != 0) continue;
        const bool starts = at == message || !is_name_character(at[-1]) || !is_name_character(piece[0]);
        const bool ends = !is_name_character(at[length]) || !is_name_character(piece[length - 1]);
        if (starts && ends) return true;
    }
    return false;
}

void refusal_end(const void* object, hash_function* hash, cd_status got, cd_status wanted, const char* call,
                 const char* text, const char* file, int line) {
    const char* message = cd_error_message();
    if (got != wanted) {
        print_error("%s\n    gives %s, not %s; the last message is: %s\n", call, cd_status_name(got),
                    cd_status_name(wanted), message);
        stop(file, line);
    }
    char function[64];
    snprintf(function, sizeof function, "%.*s", (int)name_length(call), call);
    bool complete = strncmp(message, function, strlen(function)) == 0 && message[strlen(function)] == ':';
    const char* rest = complete ? message + strlen(function) + 1 : message;
    const bool unnamed = *text == '~';
    const char* argument = text + unnamed;
    for (const char* piece = unnamed ? argument + strcspn(argument, "|") : argument; *piece;) {
        piece += *piece == '|';
        const size_t length = strcspn(piece, "|");
        if (!holds(rest, piece, length)) complete = false;
        piece += length;
    }
    if (!complete) {
        print_error("%s\n    says \"%s\": not the function and then, each, %s\n", call, message, text);
        stop(file, line);
    }
    if (hash(object) != hash_before) {
        print_error("%s\n    is refused, and yet it changes the object\n", call);
        stop(file, line);
    }
    if (memcmp(&out, &out_before, sizeof out) != 0) {
        print_error("%s\n    is refused, and yet it writes to an output\n", call);
        stop(file, line);
    }
    remember_refusal(function, got, argument);
}

const char* text_of(const char* format, ...) {
    static char texts[8][96];
    static unsigned next;
    char* text = texts[next++ % 8];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof texts[0], format, arguments);
    va_end(arguments);
    return text;
}

const char* name_and_size(const char* name, size_t value) { return text_of("%s|%zu", name, value); }

void check_near(double a, double b, double tolerance, double size, const char* what, const char* file, int line) {
    const double scale = fmax(fmax(fabs(a), fabs(b)), size);
    if (a == b || (isfinite(scale) && fabs(a - b) <= tolerance * scale)) return;
    print_error("%s: %.17g and %.17g differ by %.3g of %.3g, allowed %.3g\n", what, a, b, fabs(a - b) / scale, scale,
                tolerance);
    stop(file, line);
}

int is_long(void) { return getenv("CD_LONG") != NULL; }

int is_brief(void) { return getenv("CD_BRIEF") != NULL; }

uint64_t other_scenes(void) {
    const char* const seed = getenv("CD_SEED");
    return seed ? strtoull(seed, NULL, 0) : 0;
}

int is_taken(size_t number, size_t part) { return is_long() || number % part == 0; }
