// membrane.h: fields, and acting on nodes.
#include "api/membrane_handle.hh"
#include "model/spread.hh"

using namespace cd;

namespace {

const Array<double>& doubles_of(const Membrane& m, cd_field field) {
    const Direction d = is_along(field, kU) ? kU : kV;
    const bool length = field == CD_REST_LENGTH_U || field == CD_REST_LENGTH_V;
    const bool breaks = field == CD_BREAKING_STRAIN_U || field == CD_BREAKING_STRAIN_V;
    return field == CD_MASS ? m.node_mass
           : length         ? m.spring_length[d]
           : breaks         ? m.breaking_strain[d]
                            : m.spring_stiffness[d];
}
const Array<uint8_t>& bytes_of(const Membrane& m, cd_field field) { return field == CD_PIN ? m.pin : m.mask; }
bool is_bytes(cd_field field) { return field == CD_PIN || field == CD_MASK; }

cd_status is_on(const char* function, const Membrane& m, cd_field field) {
    CD_CHECK(is_field(function, m, field));
    CD_CHECK(has_length(function, m, field));
    return must_be_on(function, "membrane", field,
                      is_always_on(m, field) || (is_state(field)   ? bool(state_of(m, field))
                                                 : is_bytes(field) ? bool(bytes_of(m, field))
                                                                   : bool(doubles_of(m, field))));
}

// A tension or strain of cloth.
double told_of(const Membrane& m, cd_field field, size_t u, size_t v) {
    if constexpr (CD_WITH_CLOTH) {
        const Direction d = is_along(field, kU) ? kU : kV;
        return is_strain(field) ? strain_of(m, d, u, v) : tension_of(m, d, u, v);
    }
    return 0;
}

struct Place {
    size_t u, v, component;
};

// See api/fields.hh.
struct Rectangle {
    cd_field field;
    size_t first_u, first_v, n_u, n_v;

    size_t components(const Membrane& m) const { return is_state(field) ? m.components : 1; }

    cd_status check(const char* function, const Membrane& m, size_t count) const {
        CD_CHECK(is_on(function, m, field));
        const bool along_u = is_along(field, kU), along_v = is_along(field, kV);
        CD_CHECK(is_part(function, "first_u", first_u, "n_u", n_u, along_u ? springs_along(m, kU) : m.columns,
                         along_u ? "springs along u" : "nodes along u"));
        CD_CHECK(is_part(function, "first_v", first_v, "n_v", n_v, along_v ? springs_along(m, kV) : m.rows,
                         along_v ? "springs along v" : "nodes along v"));
        return is_count(function, "count", count, n_u * n_v * components(m));
    }

    template <class F> void each(const Membrane& m, F f) const {
        size_t at = 0;
        for (size_t v = first_v; v < first_v + n_v; ++v)
            for (size_t u = first_u; u < first_u + n_u; ++u)
                for (size_t k = 0; k < components(m); ++k) f(at++, Place{u, v, k});
    }

    bool valid(const Membrane& m, const Place& p, double value) const {
        return valid_number(m, field, p.u, p.v, value);
    }
    cd_status check_all(const char*, const Membrane&, const Values&) const { return CD_OK; }

    Block block(const Membrane& m) const {
        if (!is_state(field)) return {};
        return {&state_of(m, field), place(m, first_u, first_v, 0), {n_v, n_u, m.components}, {m.pitch, 1, m.plane}};
    }
    bool takes_any(const Membrane&) const { return field != CD_VELOCITY; }

    double get(const Membrane& m, const Place& p) const {
        if (is_tension(field) || is_strain(field)) return told_of(m, field, p.u, p.v);
        return is_bytes(field) ? bytes_of(m, field)[node_at(m, p.u, p.v)] : doubles_of(m, field)[node_at(m, p.u, p.v)];
    }
    void set(Membrane& m, const Place& p, double value) const {
        if (is_state(field)) set_number(m, state_of(m, field), place(m, p.u, p.v, p.component), value);
        else if (is_bytes(field)) bytes_of(m, field)[node_at(m, p.u, p.v)] = uint8_t(value);
        else doubles_of(m, field)[node_at(m, p.u, p.v)] = value;
    }

    void written(Membrane& m) const {
        if (!is_state(field)) m.prepared_dt = 0;
        if (n_u > 0 && n_v > 0) wake(m);
        if (field == CD_PIN || field == CD_MASK) stop_nodes(m);
    }
};

cd_status is_node(const char* function, const Membrane& m, size_t u, size_t v) {
    CD_CHECK(is_index(function, "u", u, m.columns));
    return is_index(function, "v", v, m.rows);
}

} // namespace

// ---- fields ---------------------------------------------------------------------------------------------------------

cd_status cd_membrane_write_f32(cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
                                size_t n_v, const float* values, size_t count) {
    CD_OPEN(membrane, m);
    return write_part(__func__, m, Rectangle{field, first_u, first_v, n_u, n_v}, Values(values), count);
}

cd_status cd_membrane_write_f64(cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
                                size_t n_v, const double* values, size_t count) {
    CD_OPEN(membrane, m);
    return write_part(__func__, m, Rectangle{field, first_u, first_v, n_u, n_v}, Values(values), count);
}

cd_status cd_membrane_read_f32(const cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
                               size_t n_v, float* out_values, size_t count) {
    CD_OPEN(membrane, m);
    return read_part(__func__, m, Rectangle{field, first_u, first_v, n_u, n_v}, Values(out_values), count);
}

cd_status cd_membrane_read_f64(const cd_membrane* membrane, cd_field field, size_t first_u, size_t first_v, size_t n_u,
                               size_t n_v, double* out_values, size_t count) {
    CD_OPEN(membrane, m);
    return read_part(__func__, m, Rectangle{field, first_u, first_v, n_u, n_v}, Values(out_values), count);
}

cd_status cd_membrane_view(const cd_membrane* membrane, cd_field field, const void** out_data, size_t* out_u_stride,
                           size_t* out_v_stride, size_t* out_component_stride) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_field(__func__, m, field));
    CD_NOT_NULL(out_data);
    CD_NOT_NULL(out_u_stride);
    CD_NOT_NULL(out_v_stride);
    CD_NOT_NULL(out_component_stride);
    CD_CHECK(has_view(__func__, field));
    CD_CHECK(is_on(__func__, m, field));
    *out_data = state_of(m, field).data;
    *out_u_stride = number_size(m);
    *out_v_stride = m.pitch * number_size(m);
    *out_component_stride = m.plane * number_size(m);
    return CD_OK;
}

// ---- acting on it ---------------------------------------------------------------------------------------------------

cd_status cd_membrane_impulse(cd_membrane* membrane, double u, double v, double radius, const double* impulse,
                              size_t count) {
    CD_OPEN(membrane, m);
    CD_CHECK(in_range(__func__, "u", u, 0, double(m.springs[kU])));
    CD_CHECK(in_range(__func__, "v", v, 0, double(m.springs[kV])));
    CD_CHECK(in_range(__func__, "radius", radius, 0, kMost));
    CD_NOT_NULL(impulse);
    CD_CHECK(is_count(__func__, "count", count, m.components));
    CD_CHECK(are_numbers(__func__, "impulse", impulse, count, kMost));
    CD_CHECK(shared::is_finite(__func__, m));
    const Spread spread(m, u, v, radius);
    // f(component, place, new velocity) for all that is moved
    const auto each = [&](auto f) {
        spread.each([&](size_t i, size_t j, double weight) {
            if (held(m, i, j) || !present(m, i, j)) return;
            const double share = weight / spread.sum / mass_of(m, i, j);
            for (size_t k = 0; k < count; ++k) {
                const size_t at = place(m, i, j, k);
                f(k, at, get_number(m, m.velocity, at) + share * impulse[k]);
            }
        });
    };
    size_t bad = count;
    double most = 0;
    each([&](size_t k, size_t, double velocity) {
        if (bad == count && !(fabs(velocity) <= most_of(m))) bad = k, most = velocity;
    });
    if (bad < count)
        return fail(CD_ERROR_VALUE, __func__, "impulse[%zu] is %g: a node's velocity would be %g", bad, impulse[bad],
                    most);
    each([&](size_t, size_t at, double velocity) { set_number(m, m.velocity, at, velocity); });
    wake(m);
    return CD_OK;
}

cd_status cd_membrane_teleport(cd_membrane* membrane, const double* rotation, const double* offset, size_t count) {
    CD_OPEN(membrane, m);
    CD_CHECK(shared::teleport(__func__, m, m.change, rotation, offset, count, m.plane, [&](auto f) {
        for (size_t i = 0; i < m.nodes; ++i) f(place(m, i % m.columns, i / m.columns, 0));
    }));
    wake(m);
    return CD_OK;
}

cd_status cd_membrane_attach(cd_membrane* membrane, size_t u, size_t v, double stiffness, double damping,
                             const double* target, size_t count) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_node(__func__, m, u, v));
    return shared::attach(__func__, m, node_at(m, u, v), stiffness, damping, target, count, [&](auto f) {
        for (size_t k = 0; k < m.components; ++k) f(k, place(m, u, v, k));
    });
}

cd_status cd_membrane_detach(cd_membrane* membrane, size_t u, size_t v) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_node(__func__, m, u, v));
    return shared::detach(m, node_at(m, u, v));
}

cd_status cd_membrane_get_attachment(const cd_membrane* membrane, size_t u, size_t v, double* out_stiffness,
                                     double* out_damping) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_node(__func__, m, u, v));
    return shared::get_attachment(__func__, m, node_at(m, u, v), out_stiffness, out_damping);
}

cd_status cd_membrane_get_reaction(const cd_membrane* membrane, size_t u, size_t v, double* out_force, size_t count) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_node(__func__, m, u, v));
    CD_NOT_NULL(out_force);
    CD_CHECK(is_count(__func__, "count", count, m.components));
    reaction(m, u, v, out_force);
    return CD_OK;
}

cd_status cd_membrane_sample(const cd_membrane* membrane, const double* at, size_t n, cd_outside outside,
                             double* out_positions, size_t out_count) {
    CD_OPEN(membrane, m);
    CD_CHECK(can_sample(__func__, at, n, outside, out_positions));
    CD_CHECK(is_count(__func__, "out_count", out_count, n * m.components));
    const double most[2] = {double(springs_along(m, kU)), double(springs_along(m, kV))};
    for (size_t j = 0; j < 2 * n; ++j) CD_CHECK(is_place(__func__, at, j, most[j % 2], outside));
    for (size_t j = 0; j < n; ++j) {
        const double u = nearest(at[2 * j], most[0]), v = nearest(at[2 * j + 1], most[1]);
        for (size_t k = 0; k < m.components; ++k) out_positions[j * m.components + k] = position_at(m, u, v, k);
    }
    return CD_OK;
}
