// From the opaque handle to the membrane behind it, and what the files of its functions use.
#pragma once

#include "api/shared.hh"
#include "model/membrane.hh"

namespace cd {

template <> struct Behind<cd_membrane> {
    using Object = Membrane;
    static constexpr uint64_t tag = kMembraneTag;
    static constexpr const char* name = "membrane";
};

inline bool is_of_cloth(cd_field field) {
    return field == CD_WIND || (field >= CD_REST_LENGTH_U && field <= CD_BREAKING_STRAIN_V);
}
inline bool needs_length(const Membrane&, cd_field field) { return is_of_cloth(field); }
// What cloth tells of its springs, and keeps nowhere.
inline bool is_tension(cd_field field) { return field == CD_TENSION_U || field == CD_TENSION_V; }
inline bool is_strain(cd_field field) { return field == CD_STRAIN_U || field == CD_STRAIN_V; }
// Whether a field has numbers of the springs along a direction.
inline bool is_along(cd_field field, Direction d) {
    if (field == CD_STIFFNESS_U || field == CD_STIFFNESS_V) return field == (d == kU ? CD_STIFFNESS_U : CD_STIFFNESS_V);
    return field >= CD_REST_LENGTH_U && (field - CD_REST_LENGTH_U) % 2 == int(d); // they come in pairs
}
inline cd_status is_field(const char* function, const Membrane&, cd_field field) {
    if (!is_of_cloth(field) && (field < 0 || field > CD_MASK))
        return fail(CD_ERROR_ENUM, function, "field is %d, which no membrane has, must be 0 to 10, 24 or 27 to 34",
                    int(field));
    if (field != CD_STIFFNESS && field != CD_BEND) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s, which no membrane has%s", int(field),
                field_name(field), field == CD_STIFFNESS ? ": it has CD_STIFFNESS_U and CD_STIFFNESS_V" : "");
}
inline bool is_always_on(const Membrane&, cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || is_tension(field) || is_strain(field);
}
inline void switch_own(MembraneFeatures& wanted, cd_field field, bool on) {
    if (field == CD_STIFFNESS_U) wanted.spring_stiffness[kU] = on;
    if (field == CD_STIFFNESS_V) wanted.spring_stiffness[kV] = on;
    if (field == CD_PIN) wanted.pin = on;
    if (field == CD_MASK) wanted.mask = on;
    if (field == CD_REST_LENGTH_U) wanted.spring_length[kU] = on;
    if (field == CD_REST_LENGTH_V) wanted.spring_length[kV] = on;
    if (field == CD_BREAKING_STRAIN_U) wanted.breaking_strain[kU] = on, wanted.spring_stiffness[kU] |= on;
    if (field == CD_BREAKING_STRAIN_V) wanted.breaking_strain[kV] = on, wanted.spring_stiffness[kV] |= on;
    if (field == CD_WIND) wanted.wind = on;
}
inline cd_status is_cloth(const char* function, const Membrane& m, const char* only) {
    return must_have_length(function, only, has_lengths(m));
}
inline cd_status feels_air(const char* function, const Membrane& m) {
    return is_cloth(function, m, "only cloth feels air");
}
inline constexpr bool can_touch(const Membrane&) { return CD_WITH_CLOTH && CD_WITH_CONTACT; }
inline cd_status touches(const char* function, const Membrane& m) {
    return is_cloth(function, m, "only cloth touches things");
}
inline cd_status has_collider(const char* function, const Membrane& m, size_t index) {
    return is_index(function, index, collider_count(m), "colliders", "cd_membrane_set_colliders");
}
inline AirSettings& air_of(Membrane& m) { return m.cloth; }
inline const AirSettings& air_of(const Membrane& m) { return m.cloth; }
namespace shared {
inline cd_status disable_field(const char* function, Membrane& m, cd_field field) {
    const bool tears = (field == CD_STIFFNESS_U && can_tear(m, kU)) || (field == CD_STIFFNESS_V && can_tear(m, kV));
    if (!tears) return disable_field<Membrane>(function, m, field);
    return fail(CD_ERROR_UNSUPPORTED, function, "field is %d, %s, which springs that may tear need", int(field),
                field_name(field));
}
// What the extra mass of factored lines depends on beside masses and springs, whose changes are work.
inline cd_status set_method(const char* function, Membrane& m, cd_method method) {
    const bool differs = method != m.method;
    CD_CHECK(set_method<Membrane>(function, m, method));
    if (differs) make_unlike(m);
    return CD_OK;
}
inline cd_status set_parameter(const char* function, Membrane& m, const char* name, double value, double& parameter,
                               double least = 0, double most = kMost) {
    const double before = parameter;
    CD_CHECK(set_parameter(function, static_cast<Object&>(m), name, value, parameter, least, most));
    if (parameter != before) make_unlike(m);
    return CD_OK;
}
} // namespace shared

} // namespace cd
