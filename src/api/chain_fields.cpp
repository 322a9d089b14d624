// chain.h: fields, and acting on nodes and springs.
#include "api/chain_handle.hh"

using namespace cd;

namespace {

constexpr cd_field kLastField = CD_TARGET;

bool is_per_strand(cd_field field) {
    return field == CD_POSITION || field == CD_VELOCITY || field == CD_FORCE || field == CD_TARGET;
}

const char* field_name(cd_field field) {
    static const char* const names[] = {"CD_POSITION",  "CD_VELOCITY", "CD_FORCE", "CD_MASS",
                                        "CD_STIFFNESS", "CD_BEND",     "CD_PIN",   "CD_TARGET"};
    return names[field];
}

// The numbers of a per-strand field, or of one that the strands share.
const Array<char>& lines_of(const Chain& c, cd_field field) {
    return field == CD_POSITION   ? c.position
           : field == CD_VELOCITY ? c.velocity
           : field == CD_FORCE    ? c.force
                                  : c.target;
}
const Array<double>& shared_of(const Chain& c, cd_field field) {
    return field == CD_MASS ? c.node_mass : field == CD_STIFFNESS ? c.spring_stiffness : c.node_bend;
}

cd_status is_on(const char* function, const Chain& c, cd_field field) {
    CD_CHECK(is_enum(function, "field", field, kLastField));
    const bool empty = field == CD_STIFFNESS && springs_in_all(c) == 0; // of a single node: neither on nor off
    if (field == CD_PIN || empty || (is_per_strand(field) ? bool(lines_of(c, field)) : bool(shared_of(c, field))))
        return CD_OK;
    return fail(CD_ERROR_DISABLED, function, "field %d, %s, is off: see cd_chain_enable_field", int(field),
                field_name(field));
}

// A part of a field, as read and write are given it.
struct Part {
    cd_field field;
    size_t first_strand, strands, first, n;

    size_t components(const Chain& c) const { return is_per_strand(field) ? c.components : 1; }

    cd_status check(const char* function, const Chain& c, size_t count) const {
        CD_CHECK(is_on(function, c, field));
        CD_CHECK(is_part(function, "strands from", first_strand, strands, is_per_strand(field) ? c.strands : 1));
        const size_t all = field == CD_STIFFNESS ? springs_in_all(c) : c.nodes;
        CD_CHECK(is_part(function, field == CD_STIFFNESS ? "springs from" : "nodes from", first, n, all));
        return is_count(function, "count", count, strands * n * components(c));
    }

    // f(index in the buffer, strand, node or spring, component)
    template <class F> void each(const Chain& c, F f) const {
        size_t at = 0;
        for (size_t s = first_strand; s < first_strand + strands; ++s)
            for (size_t i = first; i < first + n; ++i)
                for (size_t k = 0; k < components(c); ++k) f(at++, s, i, k);
    }
    bool holds(size_t i) const { return strands > 0 && i >= first && i - first < n; }
};

template <class S> cd_status check_values(const char* function, const Chain& c, const Part& part, const S* values) {
    size_t bad = SIZE_MAX;
    part.each(c, [&](size_t at, size_t, size_t i, size_t) {
        if (bad == SIZE_MAX && !valid_number(c, part.field, i, double(values[at]))) bad = at;
    });
    if (bad != SIZE_MAX)
        return fail(CD_ERROR_VALUE, function, "values[%zu] is %g, not valid in %s", bad, double(values[bad]),
                    field_name(part.field));
    if (part.field != CD_STIFFNESS && part.field != CD_PIN) return CD_OK;
    const auto new_value = [&](cd_field field, size_t i, double old) {
        return part.field == field && part.holds(i) ? double(values[i - part.first]) : old;
    };
    const bool sound = groups_are_sound(
        c, [&](size_t i) { return isinf(new_value(CD_STIFFNESS, i, stiffness_of(c, i))); },
        [&](size_t i) {
            const double pin = new_value(CD_PIN, i, c.pin[i]);
            return pin == CD_NODE_PINNED || pin == CD_NODE_DRIVEN;
        });
    if (!sound)
        return fail(CD_ERROR_UNSUPPORTED, function, "a group of welded nodes would hold two pinned or driven ones");
    return CD_OK;
}

template <class S> cd_status write(const char* function, Chain& c, const Part& part, const S* values, size_t count) {
    CD_CHECK(part.check(function, c, count));
    if (count > 0) CD_CHECK(not_null(function, "values", values));
    CD_CHECK(check_values(function, c, part, values));
    part.each(c, [&](size_t at, size_t strand, size_t i, size_t k) {
        const double value = double(values[at]);
        if (part.field == CD_PIN) c.pin[i] = uint8_t(value);
        else if (is_per_strand(part.field)) set_number(c, lines_of(c, part.field), strand, i, k, value);
        else shared_of(c, part.field)[i] = value;
    });
    if (!is_per_strand(part.field)) c.prepared_dt = 0;
    if (part.field == CD_PIN) stop_pinned(c);
    if (part.field != CD_POSITION && part.field != CD_FORCE && part.field != CD_TARGET) merge_velocities(c, 0, c.lines);
    return CD_OK;
}

template <class S> cd_status read(const char* function, const Chain& c, const Part& part, S* values, size_t count) {
    CD_CHECK(part.check(function, c, count));
    if (count > 0) CD_CHECK(not_null(function, "out_values", values));
    part.each(c, [&](size_t at, size_t strand, size_t i, size_t k) {
        if (part.field == CD_PIN) values[at] = S(c.pin[i]);
        else if (is_per_strand(part.field)) values[at] = S(get_number(c, lines_of(c, part.field), strand, i, k));
        else values[at] = S(shared_of(c, part.field)[i]);
    });
    return CD_OK;
}

// Switches a field on or off.
cd_status switch_field(const char* function, Chain& c, cd_field field, bool on) {
    Features wanted = features(c);
    if (field == CD_FORCE) wanted.force = on;
    if (field == CD_MASS) wanted.node_mass = on;
    if (field == CD_STIFFNESS) wanted.spring_stiffness = on;
    if (field == CD_BEND) wanted.node_bend = on;
    if (field == CD_TARGET) wanted.target = on;
    return set_features(c, wanted) ? CD_OK : fail(CD_ERROR_MEMORY, function, "no memory for %s", field_name(field));
}

} // namespace

// ---- fields ---------------------------------------------------------------------------------------------------------

cd_status cd_chain_enable_field(cd_chain* chain, cd_field field) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_enum(__func__, "field", field, kLastField));
    return switch_field(__func__, c, field, true);
}

cd_status cd_chain_disable_field(cd_chain* chain, cd_field field) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_enum(__func__, "field", field, kLastField));
    if (field == CD_POSITION || field == CD_VELOCITY || field == CD_PIN)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "field %d, %s, is always on", int(field), field_name(field));
    return switch_field(__func__, c, field, false);
}

cd_status cd_chain_write_f32(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                             size_t n, const float* values, size_t count) {
    CD_THE_CHAIN(Chain);
    return write(__func__, c, {field, first_strand, strands, first, n}, values, count);
}

cd_status cd_chain_write_f64(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                             size_t n, const double* values, size_t count) {
    CD_THE_CHAIN(Chain);
    return write(__func__, c, {field, first_strand, strands, first, n}, values, count);
}

cd_status cd_chain_read_f32(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                            size_t n, float* out_values, size_t count) {
    CD_THE_CHAIN(const Chain);
    return read(__func__, c, {field, first_strand, strands, first, n}, out_values, count);
}

cd_status cd_chain_read_f64(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                            size_t n, double* out_values, size_t count) {
    CD_THE_CHAIN(const Chain);
    return read(__func__, c, {field, first_strand, strands, first, n}, out_values, count);
}

cd_status cd_chain_view(const cd_chain* chain, cd_field field, const void** out_data, size_t* out_strand_stride,
                        size_t* out_node_stride, size_t* out_component_stride) {
    CD_THE_CHAIN(const Chain);
    CD_CHECK(is_enum(__func__, "field", field, kLastField));
    CD_NOT_NULL(out_data);
    CD_NOT_NULL(out_strand_stride);
    CD_NOT_NULL(out_node_stride);
    CD_NOT_NULL(out_component_stride);
    if (!is_per_strand(field))
        return fail(CD_ERROR_UNSUPPORTED, __func__, "field %d, %s, has no view: read it", int(field),
                    field_name(field));
    CD_CHECK(is_on(__func__, c, field));
    *out_data = lines_of(c, field).data;
    *out_component_stride = number_size(c);
    *out_strand_stride = c.components * number_size(c);
    *out_node_stride = c.pitch * number_size(c);
    return CD_OK;
}

// ---- acting on it ---------------------------------------------------------------------------------------------------

cd_status cd_chain_impulse(cd_chain* chain, size_t strand, size_t node, const double* impulse, size_t count) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_index(__func__, "strand", strand, c.strands));
    CD_CHECK(is_index(__func__, "node", node, c.nodes));
    CD_NOT_NULL(impulse);
    CD_CHECK(is_count(__func__, "count", count, c.components));
    CD_CHECK(are_numbers(__func__, "impulse", impulse, count, kMost));
    const Group group = group_of(c, node);
    if (held_in(c, group) > 0) return CD_OK;
    double mass = 0;
    for (size_t k = 0; k < group.count; ++k) mass += mass_of(c, (group.first + k) % c.nodes);
    for (size_t j = 0; j < count; ++j) {
        const double v = get_number(c, c.velocity, strand, node, j) + impulse[j] / mass;
        if (!(fabs(v) <= most_of(c)))
            return fail(CD_ERROR_VALUE, __func__, "impulse[%zu] is %g: the node's velocity would be %g", j, impulse[j],
                        v);
    }
    for (size_t k = 0; k < group.count; ++k)
        for (size_t j = 0; j < count; ++j) {
            const size_t i = (group.first + k) % c.nodes;
            set_number(c, c.velocity, strand, i, j, get_number(c, c.velocity, strand, i, j) + impulse[j] / mass);
        }
    return CD_OK;
}

cd_status cd_chain_attach(cd_chain* chain, size_t node, double stiffness, double damping, const double* target,
                          size_t count) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_index(__func__, "node", node, c.nodes));
    CD_CHECK(in_range(__func__, "stiffness", stiffness, 0, kMost));
    CD_CHECK(in_range(__func__, "damping", damping, 0, kMost));
    if (target) CD_CHECK(is_count(__func__, "count", count, c.components));
    if (target) CD_CHECK(are_numbers(__func__, "target", target, count, most_of(c)));
    CD_CHECK(switch_field(__func__, c, CD_TARGET, true));
    c.attach_stiffness[node] = stiffness;
    c.attach_damping[node] = damping;
    for (size_t strand = 0; strand < c.strands; ++strand)
        for (size_t k = 0; k < c.components; ++k)
            set_number(c, c.target, strand, node, k, target ? target[k] : get_number(c, c.position, strand, node, k));
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_detach(cd_chain* chain, size_t node) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_index(__func__, "node", node, c.nodes));
    if (!c.target) return CD_OK;
    c.attach_stiffness[node] = c.attach_damping[node] = 0;
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_get_attachment(const cd_chain* chain, size_t node, double* out_stiffness, double* out_damping) {
    CD_THE_CHAIN(const Chain);
    CD_CHECK(is_index(__func__, "node", node, c.nodes));
    CD_NOT_NULL(out_stiffness);
    CD_NOT_NULL(out_damping);
    *out_stiffness = c.target ? c.attach_stiffness[node] : 0;
    *out_damping = c.target ? c.attach_damping[node] : 0;
    return CD_OK;
}

cd_status cd_chain_cut(cd_chain* chain, size_t spring) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_index(__func__, "spring", spring, springs_in_all(c)));
    CD_CHECK(switch_field(__func__, c, CD_STIFFNESS, true));
    c.spring_stiffness[spring] = 0;
    c.prepared_dt = 0;
    return CD_OK;
}

cd_status cd_chain_weld(cd_chain* chain, size_t spring) {
    CD_THE_CHAIN(Chain);
    CD_CHECK(is_index(__func__, "spring", spring, springs_in_all(c)));
    if (!groups_are_sound(
            c, [&](size_t i) { return i == spring || welded(c, i); }, [&](size_t i) { return held(c, i); }))
        return fail(CD_ERROR_UNSUPPORTED, __func__, "spring %zu would join two pinned or driven nodes", spring);
    CD_CHECK(switch_field(__func__, c, CD_STIFFNESS, true));
    c.spring_stiffness[spring] = double(INFINITY);
    c.prepared_dt = 0;
    merge_velocities(c, 0, c.lines);
    return CD_OK;
}

cd_status cd_chain_sample(const cd_chain* chain, size_t strand, const double* at, size_t n, double* out_positions,
                          size_t out_count) {
    CD_THE_CHAIN(const Chain);
    CD_CHECK(is_index(__func__, "strand", strand, c.strands));
    if (n > 0) CD_NOT_NULL(at);
    if (n > 0) CD_NOT_NULL(out_positions);
    if (n > SIZE_MAX / 4) return fail(CD_ERROR_RANGE, __func__, "n is %zu, more than fits in memory", n);
    CD_CHECK(is_count(__func__, "out_count", out_count, n * c.components));
    for (size_t j = 0; j < n; ++j)
        if (!(at[j] >= 0 && at[j] <= double(springs_in_all(c))))
            return fail(CD_ERROR_VALUE, __func__, "at[%zu] is %g, must be in [0, %zu]", j, at[j], springs_in_all(c));
    for (size_t j = 0; j < n; ++j) {
        const size_t whole = size_t(at[j]), last = springs_in_all(c) > 0 ? springs_in_all(c) - 1 : 0;
        const size_t i = whole < last ? whole : last, next = i + 1 < c.nodes ? i + 1 : c.ring ? 0 : i;
        const double t = at[j] - double(i);
        for (size_t k = 0; k < c.components; ++k) {
            const double a = get_number(c, c.position, strand, i, k), b = get_number(c, c.position, strand, next, k);
            out_positions[j * c.components + k] = (1 - t) * a + t * b;
        }
    }
    return CD_OK;
}
