/* pictures FILE: draws a rope, hair, cloth, a drum and a boat on a pool as the moving picture that the README shows. Each
 * is driven in turns of 4 s and drawn once it has come to repeat itself; how far it ends from where it began is printed. */
#include <contdyn/contdyn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "film.h"

enum { kRate = 60, kFrames = 40, kSteps = 6, kPeriod = kFrames * kSteps }; /* steps a second, and of a picture */
static const double kTurn = 6.283185307179586, kDt = 1.0 / kRate, kSeconds = (double)kPeriod / kRate;

static void must(cd_status status) {
    if (status == CD_OK) return;
    fprintf(stderr, "%s\n", cd_error_message());
    exit(1);
}

static void start(film* drawn, size_t lines, size_t points) {
    if (!film_create(drawn, lines, points, kFrames, kSeconds)) exit(1);
}

static const double kMostJump = 5; /* units of the picture, which is 10000 wide */

static void end(film* drawn, FILE* out, const char* name, const char* kind) {
    film_write(drawn, out, kind);
    printf("%s ends %.1f from where it began\n", name, film_jump(drawn));
    if (!(film_jump(drawn) <= kMostJump)) exit(1);
    film_destroy(drawn);
}

/* A rope of 1.2 m, whose first node is led round an ellipse, in the air and over a peg. */
static void rope(FILE* out) {
    enum { kSprings = 60, kDrawn = 31 };
    const double gravity[2] = {0, -9.81}, peg[2] = {0, -0.5}, radius = 0.16;
    double x[2 * (kSprings + 1)];
    cd_chain* chain;
    film drawn;
    start(&drawn, 1, kDrawn);
    must(cd_chain_create(1, kSprings, 2, CD_FLOAT64, NULL, &chain));
    for (int i = 0; i <= kSprings; ++i) x[2 * i] = 0.4 + 1.2 * i / kSprings, x[2 * i + 1] = 0;
    must(cd_chain_write_f64(chain, CD_POSITION, 0, 1, 0, kSprings + 1, x, 2 * (kSprings + 1)));
    must(cd_chain_set_mass(chain, 0.1));
    must(cd_chain_set_rest_length(chain, 1.2));
    must(cd_chain_set_stiffness(chain, INFINITY));
    must(cd_chain_set_gravity(chain, gravity, 2));
    must(cd_chain_set_air(chain, 0.05, 0.3));
    must(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_POSED));
    must(cd_chain_set_colliders(chain, 1));
    must(cd_chain_set_capsule(chain, 0, peg, peg, 2, radius, 0.3));
    for (int step = 0; step <= 3 * kPeriod; ++step) {
        const double turn = kTurn * (step + 1) / kPeriod, hand[2] = {0.55 * cos(turn), 0.15 * sin(2 * turn)};
        const int now = step - 2 * kPeriod;
        if (now >= 0 && now % kSteps == 0) {
            must(cd_chain_read_f64(chain, CD_POSITION, 0, 1, 0, kSprings + 1, x, 2 * (kSprings + 1)));
            for (size_t i = 0; i < kDrawn; ++i)
                film_set(&drawn, (size_t)(now / kSteps), 0, i, 1000 + 1000 * x[4 * i], 200 - 1000 * x[4 * i + 1]);
        }
        must(cd_chain_write_f64(chain, CD_TARGET, 0, 1, 0, 1, hand, 2));
        must(cd_chain_step(chain, kDt, 1));
    }
    fprintf(out, "<circle class=\"body\" cx=\"%.0f\" cy=\"%.0f\" r=\"%.0f\"/>\n", 1000 + 1000 * peg[0],
            200 - 1000 * peg[1], 1000 * radius - 12);
    end(&drawn, out, "rope", "rope");
    cd_chain_destroy(chain);
}

/* Hair on a head that goes from side to side and turns. */
static void hair(FILE* out) {
    enum { kStrands = 22, kSprings = 14 };
    const double gravity[2] = {0, -9.81}, radius = 0.32, length = 0.75;
    double x[2 * kStrands * (kSprings + 1)], centre[2] = {0, 0};
    cd_chain* chain;
    film drawn, head;
    start(&drawn, kStrands, kSprings + 1);
    start(&head, 1, 41);
    must(cd_chain_create(kStrands, kSprings, 2, CD_FLOAT64, NULL, &chain));
    for (int s = 0; s < kStrands; ++s) {
        const double angle = kTurn * (-0.05 + 0.6 * s / (kStrands - 1));
        for (int i = 0; i <= kSprings; ++i) {
            const double from = radius + length * i / kSprings, *const c = centre;
            double* const at = x + 2 * (s * (kSprings + 1) + i);
            at[0] = c[0] + from * cos(angle), at[1] = c[1] + from * sin(angle);
        }
    }
    must(cd_chain_write_f64(chain, CD_POSITION, 0, kStrands, 0, kSprings + 1, x, sizeof x / sizeof *x));
    must(cd_chain_set_mass(chain, 0.01));
    must(cd_chain_set_rest_length(chain, length));
    must(cd_chain_set_stiffness(chain, INFINITY));
    must(cd_chain_set_gravity(chain, gravity, 2));
    must(cd_chain_set_air(chain, 0.005, 0.03));
    must(cd_chain_set_end(chain, CD_END_FIRST, CD_NODE_POSED));
    must(cd_chain_set_colliders(chain, 1));
    must(cd_chain_set_capsule(chain, 0, centre, centre, 2, radius - 0.01, 0.2));
    for (int step = 0; step <= 3 * kPeriod; ++step) {
        const double turn = kTurn * 2 * (step + 1) / kPeriod, tilt = 0.35 * sin(turn);
        const double next[2] = {0.35 * sin(turn), 0.05 * cos(2 * turn) - 0.05};
        const double velocity[2] = {(next[0] - centre[0]) / kDt, (next[1] - centre[1]) / kDt};
        const int now = step - 2 * kPeriod;
        if (now >= 0 && now % kSteps == 0) {
            const size_t frame = (size_t)(now / kSteps);
            must(cd_chain_read_f64(chain, CD_POSITION, 0, kStrands, 0, kSprings + 1, x, sizeof x / sizeof *x));
            for (size_t i = 0; i < sizeof x / sizeof *x / 2; ++i)
                film_set(&drawn, frame, i / (kSprings + 1), i % (kSprings + 1), 1000 + 1000 * x[2 * i],
                         600 - 1000 * x[2 * i + 1]);
            for (size_t i = 0; i <= 40; ++i)
                film_set(&head, frame, 0, i, 1000 + 1000 * (centre[0] + (radius - 0.01) * cos(kTurn * i / 40)),
                         600 - 1000 * (centre[1] + (radius - 0.01) * sin(kTurn * i / 40)));
        }
        for (int s = 0; s < kStrands; ++s) {
            const double angle = kTurn * (-0.05 + 0.6 * s / (kStrands - 1)) - tilt;
            const double root[2] = {next[0] + radius * cos(angle), next[1] + radius * sin(angle)};
            must(cd_chain_write_f64(chain, CD_TARGET, (size_t)s, 1, 0, 1, root, 2));
        }
        must(cd_chain_set_collider_velocity(chain, 0, velocity, 2));
        must(cd_chain_step(chain, kDt, 1));
        centre[0] = next[0], centre[1] = next[1];
    }
    film_write(&head, out, "body");
    film_destroy(&head);
    end(&drawn, out, "hair", "hair");
    cd_chain_destroy(chain);
}

/* A cloth of 1 m that hangs by its upper edge, which sways, against a ball. */
static void cloth(FILE* out) {
    enum { kSprings = 28, kNodes = kSprings + 1, kRows = 15 };
    const double gravity[3] = {0, 0, -9.81}, ball[3] = {0.5, 0.1, -0.62}, radius = 0.22;
    static double x[kNodes * kNodes * 3];
    cd_membrane* membrane;
    film drawn;
    start(&drawn, 2 * kRows, kNodes);
    must(cd_membrane_create(kSprings, kSprings, 3, CD_FLOAT64, NULL, &membrane));
    for (int i = 0; i < kNodes * kNodes; ++i) {
        x[3 * i] = (double)(i % kNodes) / kSprings, x[3 * i + 1] = -0.13, x[3 * i + 2] = -(double)(i / kNodes) / kSprings;
    }
    must(cd_membrane_write_f64(membrane, CD_POSITION, 0, 0, kNodes, kNodes, x, sizeof x / sizeof *x));
    must(cd_membrane_set_mass(membrane, 0.2));
    must(cd_membrane_set_rest_length(membrane, 1, 1));
    must(cd_membrane_set_stiffness(membrane, 1000, 1000));
    must(cd_membrane_set_shear(membrane, 50));
    must(cd_membrane_set_bend(membrane, 1e-3));
    must(cd_membrane_set_gravity(membrane, gravity, 3));
    must(cd_membrane_set_air(membrane, 0.3, 3));
    must(cd_membrane_set_edge(membrane, CD_EDGE_V_FIRST, CD_NODE_POSED));
    must(cd_membrane_set_colliders(membrane, 1));
    must(cd_membrane_set_capsule(membrane, 0, ball, ball, 3, radius, 0.1));
    for (int step = 0; step <= 3 * kPeriod; ++step) {
        const double turn = kTurn * 2 * (step + 1) / kPeriod;
        double edge[kNodes][3];
        const int now = step - 2 * kPeriod;
        if (now >= 0 && now % kSteps == 0) {
            must(cd_membrane_read_f64(membrane, CD_POSITION, 0, 0, kNodes, kNodes, x, sizeof x / sizeof *x));
            for (size_t line = 0; line < 2 * kRows; ++line)
                for (size_t i = 0; i < kNodes; ++i) {
                    const size_t along = line < kRows ? i + 2 * line * kNodes : i * kNodes + 2 * (line - kRows);
                    const double* const at = x + 3 * along;
                    film_set(&drawn, (size_t)(now / kSteps), line, i, 450 + 1000 * at[0] + 500 * at[1],
                             220 - 1000 * at[2] + 300 * at[1]);
                }
        }
        for (int i = 0; i < kNodes; ++i) {
            edge[i][0] = (double)i / kSprings * (0.9 + 0.08 * cos(turn)), edge[i][1] = -0.1 + 0.25 * sin(turn);
            edge[i][2] = 0;
        }
        must(cd_membrane_write_f64(membrane, CD_TARGET, 0, 0, kNodes, 1, edge[0], 3 * kNodes));
        must(cd_membrane_step(membrane, kDt, 1));
    }
    end(&drawn, out, "cloth", "cloth");
    cd_membrane_destroy(membrane);
}

/* A square drum of 1 m, struck beside its middle. */
static void drum(FILE* out) {
    enum { kSprings = 32, kRows = 17 };
    const double kick = 0.1;
    double z[(kSprings + 1) * (kSprings + 1)];
    cd_membrane* membrane;
    film drawn;
    start(&drawn, kRows, kSprings + 1);
    must(cd_membrane_create(kSprings, kSprings, 1, CD_FLOAT64, NULL, &membrane));
    for (cd_edge edge = CD_EDGE_U_FIRST; edge <= CD_EDGE_V_LAST; ++edge)
        must(cd_membrane_set_edge(membrane, edge, CD_NODE_PINNED));
    must(cd_membrane_set_mass(membrane, 0.2));
    must(cd_membrane_set_stiffness(membrane, 1, 1));
    must(cd_membrane_set_drag(membrane, 1.5));
    for (int step = 0; step <= 2 * kPeriod; ++step) {
        if (step % kPeriod == kSteps) must(cd_membrane_impulse(membrane, 12, 18, 5, &kick, 1));
        const int now = step - kPeriod;
        if (now >= 0 && now % kSteps == 0) {
            must(cd_membrane_read_f64(membrane, CD_POSITION, 0, 0, kSprings + 1, kSprings + 1, z, sizeof z / sizeof *z));
            for (size_t j = 0; j < kRows; ++j)
                for (size_t i = 0; i <= kSprings; ++i) {
                    const double slant = 300.0 * j / (kRows - 1);
                    film_set(&drawn, (size_t)(now / kSteps), kRows - 1 - j, i, 200 + 1300.0 * i / kSprings + slant,
                             1150 - 700.0 * j / (kRows - 1) - 1300 * z[2 * j * (kSprings + 1) + i]);
                }
        }
        must(cd_membrane_step(membrane, kDt, 1));
    }
    end(&drawn, out, "drum", "sheet");
    cd_membrane_destroy(membrane);
}

/* A pool of 3 m x 2 m, 0.3 m deep, and a boat of 0.7 m that is led round in it. */
static void pool(FILE* out) {
    enum { kX = 42, kY = 28, kRows = 14, kOutline = 6 };
    static const double kPool[2] = {3, 2}, kDepth = 0.3, kLength = 0.7, kWidth = 0.3, kMass = 6, kFreeboard = 0.08;
    static const double kHull[kOutline][2] = {{-0.5, -0.4}, {-0.5, 0.4}, {0.2, 0.5}, {0.5, 0}, {0.2, -0.5}, {-0.5, -0.4}};
    double depth[kX * kY], pose[7], velocity[6];
    cd_water* water;
    film drawn, boat;
    start(&drawn, kRows, kX);
    start(&boat, 2, kOutline);
    must(cd_water_create(kX, kY, kPool[0] / kX, kPool[1] / kY, CD_FLOAT64, NULL, &water));
    must(cd_water_add_volume_rectangle(water, 0, 0, kX, kY, kPool[0] * kPool[1] * kDepth, NULL));
    must(cd_water_set_drag(water, 0.6));
    must(cd_water_set_momentum(water, CD_MOMENTUM_ADVECTED));
    must(cd_water_set_hulls(water, 1, 8, 4));
    must(cd_water_set_hull(water, 0, kMass, kLength, kWidth, NULL, 0));
    must(cd_water_set_hull_drag(water, 0, 3, 10, 0));
    must(cd_water_launch_hull(water, 0, 2.3, 1, 0, 1));
    for (int step = 0; step <= 6 * kPeriod; ++step) {
        const double turn = kTurn * (step + 1) / kPeriod, lead[2] = {1.5 + 0.8 * cos(turn), 1 + 0.45 * sin(turn)};
        const int now = step - 5 * kPeriod;
        must(cd_water_get_hull_floor(water, 0, pose, 7));
        must(cd_water_get_hull_velocity(water, 0, velocity, 6));
        if (now >= 0 && now % kSteps == 0) {
            const size_t frame = (size_t)(now / kSteps);
            must(cd_water_read_f64(water, CD_DEPTH, 0, 0, kX, kY, depth, sizeof depth / sizeof *depth));
            for (size_t j = 0; j < kRows; ++j)
                for (size_t i = 0; i < kX; ++i) {
                    const double slant = 300.0 * j / (kRows - 1);
                    film_set(&drawn, frame, kRows - 1 - j, i, 200 + 1300.0 * i / (kX - 1) + slant,
                             1150 - 600.0 * j / (kRows - 1) - 1200 * (depth[2 * j * kX + i] - kDepth));
                }
            for (size_t i = 0; i < 2 * kOutline; ++i) { /* at the water, and at the gunwale */
                const double* const at = kHull[i % kOutline];
                const double a = at[0] * kLength, b = at[1] * kWidth, tilt = pose[5] * a + pose[6] * b;
                const double x = pose[0] + a * pose[3] - b * pose[4], y = pose[1] + a * pose[4] + b * pose[3];
                const double up = i < kOutline ? 0 : kFreeboard;
                film_set(&boat, frame, i / kOutline, i % kOutline, 200 + 1300 * x / kPool[0] + 300 * y / kPool[1],
                         1150 - 600 * y / kPool[1] - 1200 * (pose[2] + tilt + kMass / (1000 * kLength * kWidth) - kDepth) -
                             1300 / kPool[0] * up);
            }
        }
        /* Its middle is pulled to where it is led, and its bow turned the way that goes. */
        const double rate = kTurn / kSeconds, way[2] = {-0.8 * rate * sin(turn), 0.45 * rate * cos(turn)};
        const double pull[2] = {400 * (lead[0] - pose[0]) + 100 * (way[0] - velocity[0]),
                                400 * (lead[1] - pose[1]) + 100 * (way[1] - velocity[1])};
        const double force[6] = {pull[0] * pose[3] + pull[1] * pose[4], pull[1] * pose[3] - pull[0] * pose[4], 0,
                                 40 * (way[1] * pose[3] - way[0] * pose[4]) - 8 * velocity[3], 0, 0};
        must(cd_water_set_hull_force(water, 0, force, 6));
        must(cd_water_step(water, kDt, 1));
    }
    end(&drawn, out, "pool", "water");
    end(&boat, out, "boat", "boat");
    cd_water_destroy(water);
}

static const char* const kStyle =
    "path,circle{fill:none;stroke-linecap:round;stroke-linejoin:round}"
    ".rope{stroke:#c07830;stroke-width:24}.hair{stroke:#a0522d;stroke-width:12}.sheet{stroke:#c04848;stroke-width:10}.cloth{stroke:#7858a8;stroke-width:10}"
    ".water{stroke:#2878c0;stroke-width:10}.body{fill:#c8c8c8}.boat{stroke:#804020;stroke-width:10;fill:#c08050;fill-opacity:.8}"
    "@media(prefers-color-scheme:dark){.water{stroke:#60a8e8}.body{fill:#585858}"
    ".hair{stroke:#d09060}.sheet{stroke:#e87878}.cloth{stroke:#b098e0}}";

int main(int argc, char** argv) {
    static void (*const kScenes[])(FILE*) = {rope, hair, cloth, drum, pool};
    FILE* const out = argc == 2 ? fopen(argv[1], "w") : NULL;
    if (!out) return fprintf(stderr, "usage: %s FILE\n", argv[0]), 2;
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10000 1500\">\n<style>%s</style>\n", kStyle);
    for (int i = 0; i < 5; ++i) {
        fprintf(out, "<g transform=\"translate(%d 0)\">\n", 2000 * i);
        kScenes[i](out);
        fputs("</g>\n", out);
    }
    fputs("</svg>\n", out);
    return fclose(out) != 0;
}
