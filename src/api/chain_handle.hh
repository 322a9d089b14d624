// From the opaque handle to the chain behind it, and what both files of its functions use.
#pragma once

#include "api/shared.hh"
#include "model/chain.hh"

namespace cd {

template <> struct Behind<cd_chain> {
    using Object = Chain;
    static constexpr uint64_t tag = kChainTag;
    static constexpr const char* name = "chain";
};

inline bool is_of_ropes(cd_field field) { return field >= CD_REST_LENGTH && field <= CD_STRAIN; }
inline cd_status is_field(const char* function, const Chain&, cd_field field) {
    if (is_of_ropes(field) || (field >= 0 && field <= CD_TARGET)) return CD_OK;
    return fail(CD_ERROR_ENUM, function, "field is %d, must be 0 to 7 or 22 to 26", int(field));
}
inline bool is_always_on(const Chain&, cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_PIN || field == CD_TENSION || field == CD_STRAIN;
}
inline void switch_own(Features& wanted, cd_field field, bool on) {
    if (field == CD_STIFFNESS) wanted.spring_stiffness = on;
    if (field == CD_BEND) wanted.node_bend = on;
    if (field == CD_REST_LENGTH) wanted.spring_length = on;
    if (field == CD_WIND) wanted.wind = on;
    if (field == CD_STRENGTH) wanted.spring_strength = on, wanted.spring_stiffness |= on;
}
inline bool is_per_spring(cd_field field) { return field == CD_STIFFNESS || (is_of_ropes(field) && field != CD_WIND); }
inline cd_status has_length(const char* function, const Chain& c, cd_field field) {
    if (has_lengths(c) || !is_of_ropes(field)) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field %d, %s: the rest length is 0", int(field), field_name(field));
}
inline cd_status is_rope(const char* function, const Chain& c, const char* lack) {
    return has_lengths(c) ? CD_OK : fail(CD_ERROR_UNSUPPORTED, function, "%s: the rest length is 0", lack);
}
// How many strands have one of their own.
inline size_t strands_of(const Chain& c, cd_field field) {
    return is_state(field) ? c.strands : field == CD_BEND ? 1 : own_strands(c);
}
// The part of the state that a field is, laid out like the positions.
inline const Array<char>& state_of(const Chain& c, cd_field field) {
    return field == CD_WIND ? c.wind : state_of(static_cast<const Body&>(c), field);
}

namespace shared {
inline cd_status enable_field(const char* function, Chain& c, cd_field field) {
    CD_CHECK(is_field(function, c, field));
    CD_CHECK(has_length(function, c, field));
    return enable_field<Chain>(function, c, field);
}
inline cd_status disable_field(const char* function, Chain& c, cd_field field) {
    const bool breaks = field == CD_STIFFNESS && can_break(c);
    return breaks ? fail(CD_ERROR_UNSUPPORTED, function, "field 4, CD_STIFFNESS: springs that may break need it")
                  : disable_field<Chain>(function, c, field);
}
inline cd_status tell_stable_dt(const char* function, const Chain& c, double* out) {
    CD_CHECK(not_null(function, "out_dt", out));
    if (has_lengths(c))
        return fail(CD_ERROR_UNSUPPORTED, function, "no explicit method steps springs that have a length");
    return tell(function, "out_dt", out, stable_dt(c));
}
} // namespace shared

} // namespace cd
