#define GALLERY_RECORDS
#include "record.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "film.h"

/* Of one object at most so many frames are kept: where more come, every second one goes, and so on. kDrawn of them are
 * drawn, in the time that passed or kMostSeconds. */
enum { kMostFrames = 128, kDrawn = 48, kMostTakes = 4, kMostParts = 32, kRound = 24, kOutlined = 6 };
static const double kMostSeconds = 12, kWidth = 1000, kHeight = 560, kGap = 40; /* s; units of the picture */
static const double kRange = 0.2;      /* of the width: heights of sheets and water are stretched to it, or left */
static const double kLeastDepth = 2e-3; /* of the deepest: what has less is drawn dry */
static const double kTurn = 6.283185307179586;

/* Lines of the same kind, and so many points each. */
typedef struct part {
    const char* kind;
    size_t lines, points;
} part;

/* x and y in the picture [m], and what is drawn upwards as many times as `stretch` of the take says. */
typedef struct spot {
    double x, y, up;
    int broken; /* the line has a gap before it */
} spot;

/* What was seen of one object. */
typedef struct take {
    const void* object; /* null once it is gone */
    part parts[kMostParts];
    size_t part_count, spots; /* of a frame */
    int stretches, weighs;
    double base; /* what water is drawn down to */
    spot* at;
    size_t frames, calls, stride;
    double seconds;
} take;

static take takes[kMostTakes];
static size_t take_count;

static double* numbers(size_t count) {
    double* const made = calloc(count, sizeof(double));
    if (!made) exit(1);
    return made;
}

/* ---- frames ------------------------------------------------------------------------------------------------------- */

static void add_part(take* of, const char* kind, size_t lines, size_t points) {
    const part added = {kind, lines, points};
    if (of->part_count == kMostParts) exit(1);
    of->parts[of->part_count++] = added;
    of->spots += lines * points;
}

static void write_picture(void);

/* The take of an object; null where there are enough. `is_new` ones have no parts yet. */
static take* take_of(const void* object, int* is_new) {
    *is_new = 0;
    for (size_t i = 0; i < take_count; ++i)
        if (takes[i].object == object) return &takes[i];
    if (take_count == kMostTakes) return NULL;
    if (take_count == 0) atexit(write_picture);
    *is_new = 1;
    takes[take_count].object = object, takes[take_count].stride = 1;
    return &takes[take_count++];
}

static void forget(const void* object) {
    for (size_t i = 0; i < take_count; ++i)
        if (takes[i].object == object) takes[i].object = NULL;
}

/* Room for the frame after this call of step; null where it is left out. */
static spot* next_frame(take* of, double seconds) {
    if (!of->at) of->at = calloc(kMostFrames * of->spots, sizeof(spot));
    if (!of->at) exit(1);
    of->seconds += seconds;
    if (of->calls++ % of->stride != 0) return NULL;
    if (of->frames == kMostFrames) {
        for (size_t i = 1; i < kMostFrames / 2; ++i)
            memcpy(of->at + i * of->spots, of->at + 2 * i * of->spots, of->spots * sizeof(spot));
        of->frames /= 2, of->stride *= 2;
    }
    return of->at + of->frames++ * of->spots;
}

/* ---- what is drawn ------------------------------------------------------------------------------------------------ */

/* Where a point is in the picture: x to the right, y away and a little to the right, up upwards. */
static spot above(double x, double y, double up) {
    const spot at = {x + 0.4 * y, 0.3 * y, up, 0};
    return at;
}

/* Points of a plane stand upright. */
static spot seen(const double* x, size_t components) {
    const spot flat = {x[0], x[1], 0, 0}, solid = {x[0] + 0.4 * x[1], x[2] + 0.3 * x[1], 0, 0};
    return components == 2 ? flat : solid;
}

/* What lies round both ends, which are the same of a ball. */
static spot* draw_capsule(spot* to, const double* first, const double* last, size_t components, double radius) {
    const spot a = seen(first, components), b = seen(last, components);
    const double along[2] = {b.x - a.x, b.y - a.y}, length = hypot(along[0], along[1]);
    const double ahead[2] = {length > 0 ? along[0] / length : 0, length > 0 ? along[1] / length : 1};
    for (int i = 0; i <= kRound; ++i) { /* half round the last one, half round the first */
        const double turn = kTurn * i / kRound, c = radius * cos(turn), s = radius * sin(turn);
        const spot middle = 2 * i < kRound ? b : a;
        to->x = middle.x + c * ahead[1] + s * ahead[0], to->y = middle.y + s * ahead[1] - c * ahead[0];
        to->up = 0, to++->broken = 0;
    }
    return to;
}

typedef cd_status (*collider_getter)(const void*, size_t, cd_shape*, double*, double*, double*, double*, size_t);

static cd_status chain_collider(const void* of, size_t i, cd_shape* shape, double* first, double* last, double* velocity,
                                double* radius, size_t components) {
    return cd_chain_get_collider(of, i, shape, first, last, velocity, components, radius, NULL);
}
static cd_status membrane_collider(const void* of, size_t i, cd_shape* shape, double* first, double* last,
                                   double* velocity, double* radius, size_t components) {
    return cd_membrane_get_collider(of, i, shape, first, last, velocity, components, radius, NULL);
}

/* Capsules only; of others the line is a point. */
static spot* draw_colliders(spot* to, const void* of, size_t count, size_t components, collider_getter get) {
    for (size_t i = 0; i < count; ++i) {
        cd_shape shape = CD_SHAPE_NONE;
        double first[3] = {0}, last[3] = {0}, radius = 0;
        if (get(of, i, &shape, first, last, NULL, &radius, components)) exit(1);
        to = draw_capsule(to, first, last, components, shape == CD_SHAPE_CAPSULE ? radius : 0);
    }
    return to;
}

/* A ball round the middle of `weights`, as large as `radius`; none where all are the same, or 0. */
static spot* draw_weight(spot* to, const double* x, const double* weights, size_t nodes, size_t components,
                         double radius) {
    double middle[3] = {0}, least = weights[0], sum = 0;
    for (size_t i = 1; i < nodes; ++i) least = fmin(least, weights[i]);
    for (size_t i = 0; i < nodes; ++i) sum += weights[i] - least;
    for (size_t i = 0; i < nodes && sum > 0; ++i)
        for (size_t k = 0; k < components; ++k) middle[k] += (weights[i] - least) / sum * x[i * components + k];
    return draw_capsule(to, sum > 0 ? middle : x, sum > 0 ? middle : x, components, sum > 0 ? radius : 0);
}

cd_status record_chain_step(cd_chain* chain, double dt, size_t count) {
    enum { kMostStrands = 24 };
    size_t strands, springs, components, colliders;
    int is_new;
    const cd_status status = cd_chain_step(chain, dt, count);
    take* const of = take_of(chain, &is_new);
    if (!of || cd_chain_get_shape(chain, &strands, &springs, &components, NULL)) return status;
    if (cd_chain_get_colliders(chain, &colliders)) exit(1);
    const size_t apart = (strands + kMostStrands - 1) / kMostStrands, nodes = springs + 1;
    if (is_new) {
        add_part(of, "body", colliders, kRound + 1);
        add_part(of, strands > 1 ? "hair" : "rope", (strands + apart - 1) / apart, nodes);
        add_part(of, "body", 2, kRound + 1);
    }
    spot* to = next_frame(of, dt * (double)count);
    if (!to) return status;
    to = draw_colliders(to, chain, colliders, components, chain_collider);
    double* const x = numbers(nodes * components), *const acts = numbers(nodes * components);
    double* const weights = numbers(nodes);
    double length = 0;
    for (size_t s = 0; s < strands; s += apart) {
        if (cd_chain_read_f64(chain, CD_POSITION, s, 1, 0, nodes, x, nodes * components)) exit(1);
        for (size_t i = 0; i < nodes; ++i) *to++ = seen(x + i * components, components);
    }
    for (size_t i = 1; i < nodes; ++i) length += hypot(to[-1].x - to[-2].x, to[-1].y - to[-2].y);
    /* What hangs at its nodes, or pushes at them. */
    if (strands > 1 || cd_chain_read_f64(chain, CD_MASS, 0, 1, 0, nodes, weights, nodes))
        memset(weights, 0, nodes * sizeof *weights);
    to = draw_weight(to, x, weights, nodes, components, 0.03 * length);
    memset(weights, 0, nodes * sizeof *weights);
    if (strands == 1 && !cd_chain_read_f64(chain, CD_FORCE, 0, 1, 0, nodes, acts, nodes * components))
        for (size_t i = 0; i < nodes * components; ++i) weights[i / components] += fabs(acts[i]);
    draw_weight(to, x, weights, nodes, components, 0.03 * length);
    free(x), free(acts), free(weights);
    return status;
}

static size_t smaller(size_t a, size_t b) { return a < b ? a : b; }

/* Which of `count` is drawn as the k-th of `drawn`, from the first to the last. */
static size_t place_of(size_t k, size_t drawn, size_t count) { return drawn > 1 ? k * (count - 1) / (drawn - 1) : 0; }

/* Whether a spring is cut between two nodes of a line that is the `line`-th along u or v, springs[v][u]. */
static int is_cut(const double* springs, int across, size_t columns, size_t line, size_t from, size_t to) {
    for (size_t i = from; i < to; ++i)
        if (springs[across ? i * columns + line : line * columns + i] == 0) return 1;
    return 0;
}

cd_status record_membrane_step(cd_membrane* membrane, double dt, size_t count) {
    enum { kMostLines = 13, kMostPoints = 33 };
    size_t nu, nv, components, colliders;
    int is_new, along_u, along_v;
    const cd_status status = cd_membrane_step(membrane, dt, count);
    take* const of = take_of(membrane, &is_new);
    if (!of || cd_membrane_get_shape(membrane, &nu, &nv, &components, NULL)) return status;
    if (cd_membrane_get_colliders(membrane, &colliders)) exit(1);
    if (cd_membrane_get_ring(membrane, &along_u, &along_v)) exit(1);
    const size_t nx = nu + !along_u, ny = nv + !along_v;
    const size_t lines[2] = {smaller(ny, kMostLines), smaller(nx, kMostLines)};
    const size_t points[2] = {smaller(nx, kMostPoints), smaller(ny, kMostPoints)};
    if (is_new) {
        of->stretches = components == 1;
        add_part(of, "body", colliders, kRound + 1);
        for (int across = 0; across < 2; ++across)
            add_part(of, components == 1 ? "sheet" : "cloth", lines[across], points[across]);
        double first;
        of->weighs = components == 3 && !cd_membrane_read_f64(membrane, CD_MASS, 0, 0, 1, 1, &first, 1);
        add_part(of, "body", of->weighs, kRound + 1);
    }
    spot* to = next_frame(of, dt * (double)count);
    if (!to) return status;
    to = draw_colliders(to, membrane, colliders, components, membrane_collider);
    double *const x = numbers(nx * ny * components), *const springs = numbers(nx * ny), *const there = numbers(nx * ny);
    if (cd_membrane_read_f64(membrane, CD_POSITION, 0, 0, nx, ny, x, nx * ny * components)) exit(1);
    const int all_there = cd_membrane_read_f64(membrane, CD_MASK, 0, 0, nx, ny, there, nx * ny) != CD_OK;
    for (int across = 0; across < 2; ++across) {
        const size_t columns = across ? nx : nu, rows = across ? nv : ny;
        const cd_field field = across ? CD_STIFFNESS_V : CD_STIFFNESS_U;
        const int have_own = !cd_membrane_read_f64(membrane, field, 0, 0, columns, rows, springs, columns * rows);
        for (size_t line = 0; line < lines[across]; ++line)
            for (size_t k = 0; k < points[across]; ++k) {
                const size_t a = place_of(line, lines[across], across ? nx : ny);
                const size_t b = place_of(k, points[across], across ? ny : nx), i = across ? a : b, j = across ? b : a;
                const double* const at = x + (j * nx + i) * components;
                const double right = (double)i / (double)(nx - 1), away = (double)j / (double)(ny - 1);
                *to = components == 1 ? above(right, away, at[0]) : seen(at, components);
                const size_t before = place_of(k > 0 ? k - 1 : 0, points[across], across ? ny : nx);
                to->broken = have_own && is_cut(springs, across, columns, a, before, b);
                if (!all_there && !(there[j * nx + i] > 0 && there[across ? before * nx + i : j * nx + before] > 0))
                    to->broken = 1;
                ++to;
            }
    }
    if (of->weighs) { /* what lies on it, as heavier nodes */
        const double* const end = x + (nx * ny - 1) * components;
        if (cd_membrane_read_f64(membrane, CD_MASS, 0, 0, nx, ny, springs, nx * ny)) exit(1);
        draw_weight(to, x, springs, nx * ny, components, 0.05 * hypot(end[0] - x[0], end[1] - x[1]));
    }
    free(x), free(springs), free(there);
    return status;
}

/* The outline of a hull at some height above its keel, which is not stretched. */
static spot* draw_outline(spot* to, const double* pose, double length, double width, double height) {
    static const double kOutline[][2] = {{-0.5, -0.5}, {-0.5, 0.5}, {0.2, 0.5}, {0.5, 0}, {0.2, -0.5}};
    for (int i = 0; i < kOutlined; ++i) {
        const double a = kOutline[i % 5][0] * length, b = kOutline[i % 5][1] * width;
        *to = above(pose[0] + a * pose[3] - b * pose[4], pose[1] + a * pose[4] + b * pose[3],
                      pose[2] + pose[5] * a + pose[6] * b);
        to++->y += height;
    }
    return to;
}

/* Rows from the last to the first, each the water down to the base and before it the ground, which hides what lies below
 * it: dry cells' surface too, which lies at the base. */
cd_status record_water_step(cd_water* water, double dt, size_t count) {
    enum { kMostRows = 12, kMostColumns = 49 };
    size_t nx, ny, hulls;
    double dx, dy;
    int is_new;
    const cd_status status = cd_water_step(water, dt, count);
    take* const of = take_of(water, &is_new);
    if (!of || cd_water_get_shape(water, &nx, &ny, &dx, &dy, NULL)) return status;
    if (cd_water_get_hulls(water, &hulls, NULL, NULL)) exit(1);
    const size_t columns = smaller(nx, kMostColumns), rows = smaller(ny, kMostRows);
    double *const depth = numbers(nx * ny), *const bed = numbers(nx * ny), deepest = 0, lowest, highest;
    if (cd_water_read_f64(water, CD_DEPTH, 0, 0, nx, ny, depth, nx * ny)) exit(1);
    if (cd_water_read_f64(water, CD_BED, 0, 0, nx, ny, bed, nx * ny)) memset(bed, 0, nx * ny * sizeof *bed);
    lowest = highest = bed[0];
    for (size_t i = 0; i < nx * ny; ++i) {
        deepest = fmax(deepest, depth[i]), lowest = fmin(lowest, bed[i]), highest = fmax(highest, bed[i] + depth[i]);
    }
    if (is_new) {
        of->stretches = 1;
        of->base = lowest - 0.15 * (highest - lowest);
        for (size_t j = 0; j < rows; ++j) add_part(of, "water", 1, columns + 2), add_part(of, "ground", 1, columns + 2);
        add_part(of, "hull", 2 * hulls, kOutlined);
    }
    spot* to = next_frame(of, dt * (double)count);
    for (size_t row = rows; to && row-- > 0;)
        for (int ground = 0; ground < 2; ++ground) {
            const size_t j = place_of(row, rows, ny);
            for (size_t k = 0; k < columns + 2; ++k) {
                const size_t i = place_of(k < columns ? k : k == columns ? columns - 1 : 0, columns, nx), cell = j * nx + i;
                const int is_wet = depth[cell] > kLeastDepth * deepest;
                const double surface = is_wet ? bed[cell] + depth[cell] : of->base;
                *to++ = above(((double)i + 0.5) * dx, ((double)j + 0.5) * dy,
                              k >= columns ? of->base : ground ? bed[cell] : surface);
            }
        }
    for (size_t h = 0; to && h < hulls; ++h) {
        double pose[7], length, width;
        if (cd_water_get_hull_floor(water, h, pose, 7)) exit(1);
        if (cd_water_get_hull(water, h, NULL, &length, &width, NULL, NULL, 0)) exit(1);
        to = draw_outline(to, pose, length, width, 0);
        to = draw_outline(to, pose, length, width, 0.2 * width);
    }
    free(depth), free(bed);
    return status;
}

void record_chain_destroy(cd_chain* chain) { forget(chain), cd_chain_destroy(chain); }
void record_membrane_destroy(cd_membrane* membrane) { forget(membrane), cd_membrane_destroy(membrane); }
void record_water_destroy(cd_water* water) { forget(water), cd_water_destroy(water); }

/* ---- the picture -------------------------------------------------------------------------------------------------- */

typedef struct range {
    double least, most;
} range;

static void widen(range* of, double by) { of->least = fmin(of->least, by), of->most = fmax(of->most, by); }

static const char* const kStyle =
    "path{fill:none;stroke-linecap:round;stroke-linejoin:round}"
    ".rope{stroke:#c07830;stroke-width:8}.hair{stroke:#a0522d;stroke-width:4}.sheet{stroke:#c04848;stroke-width:3}"
    ".cloth{stroke:#7858a8;stroke-width:3}.water{stroke:#2878c0;stroke-width:2;fill:#b8d8f0}"
    ".ground{stroke:#907850;stroke-width:2;fill:#d8c8a8}.body{fill:#a0a0a0;fill-opacity:.8}"
    ".hull{stroke:#804020;stroke-width:3;fill:#c08050;fill-opacity:.8}"
    "@media(prefers-color-scheme:dark){.hair{stroke:#d09060}.sheet{stroke:#e87878}.cloth{stroke:#b098e0}"
    ".water{stroke:#60a8e8;fill:#204060}.ground{stroke:#a89068;fill:#484030}}";

/* How a take is laid into its box: what is lower than the least `up` is drawn there. */
typedef struct fit {
    range x, y, up;
    double stretch, scale, height;
} fit;

/* Deep water is cut off as far below its lowest surface as that rises and falls, ground with it. */
static double lowest_up(const take* of) {
    range surface = {1e300, -1e300};
    const spot* at = of->at;
    for (size_t f = 0; f < of->frames; ++f)
        for (size_t p = 0; p < of->part_count; at += of->parts[p].lines * of->parts[p].points, ++p)
            for (size_t i = 0; i < of->parts[p].points && strcmp(of->parts[p].kind, "water") == 0; ++i)
                if (at[i].up > of->base) widen(&surface, at[i].up);
    return surface.most > surface.least ? surface.least - (surface.most - surface.least) : -1e300;
}

static double height_of(const spot* at, const fit* in) { return at->y + in->stretch * fmax(at->up, in->up.least); }

static fit fit_of(const take* of, double width) {
    const range none = {1e300, -1e300};
    const size_t count = of->frames * of->spots;
    fit made = {none, none, none, 0, 0, 0};
    for (size_t i = 0; i < count; ++i) widen(&made.x, of->at[i].x), widen(&made.up, of->at[i].up);
    made.up.least = fmax(made.up.least, lowest_up(of));
    const double wide = made.x.most - made.x.least;
    if (of->stretches) made.stretch = fmax(1, kRange * wide / (made.up.most - made.up.least));
    for (size_t i = 0; i < count; ++i) widen(&made.y, height_of(&of->at[i], &made));
    const double high = made.y.most - made.y.least;
    made.scale = fmin(width / wide, kHeight / high);
    made.height = made.scale * high;
    return made;
}

/* Writes a take into its box, whose middle above is at `middle` and 0. */
static void write_take(const take* of, FILE* out, const fit* in, double middle, double seconds) {
    const spot* first = of->at;
    for (size_t p = 0; p < of->part_count; ++p) {
        const part* const drawn = &of->parts[p];
        const size_t points = drawn->lines * drawn->points;
        film made;
        if (points == 0) continue;
        if (!film_create(&made, drawn->lines, drawn->points, kDrawn, seconds)) exit(1);
        for (size_t f = 0; f <= kDrawn; ++f)
            for (size_t i = 0; i < points; ++i) {
                const spot* const at = first + place_of(f % kDrawn, kDrawn, of->frames) * of->spots + i;
                film_set(&made, f, i / drawn->points, i % drawn->points,
                         middle + in->scale * (at->x - 0.5 * (in->x.least + in->x.most)),
                         in->scale * (in->y.most - height_of(at, in)));
                if (at->broken) film_break(&made, f, i / drawn->points, i % drawn->points);
            }
        film_write(&made, out, drawn->kind);
        film_destroy(&made);
        first += points;
    }
}

static void write_picture(void) {
    const char* const name = getenv("CONTDYN_PICTURE");
    FILE* const out = name ? fopen(name, "w") : NULL;
    const double width = (kWidth - kGap * (double)(take_count + 1)) / (double)take_count;
    double longest = 0, highest = 0;
    fit fits[kMostTakes];
    if (!out) return;
    for (size_t i = 0; i < take_count; ++i) {
        fits[i] = fit_of(&takes[i], width);
        longest = fmax(longest, fmin(takes[i].seconds, kMostSeconds)), highest = fmax(highest, fits[i].height);
    }
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 %g %g %.0f\">\n<style>%s</style>\n", -kGap, kWidth,
            highest + 2 * kGap, kStyle);
    for (size_t i = 0; i < take_count; ++i)
        write_take(&takes[i], out, &fits[i], kGap + width / 2 + (width + kGap) * (double)i, longest);
    fputs("</svg>\n", out);
    fclose(out);
}
