#include "film.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int film_create(film* made, size_t lines, size_t points, size_t frames, double seconds) {
    const size_t count = lines * points * (frames + 1);
    const film empty = {lines, points, frames, seconds, calloc(2 * count, sizeof(double)), calloc(count, 1)};
    *made = empty;
    return made->at && made->broken;
}

void film_destroy(film* gone) { free(gone->at), free(gone->broken); }

static size_t index_of(const film* of, size_t frame, size_t line, size_t point) {
    return (frame * of->lines + line) * of->points + point;
}

static double* place(const film* of, size_t frame, size_t line, size_t point) {
    return of->at + 2 * index_of(of, frame, line, point);
}

void film_set(film* of, size_t frame, size_t line, size_t point, double x, double y) {
    double* const at = place(of, frame, line, point);
    at[0] = x, at[1] = y;
}

void film_break(film* of, size_t frame, size_t line, size_t point) { of->broken[index_of(of, frame, line, point)] = 1; }

double film_jump(const film* of) {
    const double *first = place(of, 0, 0, 0), *last = place(of, of->frames, 0, 0);
    double most = 0;
    for (size_t i = 0; i < of->lines * of->points; ++i)
        most = fmax(most, hypot(last[2 * i] - first[2 * i], last[2 * i + 1] - first[2 * i + 1]));
    return most;
}

/* Points after the first one relative to the one before, and a command only where it is another: shorter. A gap always
 * has its own, for what follows one is a line. */
static void write_line(const film* of, FILE* out, size_t frame, size_t line) {
    long x = 0, y = 0;
    char last = 'M';
    for (size_t i = 0; i < of->points; ++i) {
        const double* const at = place(of, frame, line, i);
        const long next_x = lround(at[0]), next_y = lround(at[1]);
        const char command = i == 0 ? 'M' : of->broken[index_of(of, frame, line, i)] ? 'm' : 'l';
        fprintf(out, "%c%ld %ld", command == 'l' && command == last ? ' ' : command, next_x - x, next_y - y);
        x = next_x, y = next_y, last = command;
    }
}

static int is_still(const film* of, size_t line) {
    const size_t numbers = 2 * of->points;
    for (size_t frame = 1; frame <= of->frames; ++frame) {
        if (memcmp(of->broken + index_of(of, frame, line, 0), of->broken + index_of(of, 0, line, 0), of->points)) return 0;
        for (size_t i = 0; i < numbers; ++i)
            if (lround(place(of, frame, line, 0)[i]) != lround(place(of, 0, line, 0)[i])) return 0;
    }
    return 1;
}

void film_write(const film* of, FILE* out, const char* kind) {
    for (size_t line = 0; line < of->lines; ++line) {
        fprintf(out, "<path class=\"%s\" d=\"", kind);
        write_line(of, out, 0, line);
        if (is_still(of, line)) {
            fputs("\"/>\n", out);
            continue;
        }
        fprintf(out, "\"><animate attributeName=\"d\" dur=\"%gs\" repeatCount=\"indefinite\" values=\"", of->seconds);
        for (size_t frame = 0; frame < of->frames; ++frame) write_line(of, out, frame, line), fputs(";", out);
        write_line(of, out, 0, line);
        fputs("\"/></path>\n", out);
    }
}
