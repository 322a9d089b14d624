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

inline bool is_of_ropes(cd_field field) {
    return (field >= CD_REST_LENGTH && field <= CD_STRAIN) || field == CD_REST_ANGLE;
}
inline bool needs_length(const Chain&, cd_field field) { return is_of_ropes(field); }
inline cd_status is_field(const char* function, const Chain&, cd_field field) {
    if (is_of_ropes(field) || (field >= 0 && field <= CD_TARGET)) return CD_OK;
    return fail(CD_ERROR_ENUM, function, "field is %d, which no chain has, must be 0 to 7, 22 to 26 or 35", int(field));
}
inline bool is_always_on(const Chain&, cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_PIN || field == CD_TENSION || field == CD_STRAIN;
}
inline void switch_own(Features& wanted, cd_field field, bool on) {
    if (field == CD_STIFFNESS) wanted.spring_stiffness = on;
    if (field == CD_BEND) wanted.node_bend = on;
    if (field == CD_REST_LENGTH) wanted.spring_length = on;
    if (field == CD_WIND) wanted.wind = on;
    if (field == CD_REST_ANGLE) wanted.node_angle = on;
    if (field == CD_STRENGTH) wanted.spring_strength = on, wanted.spring_stiffness |= on;
}
inline bool is_per_spring(cd_field field) {
    return field == CD_STIFFNESS || (is_of_ropes(field) && field != CD_WIND && field != CD_REST_ANGLE);
}
inline cd_status is_rope(const char* function, const Chain& c, const char* only) {
    return must_have_length(function, only, has_lengths(c));
}
inline cd_status feels_air(const char* function, const Chain& c) { return is_rope(function, c, "only ropes feel air"); }
inline constexpr bool can_touch(const Chain&) { return CD_WITH_ROPE && CD_WITH_CONTACT; }
inline cd_status touches(const char* function, const Chain& c) {
    return is_rope(function, c, "only ropes touch things");
}
inline cd_status has_collider(const char* function, const Chain& c, size_t index) {
    return is_index(function, index, collider_count(c), "colliders", "cd_chain_set_colliders");
}
inline AirSettings& air_of(Chain& c) { return c.air; }
inline const AirSettings& air_of(const Chain& c) { return c.air; }
// How many strands have one of their own.
inline size_t strands_of(const Chain& c, cd_field field) {
    return is_state(field) ? c.strands : own_strands(c);
}
// A turn in space needs more than an angle.
inline cd_status can_curl(const char* function, const Chain& c) {
    CD_CHECK(is_rope(function, c, "only ropes have rest angles"));
    if (can_curl(c)) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "rest angles need 2 components: this chain has %zu", c.components);
}
namespace shared {
inline cd_status enable_field(const char* function, Chain& c, cd_field field) {
    CD_CHECK(has_length(function, c, field));
    if (field == CD_REST_ANGLE) CD_CHECK(can_curl(function, c));
    return enable_field<Chain>(function, c, field);
}
inline cd_status disable_field(const char* function, Chain& c, cd_field field) {
    const bool breaks = field == CD_STIFFNESS && can_break(c);
    return breaks ? fail(CD_ERROR_UNSUPPORTED, function, "field is 4, CD_STIFFNESS, which springs that may break need")
                  : disable_field<Chain>(function, c, field);
}
} // namespace shared

} // namespace cd
