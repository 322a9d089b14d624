// The chain's fields one number at a time, and the velocities that welds and pins impose.
#include "model/chain.hh"

#include <math.h>

namespace cd {

bool valid_number(const Chain& c, cd_field field, size_t strand, size_t node, double value) {
    switch (field) {
    case CD_MASS: return valid_mass(value);
#if CD_WITH_ROPE
    case CD_REST_LENGTH: return valid_mass(value);
    case CD_REST_ANGLE: return fabs(value) <= kHalfTurn;
    case CD_TENSION: return isfinite(value) != 0;
    case CD_STRENGTH: return valid_mass(value) || (isinf(value) && value > 0);
#endif
    case CD_STIFFNESS: return valid_parameter(value) || (isinf(value) && value > 0);
    case CD_BEND: return valid_parameter(value);
    case CD_PIN: {
        const bool end = !c.ring && (node == 0 || node + 1 == c.nodes);
        return is_kind(value) || (value == CD_NODE_MATCHED && end);
    }
    case CD_VELOCITY:
        if (c.pin[own_place(c, strand, node)] == CD_NODE_PINNED && value != 0) return false;
        [[fallthrough]];
    default: return fabs(value) <= most_of(c);
    }
}

Group group_of(const Chain& c, size_t node) {
    Group group{node, 1};
    const auto left = [&](size_t i) { return i > 0 ? i - 1 : c.nodes - 1; };
    while (group.count < c.nodes && (group.first > 0 || c.ring) && welded(c, left(group.first))) {
        group.first = left(group.first);
        ++group.count;
    }
    for (size_t last = node; group.count < c.nodes && (last + 1 < c.nodes || c.ring) && welded(c, last); ++group.count)
        last = last + 1 < c.nodes ? last + 1 : 0;
    return group;
}

size_t held_in(const Chain& c, size_t strand, Group group) {
    size_t count = 0;
    for (size_t k = 0; k < group.count; ++k) count += held(c, own_place(c, strand, (group.first + k) % c.nodes));
    return count;
}

// v = v_0 + sum m_i (v_i - v_0) / sum m_i: exact where the velocities already agree. It is computed with velocities so
// small that their products with masses stay finite.
template <class T> static void merge_group(Chain& c, Group group, size_t first_line, size_t lines) {
    constexpr double kSmaller = 0x1p-300, kLarger = 0x1p300;
    T* const v = numbers<T>(c.velocity);
    const auto node = [&](size_t k) { return (group.first + k) % c.nodes; };
    size_t lead = group.first;
    double total = 0;
    bool is_held = false;
    for (size_t k = 0; k < group.count; ++k) {
        total += mass_of(c, node(k));
        if (held(c, node(k))) lead = node(k), is_held = true;
    }
    for (size_t line = first_line; line < first_line + lines; ++line) {
        const double base = kSmaller * double(v[lead * c.pitch + line]);
        double shift = 0;
        for (size_t k = 0; k < group.count && !is_held; ++k)
            shift += mass_of(c, node(k)) * (kSmaller * double(v[node(k) * c.pitch + line]) - base);
        const T merged = T(kLarger * (base + shift / total));
        for (size_t k = 0; k < group.count; ++k) v[node(k) * c.pitch + line] = merged;
    }
}

static void merge(Chain& c, Group group, size_t first_line, size_t lines) {
    if (is_wide(c)) merge_group<double>(c, group, first_line, lines);
    else merge_group<float>(c, group, first_line, lines);
}

void merge_velocities(Chain& c, size_t first_line, size_t lines) {
    if (!c.spring_stiffness || has_lengths(c)) return;
    bool any_start = false;
    for (size_t i = 0; i < c.nodes; ++i) {
        const bool start = i > 0 ? !welded(c, i - 1) : !c.ring || !welded(c, c.nodes - 1);
        any_start |= start;
        if (start && i < c.springs + size_t(c.ring) && welded(c, i)) merge(c, group_of(c, i), first_line, lines);
    }
    if (!any_start) merge(c, group_of(c, 0), first_line, lines); // a ring welded all round
}

void stop_pinned(Chain& c) {
    for (size_t node = 0; node < c.nodes; ++node)
        for (size_t strand = 0; strand < c.strands; ++strand)
            if (c.pin[own_place(c, strand, node)] == CD_NODE_PINNED)
                for (size_t k = 0; k < c.components; ++k) set_number(c, c.velocity, place(c, strand, node, k), 0);
}

void hold_nodes(Chain& c) {
    stop_pinned(c);
    merge_velocities(c, 0, c.lines);
}

} // namespace cd
