#include "arguments.hpp"

#include <math.h>

#include "random.hpp"
#include "run.hpp"

namespace fuzz {

double pick_number(double from, double to) {
    if (!run.sane && chance(0.15)) return wild_number();
    if (chance(run.bad * 0.5)) {
        static const double bad[] = {NAN, -1, INFINITY, -INFINITY, -1e-300};
        return bad[below(5)];
    }
    return decades(from, to);
}

double pick_between(double from, double to) { return chance(run.bad) ? wild_number() : uniform(from, to); }
int32_t pick_enum(int32_t last) { return chance(run.bad) ? wild_enum(last) : int32_t(below(size_t(last) + 1)); }
size_t pick_index(size_t count) { return chance(run.bad) ? wild_size(count) : below(count); }
size_t pick_count(size_t count) { return chance(run.bad) ? wild_size(count) : count; }
bool pick_null() { return chance(0.02); }
cd_field pick_field() { return pick_enum(kLastField); }

static void pick_range(size_t whole, size_t& first, size_t& count) {
    first = below(whole);
    count = whole == 0 ? 0 : 1 + below(whole - first);
}

Part pick_part(const Extent& whole) {
    Part p = {0, whole.outer, 0, whole.inner, 0};
    if (chance(0.5)) pick_range(whole.outer, p.outer, p.outer_count), pick_range(whole.inner, p.inner, p.inner_count);
    if (chance(0.02)) p.outer_count = 0;
    if (chance(0.02)) p.inner_count = 0;
    if (chance(run.bad)) {
        size_t* const all[] = {&p.outer, &p.outer_count, &p.inner, &p.inner_count};
        const size_t one = below(4);
        *all[one] = wild_size(one < 2 ? whole.outer : whole.inner);
    }
    p.count = p.outer_count * p.inner_count * whole.components;
    if (chance(run.bad * 0.5)) p.count = wild_size(p.count);
    return p;
}

static double pick_value(cd_field field, double size, bool at_rest) {
    switch (field) {
    case CD_MASS: return decades(-2, 2);
    case CD_STIFFNESS: return chance(0.1) ? 0 : chance(0.08) ? INFINITY : decades(-2, 3);
    case CD_STIFFNESS_U:
    case CD_STIFFNESS_V: return chance(0.1) ? 0 : decades(-2, 3);
    case CD_BEND: return chance(0.1) ? 0 : decades(-3, 2);
    case CD_PIN: return chance(0.9) ? 0 : chance(0.25) ? double(CD_NODE_POSED) : double(below(chance(0.1) ? 6 : 3));
    case CD_MASK: return chance(0.85) ? 1 : 0;
    case CD_WALL_X:
    case CD_WALL_Y: return chance(0.9) ? 0 : 1;
    case CD_DEPTH: return at_rest ? 1 : chance(0.2) ? 0 : uniform(0, 3);
    case CD_SURFACE: return uniform(-1, 3);
    case CD_BED: return at_rest ? 0 : uniform(-2, 2);
    case CD_SOURCE: return uniform(-0.1, 0.1);
    case CD_PRESSURE: return uniform(-1000, 1000);
    case CD_REST_LENGTH:
    case CD_REST_LENGTH_U:
    case CD_REST_LENGTH_V: return decades(-3, 0);
    case CD_BREAKING_STRAIN_U:
    case CD_BREAKING_STRAIN_V: return chance(0.3) ? double(INFINITY) : decades(-2, 2);
    case CD_REST_ANGLE: return chance(0.1) ? (chance(0.5) ? 1 : -1) * 3.141592653589793 : uniform(-3.2, 3.15);
    case CD_STRENGTH: return chance(0.3) ? double(INFINITY) : decades(-1, 5);
    case CD_TENSION: return at_rest ? 0 : chance(0.9) ? decades(-2, 3) : uniform(-size, size);
    case CD_VELOCITY:
    case CD_VELOCITY_X:
    case CD_VELOCITY_Y: return at_rest ? 0 : uniform(-size, size);
    default: return uniform(-size, size);
    }
}

Doubles pick_values(cd_field field, size_t count, bool& moderate) {
    Doubles values(count);
    const double size = decades(-2, 1);
    const bool at_rest = chance(0.25);
    for (double& value : values) {
        value = pick_value(field, size, at_rest);
        if (!run.sane && chance(0.01)) value = wild_number(), moderate = false;
    }
    if (count > 0 && chance(run.bad)) values[below(count)] = wild_number(), moderate = false;
    return values;
}

} // namespace fuzz
