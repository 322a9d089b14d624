// What the fields of all objects share: names, switches, and the way numbers go in and out.
#pragma once

#include "api/block.hh"
#include "api/check.hh"

namespace cd {

inline const char* field_name(cd_field field) {
    // One after the other: pointers would be relocated where the library is loaded, rows of one length half empty.
    static constexpr char names[] =
        "CD_POSITION\0CD_VELOCITY\0CD_FORCE\0CD_MASS\0CD_STIFFNESS\0CD_BEND\0CD_PIN\0CD_TARGET\0"
        "CD_STIFFNESS_U\0CD_STIFFNESS_V\0CD_MASK\0CD_DEPTH\0CD_BED\0CD_SURFACE\0CD_VELOCITY_X\0"
        "CD_VELOCITY_Y\0CD_SOURCE\0CD_PRESSURE\0CD_FORCE_X\0CD_FORCE_Y\0CD_WALL_X\0CD_WALL_Y\0"
        "CD_REST_LENGTH\0CD_TENSION\0CD_WIND\0CD_STRENGTH\0CD_STRAIN\0CD_REST_LENGTH_U\0"
        "CD_REST_LENGTH_V\0CD_TENSION_U\0CD_TENSION_V\0CD_STRAIN_U\0CD_STRAIN_V\0CD_BREAKING_STRAIN_U\0"
        "CD_BREAKING_STRAIN_V\0CD_REST_ANGLE";
    const char* name = names;
    for (cd_field before = 0; before < field; ++name) before += *name == 0 ? 1 : 0;
    return name;
}

// What numbers a field takes, in words; what ends alike is there once.
inline const char* field_takes(cd_field field) {
    switch (field) {
    case CD_MASS:
    case CD_REST_LENGTH:
    case CD_REST_LENGTH_U:
    case CD_REST_LENGTH_V: return "numbers from 1e-60 to 1e60";
    case CD_REST_ANGLE: return "numbers from -pi to pi";
    case CD_TENSION: return "finite numbers";
    case CD_STRENGTH:
    case CD_BREAKING_STRAIN_U:
    case CD_BREAKING_STRAIN_V: return "numbers from 1e-60 to 1e60, or infinity";
    case CD_STIFFNESS: return "0 to 1e60, or infinity";
    case CD_BEND:
    case CD_STIFFNESS_U:
    case CD_STIFFNESS_V: return "0 to 1e60";
    case CD_PIN: return "values of cd_node, CD_NODE_MATCHED only at an end of a chain";
    case CD_MASK:
    case CD_WALL_X:
    case CD_WALL_Y: return "0 and 1";
    case CD_VELOCITY: return "only 0 of pinned or absent nodes, else what is finite in the object's precision";
    case CD_VELOCITY_X:
    case CD_VELOCITY_Y: return "only 0 of faces that no water can cross, else what is finite in the object's precision";
    case CD_DEPTH: return "only 0 of absent cells, else from 0 on what is finite in the object's precision";
    case CD_BED:
    case CD_SURFACE: return "what is finite in the object's precision, and leaves depths so";
    default: return "what is finite in the object's precision";
    }
}

// object: its name in the names of its functions
inline cd_status must_be_on(const char* function, const char* object, cd_field field, bool on) {
    if (on) return CD_OK;
    return fail(CD_ERROR_DISABLED, function, "field is %d, %s, which is off: see cd_%s_enable_field", int(field),
                field_name(field), object);
}

// Fields of springs that have a length: an object says by needs_length which those are.
template <class X> cd_status has_length(const char* function, const X& x, cd_field field) {
    if (has_lengths(x) || !needs_length(x, field)) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s: the rest length is 0, set one first", int(field),
                field_name(field));
}

// only: what has it. Where ropes or cloth are left out, `has` is false, and the compiler sees that no CD_OK comes of it:
// what would follow takes no code.
inline cd_status must_have_length(const char* function, const char* only, bool has) {
    if (has) return CD_OK;
    fail(CD_ERROR_UNSUPPORTED, function, "%s: the rest length is 0, set one first", only);
    return CD_ERROR_UNSUPPORTED;
}

// Whether a field of a body is part of its state: a number per component, in the body's precision.
inline bool is_state(cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET || field == CD_WIND;
}
inline const Array<char>& state_of(const Body& b, cd_field field) {
    return field == CD_POSITION   ? b.position
           : field == CD_VELOCITY ? b.velocity
           : field == CD_FORCE    ? b.force
           : field == CD_WIND     ? b.wind
                                  : b.target;
}

inline cd_status has_view(const char* function, cd_field field, bool has) {
    if (has) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s, which has no view: read it", int(field),
                field_name(field));
}
inline cd_status has_view(const char* function, cd_field field) {
    return has_view(function, field, is_state(field) && field != CD_WIND);
}

// What every sample is given: places at[j], what becomes of those outside, and room for positions.
inline cd_status can_sample(const char* function, const double* at, size_t n, cd_outside outside) {
    if (n > 0) CD_CHECK(not_null(function, "at", at));
    CD_CHECK(is_enum(function, "outside", outside, CD_OUTSIDE_NEAREST));
    return n > SIZE_MAX / 4 ? fail(CD_ERROR_RANGE, function, "n is %zu, more than fits in memory", n) : CD_OK;
}
inline cd_status can_sample(const char* function, const double* at, size_t n, cd_outside outside,
                            const double* out_positions) {
    CD_CHECK(can_sample(function, at, n, outside));
    return n > 0 ? not_null(function, "out_positions", out_positions) : CD_OK;
}
inline cd_status is_place(const char* function, const double* at, size_t j, double most, cd_outside outside) {
    const bool any = outside == CD_OUTSIDE_NEAREST && !isnan(at[j]);
    if (any || (at[j] >= 0 && at[j] <= most)) return CD_OK;
    return fail(CD_ERROR_VALUE, function, "at[%zu] is %g, must be in [0, %g]", j, at[j], most);
}
inline double nearest(double place, double most) { return place < 0 ? 0 : place > most ? most : place; }

inline cd_status can_write(const char* function, cd_field field) {
    if (field != CD_STRAIN && (field < CD_TENSION_U || field > CD_STRAIN_V)) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s, which is read only", int(field), field_name(field));
}

// Part: a part of the field part.field of an object, as read and write are given it:
//   check(function, x, count)        whether it is one, and whether a buffer of `count` numbers fits it
//   each(x, f)                       f(index in the buffer, place) for each of its numbers
//   valid(x, place, value)           whether the number may stand there
//   check_all(function, x, values)   what the values must be together
//   get(x, place)                    of what has no block
//   set(x, place, value)
//   written(x)                       what follows from a write
//   block(x)                         where its numbers lie, if they are to be read as they lie there
//   takes_any(x)                     whether any finite number may stand there, and set only stores it

template <class X, class Part>
cd_status write_part(const char* function, X& x, const Part& part, const Values& values, size_t count) {
    CD_CHECK(part.check(function, x, count));
    CD_CHECK(can_write(function, part.field));
    if (count > 0) CD_CHECK(not_null(function, "values", values.address()));
    const Block block = part.takes_any(x) ? part.block(x) : Block{};
    size_t bad = SIZE_MAX;
    if (block.array) bad = find_beyond(x, values, count);
    else
        part.each(x, [&](size_t at, const auto& place) {
            if (bad == SIZE_MAX && !part.valid(x, place, values[at])) bad = at;
        });
    if (bad != SIZE_MAX)
        return fail(CD_ERROR_VALUE, function, "values[%zu] is %g: %s takes %s", bad, values[bad],
                    field_name(part.field), field_takes(part.field));
    CD_CHECK(part.check_all(function, x, values));
    if (block.array) write_block(x, block, values);
    else part.each(x, [&](size_t at, const auto& place) { part.set(x, place, values[at]); });
    part.written(x);
    return CD_OK;
}

template <class X, class Part>
cd_status read_part(const char* function, const X& x, const Part& part, const Values& values, size_t count) {
    CD_CHECK(part.check(function, x, count));
    if (count > 0) CD_CHECK(not_null(function, "out_values", values.address()));
    const Block block = part.block(x);
    if (block.array) read_block(x, block, values);
    else part.each(x, [&](size_t at, const auto& place) { values.put(at, part.get(x, place)); });
    return CD_OK;
}

} // namespace cd
