/* Moving pictures as SVG: lines whose points move for some seconds, and then again. Lengths are in the units of the
 * picture, whole numbers in the file. */
#ifndef GALLERY_FILM_H
#define GALLERY_FILM_H

#include <stddef.h>
#include <stdio.h>

/* `lines` lines of `points` points each in `frames` frames, and in one more that should be as the first one is again. */
typedef struct film {
    size_t lines, points, frames;
    double seconds;
    double* at;   /* x and y of point after point, line after line, frame after frame */
    char* broken; /* whether there is a gap before the point, in the same order */
} film;

/* 0 where there is no memory. Released with film_destroy. */
int film_create(film* made, size_t lines, size_t points, size_t frames, double seconds);
void film_destroy(film* gone);

void film_set(film* of, size_t frame, size_t line, size_t point, double x, double y);

/* The line has a gap before this point. */
void film_break(film* of, size_t frame, size_t line, size_t point);

/* How far the last frame is from the first one, at most of all points. */
double film_jump(const film* of);

/* Writes the lines as paths of a class of the picture's style; the later ones lie over the earlier. */
void film_write(const film* of, FILE* out, const char* kind);

#endif
