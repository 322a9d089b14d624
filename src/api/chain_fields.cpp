// chain.h: fields, and acting on nodes and springs.
#include "api/chain_handle.hh"

using namespace cd;

namespace {

const Array<double>& shared_of(const Chain& c, cd_field field) {
    return field == CD_MASS          ? c.node_mass
           : field == CD_STIFFNESS   ? c.spring_stiffness
           : field == CD_REST_LENGTH ? c.spring_length
           : field == CD_TENSION     ? c.tension
           : field == CD_STRENGTH    ? c.spring_strength
           : field == CD_REST_ANGLE  ? c.node_angle
                                     : c.node_bend;
}

cd_status is_on(const char* function, const Chain& c, cd_field field) {
    CD_CHECK(is_field(function, c, field));
    CD_CHECK(has_length(function, c, field));
    const bool empty = field == CD_STIFFNESS && springs_in_all(c) == 0; // of a single node: neither on nor off
    const bool on = is_state(field) ? bool(state_of(c, field)) : bool(shared_of(c, field));
    return must_be_on(function, "chain", field, on || empty || field == CD_PIN || field == CD_STRAIN);
}

struct Place {
    size_t strand, item, component; // item: a node or a spring
};

// See api/fields.hh.
struct Part {
    cd_field field;
    size_t first_strand, strands, first, n;

    size_t components(const Chain& c) const { return is_state(field) ? c.components : 1; }

    cd_status check(const char* function, const Chain& c, size_t count) const {
        CD_CHECK(is_on(function, c, field));
        CD_CHECK(
            is_part(function, "first_strand", first_strand, "strands", strands, strands_of(c, field), "its strands"));
        const size_t all = is_per_spring(field) ? springs_in_all(c) : c.nodes;
        CD_CHECK(is_part(function, "first", first, "n", n, all, is_per_spring(field) ? "springs" : "nodes"));
        return is_count(function, "count", count, strands * n * components(c));
    }

    template <class F> void each(const Chain& c, F f) const {
        size_t at = 0;
        for (size_t s = first_strand; s < first_strand + strands; ++s)
            for (size_t i = first; i < first + n; ++i)
                for (size_t k = 0; k < components(c); ++k) f(at++, Place{s, i, k});
    }

    bool valid(const Chain& c, const Place& p, double value) const {
        return valid_number(c, field, p.strand, p.item, value);
    }

    cd_status check_all(const char* function, const Chain& c, const Values& values) const {
        if ((field != CD_STIFFNESS && field != CD_PIN) || has_lengths(c)) return CD_OK;
        const auto new_value = [&](cd_field asked, size_t i, double old) {
            const bool holds = field == asked && strands > 0 && i >= first && i - first < n;
            return holds ? values[i - first] : old;
        };
        const bool sound = groups_are_sound(
            c.nodes, c.ring != 0, [&](size_t i) { return isinf(new_value(CD_STIFFNESS, i, stiffness_of(c, i))); },
            [&](size_t i) { return holds(new_value(CD_PIN, i, c.pin[i])); });
        if (sound) return CD_OK;
        return fail(CD_ERROR_UNSUPPORTED, function, "two held nodes would be welded together");
    }

    Block block(const Chain& c) const {
        if (!is_state(field)) return {};
        return {&state_of(c, field),
                place(c, first_strand, first, 0),
                {strands, n, c.components},
                {c.components, c.pitch, 1}};
    }
    bool takes_any(const Chain&) const { return field != CD_VELOCITY; }

    double get(const Chain& c, const Place& p) const {
        if (field == CD_PIN) return c.pin[own_place(c, p.strand, p.item)];
        if (CD_WITH_ROPE && field == CD_STRAIN) return strain_of(c, p.strand, p.item);
        return shared_of(c, field)[own_place(c, p.strand, p.item)];
    }
    void set(Chain& c, const Place& p, double value) const {
        if (field == CD_PIN) c.pin[own_place(c, p.strand, p.item)] = uint8_t(value);
        else if (is_state(field)) set_number(c, state_of(c, field), place(c, p.strand, p.item, p.component), value);
        else shared_of(c, field)[own_place(c, p.strand, p.item)] = value;
    }

    void written(Chain& c) const {
        if (!is_state(field)) c.prepared_dt = 0;
        if (n > 0) wake(c, first_strand, strands);
        if (field == CD_PIN) stop_pinned(c);
        if (field == CD_VELOCITY || !is_state(field)) merge_velocities(c, 0, c.lines);
    }
};

} // namespace

// ---- fields ---------------------------------------------------------------------------------------------------------

cd_status cd_chain_write_f32(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                             size_t n, const float* values, size_t count) {
    CD_OPEN(chain, c);
    return write_part(__func__, c, Part{field, first_strand, strands, first, n}, Values(values), count);
}

cd_status cd_chain_write_f64(cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                             size_t n, const double* values, size_t count) {
    CD_OPEN(chain, c);
    return write_part(__func__, c, Part{field, first_strand, strands, first, n}, Values(values), count);
}

cd_status cd_chain_read_f32(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                            size_t n, float* out_values, size_t count) {
    CD_OPEN(chain, c);
    return read_part(__func__, c, Part{field, first_strand, strands, first, n}, Values(out_values), count);
}

cd_status cd_chain_read_f64(const cd_chain* chain, cd_field field, size_t first_strand, size_t strands, size_t first,
                            size_t n, double* out_values, size_t count) {
    CD_OPEN(chain, c);
    return read_part(__func__, c, Part{field, first_strand, strands, first, n}, Values(out_values), count);
}

cd_status cd_chain_view(const cd_chain* chain, cd_field field, const void** out_data, size_t* out_strand_stride,
                        size_t* out_node_stride, size_t* out_component_stride) {
    CD_OPEN(chain, c);
    CD_CHECK(is_field(__func__, c, field));
    CD_NOT_NULL(out_data);
    CD_NOT_NULL(out_strand_stride);
    CD_NOT_NULL(out_node_stride);
    CD_NOT_NULL(out_component_stride);
    CD_CHECK(has_view(__func__, field));
    CD_CHECK(is_on(__func__, c, field));
    *out_data = state_of(c, field).data;
    *out_component_stride = number_size(c);
    *out_strand_stride = c.components * number_size(c);
    *out_node_stride = c.pitch * number_size(c);
    return CD_OK;
}

// ---- acting on it ---------------------------------------------------------------------------------------------------

cd_status cd_chain_impulse(cd_chain* chain, size_t strand, size_t node, const double* impulse, size_t count) {
    CD_OPEN(chain, c);
    CD_CHECK(is_index(__func__, "strand", strand, c.strands));
    CD_CHECK(is_index(__func__, "node", node, c.nodes));
    CD_NOT_NULL(impulse);
    CD_CHECK(is_count(__func__, "count", count, c.components));
    CD_CHECK(are_numbers(__func__, "impulse", impulse, count, kMost));
    CD_CHECK(shared::is_finite(__func__, c));
    const Group group = group_of(c, node);
    if (held_in(c, strand, group) > 0) return CD_OK;
    double mass = 0;
    for (size_t k = 0; k < group.count; ++k) mass += mass_of(c, own_place(c, strand, (group.first + k) % c.nodes));
    for (size_t j = 0; j < count; ++j) {
        const double v = get_number(c, c.velocity, place(c, strand, node, j)) + impulse[j] / mass;
        if (!(fabs(v) <= most_of(c)))
            return fail(CD_ERROR_VALUE, __func__, "impulse[%zu] is %g: the node's velocity would be %g", j, impulse[j],
                        v);
    }
    for (size_t k = 0; k < group.count; ++k)
        for (size_t j = 0; j < count; ++j) {
            const size_t at = place(c, strand, (group.first + k) % c.nodes, j);
            set_number(c, c.velocity, at, get_number(c, c.velocity, at) + impulse[j] / mass);
        }
    wake(c, strand, 1);
    return CD_OK;
}

cd_status cd_chain_set_end(cd_chain* chain, cd_end end, cd_node kind) {
    CD_OPEN(chain, c);
    CD_CHECK(is_enum(__func__, "end", end, CD_END_LAST));
    CD_CHECK(is_enum(__func__, "kind", kind, CD_NODE_POSED));
    if (kind == CD_NODE_MATCHED && c.ring)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "kind is 3, CD_NODE_MATCHED: a ring has no end");
    const bool posed = kind == CD_NODE_POSED, new_target = posed && !c.target;
    if (posed) CD_CHECK(shared::is_finite(__func__, c)); // the target is the present position
    if (new_target) CD_CHECK(shared::switch_field(__func__, c, CD_TARGET, true));
    const size_t node = end == CD_END_FIRST ? 0 : c.springs;
    const double value = kind;
    cd_status status = CD_OK;
    for (size_t strand = 0; strand < own_strands(c) && status == CD_OK; ++strand)
        status = write_part(__func__, c, Part{CD_PIN, strand, 1, node, 1}, Values(&value), 1);
    if (status != CD_OK && new_target) shared::switch_field(__func__, c, CD_TARGET, false);
    for (size_t strand = 0; strand < c.strands && posed && status == CD_OK; ++strand)
        for (size_t k = 0; k < c.components; ++k) {
            const size_t at = place(c, strand, node, k);
            set_number(c, c.target, at, get_number(c, c.position, at));
        }
    return status;
}

cd_status cd_chain_teleport(cd_chain* chain, size_t strand, const double* rotation, const double* offset,
                            size_t count) {
    CD_OPEN(chain, c);
    CD_CHECK(is_index(__func__, "strand", strand, c.strands));
    if (rotation && count == 2 && curls(c) && rotation[0] * rotation[3] < rotation[1] * rotation[2])
        return fail(CD_ERROR_VALUE, __func__,
                    "rotation is a mirror image, which a rope with rest angles does not take");
    CD_CHECK(shared::teleport(__func__, c, {}, rotation, offset, count, 1, [&](auto f) {
        for (size_t i = 0; i < c.nodes; ++i) f(place(c, strand, i, 0));
    }));
    wake(c, strand, 1);
    return CD_OK;
}

// A node or spring of a strand that has its own, or of all strands.
static cd_status is_own(const char* function, const Chain& c, size_t strand, const char* item, size_t i, size_t count) {
    if (strand > 0 && !has_lengths(c))
        return fail(CD_ERROR_RANGE, function, "strand is %zu, must be 0, for all strands, as the chain is no rope",
                    strand);
    CD_CHECK(is_index(function, "strand", strand, own_strands(c)));
    return is_index(function, item, i, count);
}

cd_status cd_chain_attach(cd_chain* chain, size_t strand, size_t node, double stiffness, double damping,
                          const double* target, size_t count) {
    CD_OPEN(chain, c);
    CD_CHECK(is_own(__func__, c, strand, "node", node, c.nodes));
    const size_t at = own_place(c, strand, node), last = own_strands(c) > 1 ? strand : c.strands - 1;
    return shared::attach(__func__, c, at, stiffness, damping, target, count, [&](auto f) {
        for (size_t s = strand; s <= last; ++s)
            for (size_t k = 0; k < c.components; ++k) f(k, place(c, s, node, k));
    });
}

cd_status cd_chain_detach(cd_chain* chain, size_t strand, size_t node) {
    CD_OPEN(chain, c);
    CD_CHECK(is_own(__func__, c, strand, "node", node, c.nodes));
    return shared::detach(c, own_place(c, strand, node));
}

cd_status cd_chain_get_attachment(const cd_chain* chain, size_t strand, size_t node, double* out_stiffness,
                                  double* out_damping) {
    CD_OPEN(chain, c);
    CD_CHECK(is_own(__func__, c, strand, "node", node, c.nodes));
    return shared::get_attachment(__func__, c, own_place(c, strand, node), out_stiffness, out_damping);
}

cd_status cd_chain_cut(cd_chain* chain, size_t strand, size_t spring) {
    CD_OPEN(chain, c);
    CD_CHECK(is_own(__func__, c, strand, "spring", spring, springs_in_all(c)));
    CD_CHECK(shared::switch_field(__func__, c, CD_STIFFNESS, true));
    c.spring_stiffness[own_place(c, strand, spring)] = 0;
    c.prepared_dt = 0;
    wake(c, strand, 1);
    return CD_OK;
}

cd_status cd_chain_weld(cd_chain* chain, size_t strand, size_t spring) {
    CD_OPEN(chain, c);
    CD_CHECK(is_own(__func__, c, strand, "spring", spring, springs_in_all(c)));
    if (!has_lengths(c) && !groups_are_sound(
                               c.nodes, c.ring != 0, [&](size_t i) { return i == spring || welded(c, i); },
                               [&](size_t i) { return held(c, i); }))
        return fail(CD_ERROR_UNSUPPORTED, __func__, "spring is %zu, by which two held nodes would be welded together",
                    spring);
    CD_CHECK(shared::switch_field(__func__, c, CD_STIFFNESS, true));
    c.spring_stiffness[own_place(c, strand, spring)] = double(INFINITY);
    c.prepared_dt = 0;
    wake(c, strand, 1);
    merge_velocities(c, 0, c.lines);
    return CD_OK;
}

cd_status cd_chain_sample(const cd_chain* chain, size_t strand, const double* at, size_t n, cd_outside outside,
                          double* out_positions, size_t out_count) {
    CD_OPEN(chain, c);
    CD_CHECK(is_index(__func__, "strand", strand, c.strands));
    CD_CHECK(can_sample(__func__, at, n, outside, out_positions));
    CD_CHECK(is_count(__func__, "out_count", out_count, n * c.components));
    const double most = double(springs_in_all(c));
    for (size_t j = 0; j < n; ++j) CD_CHECK(is_place(__func__, at, j, most, outside));
    for (size_t j = 0; j < n; ++j) {
        const double there = nearest(at[j], most);
        const size_t whole = size_t(there), last = springs_in_all(c) > 0 ? springs_in_all(c) - 1 : 0;
        const size_t i = whole < last ? whole : last, next = i + 1 < c.nodes ? i + 1 : c.ring ? 0 : i;
        const double t = there - double(i);
        for (size_t k = 0; k < c.components; ++k) {
            const double a = get_number(c, c.position, place(c, strand, i, k));
            const double b = get_number(c, c.position, place(c, strand, next, k));
            out_positions[j * c.components + k] = (1 - t) * a + t * b;
        }
    }
    return CD_OK;
}
