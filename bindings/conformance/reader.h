/* Reads scenes.txt for the runners in C and C++: statements of words, and what the words mean. */
#ifndef CONFORMANCE_READER_H
#define CONFORMANCE_READER_H

#include <contdyn/contdyn.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One statement: its words, and where it stands in the text. */
struct statement {
    char* words[512];
    size_t count;
    size_t begin, end, line;
    char text[8192];
};

static void fail_at(const struct statement* statement, const char* what, const char* word) {
    fprintf(stderr, "line %zu: %s: '%s'\n", statement->line, what, word);
    exit(1);
}

/* The whole file with a null at its end; the caller frees it. */
static char* read_text(const char* path) {
    FILE* file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END)) {
        perror(path);
        exit(1);
    }
    const long size = ftell(file);
    char* text = (char*)calloc((size_t)size + 1, 1);
    rewind(file);
    if (!text || fread(text, 1, (size_t)size, file) != (size_t)size) {
        perror(path);
        exit(1);
    }
    fclose(file);
    return text;
}

/* The statement at or after text + *at, with the lines that continue it; 0 at the text's end. *line counts along. */
static int next_statement(const char* text, size_t* at, size_t* line, struct statement* out) {
    size_t length = 0;
    int inside = 0;
    out->count = 0;
    while (text[*at]) {
        const size_t begin = *at, size = strcspn(text + begin, "\n");
        const int continues = text[begin] == ' ', empty = size == 0 || text[begin] == '#';
        if (inside && !continues) break;
        if (!inside && !empty) {
            out->begin = begin;
            out->line = *line;
            inside = 1;
        }
        *at = begin + size + (text[begin + size] == '\n');
        ++*line;
        if (empty) continue;
        if (length + size + 2 > sizeof out->text) fail_at(out, "a statement of too many letters", "");
        memcpy(out->text + length, text + begin, size);
        out->text[length + size] = ' ';
        length += size + 1;
        out->end = begin + size;
    }
    out->text[length] = 0;
    for (char* word = strtok(out->text, " "); word; word = strtok(NULL, " ")) {
        if (out->count == sizeof out->words / sizeof *out->words) fail_at(out, "a statement of too many words", word);
        out->words[out->count++] = word;
    }
    return inside;
}

/* ---- arguments: the k-th of the call whose name is words[first] ------------------------------------------------- */

struct arguments {
    const struct statement* statement;
    size_t first;
    cd_precision precision; /* what the word `precision` stands for */
};

struct numbers {
    double values[512];
    float singles[512];
    size_t count;
    int null;
};

/* The word that the k-th argument begins with; "" if there is none. An array is one argument. */
static size_t argument_word(const struct arguments* call, size_t k) {
    size_t word = call->first + 1;
    for (; k > 0 && word < call->statement->count; --k, ++word) {
        if (strcmp(call->statement->words[word], "[") != 0) continue;
        while (word < call->statement->count && strcmp(call->statement->words[word], "]") != 0) ++word;
    }
    if (word >= call->statement->count)
        fail_at(call->statement, "too few arguments", call->statement->words[call->first]);
    return word;
}

static double number_of(const struct statement* statement, const char* word) {
    char* end;
    const double number = strtod(word, &end);
    if (*end) fail_at(statement, "no number", word);
    return number;
}

static inline double number_argument(const struct arguments* call, size_t k) {
    return number_of(call->statement, call->statement->words[argument_word(call, k)]);
}

static inline size_t size_argument(const struct arguments* call, size_t k) {
    char* end;
    const char* word = call->statement->words[argument_word(call, k)];
    const unsigned long long size = strtoull(word, &end, 10);
    if (*end) fail_at(call->statement, "no size", word);
    return (size_t)size;
}

static inline struct numbers array_argument(const struct arguments* call, size_t k) {
    static const struct numbers none = {{0}, {0}, 0, 1};
    struct numbers result = none;
    size_t word = argument_word(call, k);
    if (strcmp(call->statement->words[word], "null") == 0) return result;
    char* const* words = call->statement->words;
    if (strcmp(words[word], "[") != 0) fail_at(call->statement, "no array", words[word]);
    result.null = 0;
    for (++word; strcmp(words[word], "]") != 0; ++word) {
        if (word + 1 == call->statement->count) fail_at(call->statement, "an array without end", "");
        result.values[result.count] = number_of(call->statement, words[word]);
        result.singles[result.count] = (float)result.values[result.count];
        ++result.count;
    }
    return result;
}

#define ENUMERATOR(name) {#name, name},
static const struct {
    const char* name;
    int32_t value;
} enumerators[] = {
#include "enumerators.h"
};
#undef ENUMERATOR

static int32_t enumerator_of(const struct statement* statement, const char* word) {
    for (size_t i = 0; i < sizeof enumerators / sizeof *enumerators; ++i)
        if (strcmp(enumerators[i].name, word) == 0) return enumerators[i].value;
    fail_at(statement, "no enumerator", word);
    return 0;
}

static inline int32_t enum_argument(const struct arguments* call, size_t k) {
    const char* word = call->statement->words[argument_word(call, k)];
    return strcmp(word, "precision") == 0 ? call->precision : enumerator_of(call->statement, word);
}

#endif
