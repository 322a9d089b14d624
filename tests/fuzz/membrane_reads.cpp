// Calls that read a membrane: what it tells, samples and drawings.
#include "membrane.hpp"

#include <string.h>

#include <algorithm>

#include "random.hpp"

namespace fuzz {

void Membrane::get_edge() {
    const cd_edge edge = pick_enum(CD_EDGE_V_LAST);
    cd_node kinds[2] = {};
    both("get_edge", kReads,
         [&](cd_membrane* membrane, int which) { return cd_membrane_get_edge(membrane, edge, &kinds[which]); });
    must_agree("get_edge", &kinds[0], &kinds[1]);
}

void Membrane::get_attachment() {
    const size_t u = pick_index(nu + 1), v = pick_index(nv + 1);
    double out[2][2] = {};
    both("get_attachment", kReads, [&](cd_membrane* membrane, int which) {
        return cd_membrane_get_attachment(membrane, u, v, &out[which][0], &out[which][1]);
    });
    must_agree("get_attachment", out[0], out[1], 2);
}

void Membrane::get_reaction() {
    const size_t u = pick_index(nu + 1), v = pick_index(nv + 1), count = pick_count(components);
    double force[2][4] = {};
    const cd_status status = both("get_reaction", kReads, [&](cd_membrane* membrane, int which) {
        return cd_membrane_get_reaction(membrane, u, v, force[which], count);
    });
    if (!run.broken && (status == CD_OK) != (u <= nu && v <= nv && count == components))
        problem("get_reaction: %s", cd_status_name(status));
    must_agree("get_reaction", force[0], force[1], 4);
}

void Membrane::get_volume() {
    double volume[2] = {};
    const cd_status status = both("get_volume", kReads, [&](cd_membrane* membrane, int which) {
        return cd_membrane_get_volume(membrane, &volume[which]);
    });
    if (!run.broken && (status == CD_OK) != (components == 3)) problem("get_volume: %s", cd_status_name(status));
    must_agree("get_volume", &volume[0], &volume[1]);
}

// The twin may be a copy that has not stepped yet: they need not agree.
void Membrane::get_convergence() {
    size_t iterations = 0;
    double residual = 0;
    both("get_convergence", kReads,
         [&](cd_membrane* membrane, int) { return cd_membrane_get_convergence(membrane, &iterations, &residual); });
    if (!(residual >= 0) && !past.diverged && !past.crafted && past.moderate)
        problem("get_convergence tells a residual of %g", residual);
}

void Membrane::get_shape() {
    size_t out[3] = {nu, nv, components};
    cd_precision stored = precision;
    const bool some = chance(0.5);
    const cd_status status = both("get_shape", kReads, [&](cd_membrane* membrane, int) {
        return cd_membrane_get_shape(membrane, &out[0], some ? nullptr : &out[1], &out[2], some ? nullptr : &stored);
    });
    if (status != CD_OK || out[0] != nu || out[1] != nv || out[2] != components || stored != precision)
        problem("get_shape tells another shape");
}

// The twin may be a copy that has not stepped yet: they need not agree.
void Membrane::get_solver_taken() {
    cd_solver taken = CD_SOLVER_AUTO;
    both("get_solver_taken", kReads,
         [&](cd_membrane* membrane, int) { return cd_membrane_get_solver_taken(membrane, &taken); });
    if (taken < CD_SOLVER_ALTERNATING || taken > CD_SOLVER_AUTO) problem("get_solver_taken tells %d", int(taken));
}

void Membrane::get_parameter() {
    double pair[2][2] = {};
    size_t iterations[2] = {};
    int32_t ring[2][2] = {};
    switch (below(13)) {
    case 11: get_sleep(cd_membrane_get_sleep); break;
    case 12: get("get_awake", cd_membrane_get_awake); break;
    case 0: get("get_mass", cd_membrane_get_mass); break;
    case 1: get("get_mass_rule", cd_membrane_get_mass_rule); break;
    case 2: get("get_bend", cd_membrane_get_bend); break;
    case 3: get("get_stiffness_damping", cd_membrane_get_stiffness_damping); break;
    case 4: get("get_pressure", cd_membrane_get_pressure); break;
    case 5: chance(0.5) ? get("get_solver", cd_membrane_get_solver) : get_solver_taken(); break;
    case 6: get("get_index_count", cd_membrane_get_index_count); break;
    case 7: get_gravity(cd_membrane_get_gravity); break;
    case 8:
        both("get_stiffness", kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_get_stiffness(membrane, &pair[which][0], &pair[which][1]);
        });
        return must_agree("get_stiffness", pair[0], pair[1], 2);
    case 9:
        both("get_tolerance", kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_get_tolerance(membrane, &pair[which][0], &iterations[which]);
        });
        must_agree("get_tolerance", pair[0], pair[1]);
        return must_agree("get_tolerance", &iterations[0], &iterations[1]);
    default:
        both("get_ring", kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_get_ring(membrane, &ring[which][0], &ring[which][1]);
        });
        must_agree("get_ring", ring[0], ring[1], 2);
    }
}

void Membrane::sample() {
    const size_t n = below(9), count = pick_count(n * components);
    const cd_outside outside = pick_enum(CD_OUTSIDE_NEAREST);
    const Rings ring = rings();
    Doubles at(2 * n), out[2] = {Doubles(n * components + 1, 7), Doubles(n * components + 1, 7)};
    for (size_t i = 0; i < n; ++i) {
        at[2 * i] = pick_between(0, double(nu + ring.u));
        at[2 * i + 1] = pick_between(0, double(nv + ring.v));
    }
    const cd_status status =
        both(text("sample %zu, count %zu", n, count), kReads, [&](cd_membrane* membrane, int which) {
            return cd_membrane_sample(membrane, at.data(), n, outside, out[which].data(), count);
        });
    if (out[0][n * components] != 7) problem("sample wrote past its end");
    if (status == CD_OK) must_agree("sample", out[0].data(), out[1].data(), n * components);
}

void Membrane::write_vertices() {
    size_t stride = 12 + below(30), position = below(10), normal = chance(0.2) ? SIZE_MAX : 12 + below(20);
    size_t size = nodes * stride;
    if (chance(run.bad)) stride = wild_size(24);
    if (chance(run.bad)) position = wild_size(12);
    if (chance(run.bad)) normal = wild_size(12);
    if (chance(run.bad) && size > 0) size -= 1;
    if (stride > 64) size = std::min(size, size_t(8)); // too little for so wide a stride
    Bytes buffer(stride > 64 ? size : std::max(size, nodes * stride), 0x77), twin_buffer = buffer;
    if (stride <= 64 && chance(0.01)) size = SIZE_MAX; // more than there is, but what is there suffices
    const cd_status status = both(
        text("write_vertices size %zu, stride %zu, position at %zu, normal at %zu", size, stride, position, normal),
        kReads, [&](cd_membrane* membrane, int which) {
            Bytes& to = which ? twin_buffer : buffer;
            return cd_membrane_write_vertices(membrane, to.data(), size, stride, position, normal);
        });
    if (status == CD_OK && !past.diverged)
        must_agree("write_vertices", buffer.data(), twin_buffer.data(), buffer.size());
    for (unsigned char byte : buffer)
        if (status != CD_OK && byte != 0x77) return problem("write_vertices failed, but wrote its output");
}

void Membrane::write_indices() {
    size_t count = 0;
    cd_membrane_get_index_count(first(), &count);
    const size_t width = chance(run.bad) ? wild_size(4) : chance(0.5) ? 2 : 4;
    size_t size = count * (width == 2 ? 2 : 4);
    const bool too_small = chance(0.1) && size > 0;
    if (too_small) size -= 1 + below(size);
    Bytes buffer(size);
    const cd_status status = both(
        text("write_indices size %zu, index_size %zu", size, width), kReads,
        [&](cd_membrane* membrane, int) { return cd_membrane_write_indices(membrane, buffer.data(), size, width); });
    if (status != CD_OK || run.broken) return;
    if (too_small) return problem("write_indices fits into too small a buffer");
    for (size_t i = 0; i < count; ++i) {
        uint32_t index = 0; // little-endian machines only, as all that this runs on
        memcpy(&index, &buffer[i * width], width);
        if (index >= nodes) return problem("write_indices: index %u of %zu nodes", unsigned(index), nodes);
    }
}

} // namespace fuzz
