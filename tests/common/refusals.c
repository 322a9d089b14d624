#include "refusals.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"

enum { REFUSALS = 4096 };

static struct {
    char function[64];
    char argument[32];
    cd_status status;
} refusals[REFUSALS];
static size_t refused;

void remember_refusal(const char* function, cd_status status, const char* text) {
    char argument[32];
    snprintf(argument, sizeof argument, "%.*s", (int)strcspn(text, "|"), text);
    if (was_refused(function, status, argument)) return;
    assert_true(refused < REFUSALS);
    strcpy(refusals[refused].function, function);
    strcpy(refusals[refused].argument, argument);
    refusals[refused++].status = status;
}

bool was_refused(const char* function, cd_status status, const char* argument) {
    for (size_t i = 0; i < refused; ++i)
        if (refusals[i].status == status && strcmp(refusals[i].function, function) == 0 &&
            strcmp(refusals[i].argument, argument) == 0)
            return true;
    return false;
}

static char* read_header(const char* header) {
    char path[1024];
    snprintf(path, sizeof path, "%s/contdyn/%s", CD_INCLUDE_DIR, header);
    FILE* file = fopen(path, "rb");
    if (!file) fail_msg("cannot open %s", path);
    static char text[1 << 17];
    const size_t size = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    assert_true(size < sizeof text - 1);
    text[size] = 0;
    return text;
}

/* Comments become spaces. */
static void strip_comments(char* text) {
    for (char* at = text; (at = strstr(at, "/*"));) {
        char* end = strstr(at, "*/");
        assert_non_null(end);
        memset(at, ' ', (size_t)(end + 2 - at));
    }
}

/* "const double* values" into type and name; blanks are squeezed. */
static void parse_parameter(const char* from, size_t length, struct parameter* out_parameter) {
    char flat[128];
    size_t used = 0;
    for (size_t i = 0; i < length; ++i) {
        const char c = isspace((unsigned char)from[i]) ? ' ' : from[i];
        if (c == ' ' && (used == 0 || flat[used - 1] == ' ')) continue;
        assert_true(used + 1 < sizeof flat);
        flat[used++] = c;
    }
    flat[used] = 0;
    char* name = strrchr(flat, ' ');
    assert_non_null(name);
    *name++ = 0;
    assert_true(strlen(flat) < sizeof out_parameter->type && strlen(name) < sizeof out_parameter->name);
    strcpy(out_parameter->type, flat);
    strcpy(out_parameter->name, name);
}

static void parse_prototype(const char* declaration, struct prototype* out_prototype) {
    const char* open = strchr(declaration, '(');
    const char* close = strchr(declaration, ')');
    assert_true(open && close && open < close);
    const char* name = open;
    while (isalnum((unsigned char)name[-1]) || name[-1] == '_') --name;
    memset(out_prototype, 0, sizeof *out_prototype);
    snprintf(out_prototype->name, sizeof out_prototype->name, "%.*s", (int)(open - name), name);
    if (strncmp(open, "(void)", 6) == 0) return;
    for (const char* at = open + 1; at < close;) {
        const size_t length = strcspn(at, ",)");
        assert_true(out_prototype->count < PARAMETERS);
        parse_parameter(at, length, &out_prototype->parameters[out_prototype->count++]);
        at += length + 1;
    }
}

size_t read_prototypes(const char* header, struct prototype* out_prototypes, size_t capacity) {
    char* text = read_header(header);
    strip_comments(text);
    size_t count = 0;
    for (const char* at = text; (at = strstr(at, "CD_API ")); at += 7) {
        if (at != text && at[-1] != '\n') continue; /* "#define CD_API" */
        assert_true(count < capacity);
        parse_prototype(at + 7, &out_prototypes[count++]);
    }
    assert_true(count > 0);
    return count;
}

/* "cd_chain*" and "const cd_chain*", where the function's name starts with "cd_chain_" */
static bool is_object(const struct prototype* function, const struct parameter* parameter) {
    const char* type = strncmp(parameter->type, "const ", 6) == 0 ? parameter->type + 6 : parameter->type;
    const size_t length = strcspn(type, "*");
    return strcmp(type + length, "*") == 0 && strncmp(type, function->name, length) == 0 &&
           function->name[length] == '_';
}

static bool has_field(const struct prototype* function) {
    for (size_t j = 0; j < function->count; ++j)
        if (strcmp(function->parameters[j].type, "cd_field") == 0) return true;
    return false;
}

static bool field_argument_tried(const struct prototype* function, const struct parameter* parameter) {
    if (!has_field(function) || is_object(function, parameter) || strncmp(parameter->name, "out_", 4) == 0) return true;
    cd_status status = CD_ERROR_VALUE;
    if (strcmp(parameter->type, "cd_field") == 0) status = CD_ERROR_ENUM;
    if (strcmp(parameter->type, "size_t") == 0) status = CD_ERROR_RANGE;
    return was_refused(function->name, status, parameter->name);
}

void all_field_arguments_were_tried(const char* object) {
    static struct prototype functions[128];
    char header[64];
    snprintf(header, sizeof header, "%s.h", object);
    const size_t all = read_prototypes(header, functions, COUNT(functions));
    size_t missing = 0;
    for (size_t i = 0; i < all; ++i) {
        for (size_t j = 0; j < functions[i].count; ++j) {
            const struct parameter* parameter = &functions[i].parameters[j];
            if (field_argument_tried(&functions[i], parameter)) continue;
            print_error("%s: nothing bad was tried for %s %s\n", functions[i].name, parameter->type, parameter->name);
            ++missing;
        }
    }
    assert_int_equal(missing, 0);
}
