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
