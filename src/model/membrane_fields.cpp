// The membrane's fields, one number at a time.
#include "model/membrane.hh"

namespace cd {

bool valid_number(const Membrane& m, cd_field field, size_t u, size_t v, double value) {
    switch (field) {
    case CD_MASS:
    case CD_REST_LENGTH_U:
    case CD_REST_LENGTH_V: return valid_mass(value);
    case CD_STIFFNESS_U:
    case CD_STIFFNESS_V: return valid_parameter(value);
    case CD_BREAKING_STRAIN_U:
    case CD_BREAKING_STRAIN_V: return valid_mass(value) || (isinf(value) && value > 0);
    case CD_PIN: return is_kind(value);
    case CD_MASK: return value == 0 || value == 1;
    case CD_VELOCITY:
        if (value != 0 && (kind_of(m, u, v) == CD_NODE_PINNED || !present(m, u, v))) return false;
        [[fallthrough]];
    default: return fabs(value) <= most_of(m);
    }
}

namespace {

// A place between two nodes of a line.
struct Between {
    size_t from, to;
    double share; // of `to`

    Between(const Membrane& m, Direction d, double at) {
        const size_t springs = springs_along(m, d), whole = size_t(at);
        from = springs == 0 ? 0 : whole < springs ? whole : springs - 1;
        to = after(m, d, from);
        share = at - double(from);
    }
    double mix(double a, double b) const { return (1 - share) * a + share * b; }
};

} // namespace

double position_at(const Membrane& m, double u, double v, size_t component) {
    const Between along_u(m, kU, u), along_v(m, kV, v);
    const auto x = [&](size_t i, size_t j) { return get_number(m, m.position, place(m, i, j, component)); };
    return along_v.mix(along_u.mix(x(along_u.from, along_v.from), x(along_u.to, along_v.from)),
                       along_u.mix(x(along_u.from, along_v.to), x(along_u.to, along_v.to)));
}

} // namespace cd
