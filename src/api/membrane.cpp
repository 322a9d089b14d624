// membrane.h: life, method, parameters, time, measuring, keeping. What has to do with cloth is in membrane_cloth.cpp,
// fields and acting are in membrane_fields.cpp, drawing in membrane_draw.cpp.
#include "api/membrane_handle.hh"

using namespace cd;

CD_OBJECT_FUNCTIONS(membrane)
CD_BODY_FUNCTIONS(membrane)

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status cd_membrane_create(size_t nu, size_t nv, size_t components, cd_precision precision,
                             const cd_allocator* allocator, cd_membrane** out_membrane) {
    CD_NOT_NULL(out_membrane);
    CD_CHECK(shared::can_make(__func__, components, precision, allocator));
    Membrane* m = nullptr;
    CD_CHECK(create_membrane(__func__, nu, nv, components, precision, allocator ? *allocator : default_allocator(), m));
    *out_membrane = reinterpret_cast<cd_membrane*>(m);
    return CD_OK;
}

cd_status cd_membrane_get_shape(const cd_membrane* membrane, size_t* out_nu, size_t* out_nv, size_t* out_components,
                                cd_precision* out_precision) {
    CD_OPEN(membrane, m);
    if (out_nu) *out_nu = m.springs[kU];
    if (out_nv) *out_nv = m.springs[kV];
    if (out_components) *out_components = m.components;
    if (out_precision) *out_precision = m.precision;
    return CD_OK;
}

// ---- solver ---------------------------------------------------------------------------------------------------------

CD_GETTER(membrane, get_solver, cd_solver, out_solver, x.solver)
CD_GETTER(membrane, get_solver_taken, cd_solver, out_solver, x.taken)

cd_status cd_membrane_set_solver(cd_membrane* membrane, cd_solver solver) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_enum(__func__, "solver", solver, CD_SOLVER_AUTO));
    MembraneFeatures wanted = features(m);
    wanted.solver = solver;
    const bool differs = solver != m.solver;
    CD_CHECK(shared::change_features(__func__, m, wanted));
    if (differs) make_unlike(m);
    return CD_OK;
}

cd_status cd_membrane_set_tolerance(cd_membrane* membrane, double tolerance, size_t most_iterations) {
    CD_OPEN(membrane, m);
    return shared::set_tolerance(__func__, m, tolerance, most_iterations);
}

cd_status cd_membrane_get_tolerance(const cd_membrane* membrane, double* out_tolerance, size_t* out_most_iterations) {
    CD_OPEN(membrane, m);
    return shared::get_tolerance(__func__, m, out_tolerance, out_most_iterations);
}

cd_status cd_membrane_get_convergence(const cd_membrane* membrane, size_t* out_iterations, double* out_residual) {
    CD_OPEN(membrane, m);
    return shared::get_convergence(m, out_iterations, out_residual);
}

// ---- parameters -----------------------------------------------------------------------------------------------------

CD_GETTER(membrane, get_pressure, double, out_pressure, x.pressure)

cd_status cd_membrane_set_stiffness(cd_membrane* membrane, double along_u, double along_v) {
    CD_OPEN(membrane, m);
    CD_CHECK(in_range(__func__, "along_u", along_u, 0, kMost));
    CD_CHECK(in_range(__func__, "along_v", along_v, 0, kMost));
    m.stiffness[kU] = along_u;
    m.stiffness[kV] = along_v;
    fill_uniform(m, CD_STIFFNESS_U);
    fill_uniform(m, CD_STIFFNESS_V);
    changed(m);
    return CD_OK;
}

cd_status cd_membrane_get_stiffness(const cd_membrane* membrane, double* out_along_u, double* out_along_v) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(out_along_u);
    CD_NOT_NULL(out_along_v);
    *out_along_u = m.stiffness[kU];
    *out_along_v = m.stiffness[kV];
    return CD_OK;
}

cd_status cd_membrane_set_pressure(cd_membrane* membrane, double pressure) {
    CD_OPEN(membrane, m);
    CD_CHECK(in_range(__func__, "pressure", pressure, -kMost, kMost));
    if (pressure != 0 && m.components != 3)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "pressure is %g, which needs 3 components: this membrane has %zu",
                    pressure, m.components);
    MembraneFeatures wanted = features(m);
    wanted.pressure = pressure != 0;
    CD_CHECK(shared::change_features(__func__, m, wanted));
    m.pressure = pressure;
    return CD_OK;
}

cd_status cd_membrane_set_edge(cd_membrane* membrane, cd_edge edge, cd_node kind) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_enum(__func__, "edge", edge, CD_EDGE_V_LAST));
    CD_CHECK(is_enum(__func__, "kind", kind, CD_NODE_POSED));
    if (kind == CD_NODE_MATCHED && m.ring[direction_of(edge)])
        return fail(CD_ERROR_UNSUPPORTED, __func__, "kind is 3, CD_NODE_MATCHED, but edge %d lies across a ring",
                    int(edge));
    if (kind == CD_NODE_POSED) CD_CHECK(shared::is_finite(__func__, m)); // targets start as the present positions
    return set_edge(m, edge, kind) ? CD_OK : fail(CD_ERROR_MEMORY, __func__, "no memory");
}

cd_status cd_membrane_get_edge(const cd_membrane* membrane, cd_edge edge, cd_node* out_kind) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_enum(__func__, "edge", edge, CD_EDGE_V_LAST));
    CD_NOT_NULL(out_kind);
    *out_kind = m.edge[edge];
    return CD_OK;
}

cd_status cd_membrane_set_ring(cd_membrane* membrane, int32_t along_u, int32_t along_v) {
    CD_OPEN(membrane, m);
    const int32_t wanted[2] = {along_u, along_v};
    static const char* const names[2] = {"along_u", "along_v"};
    for (Direction d : {kU, kV})
        if (wanted[d] != 0 && wanted[d] != 1)
            return fail(CD_ERROR_VALUE, __func__, "%s is %d, must be 0 or 1", names[d], int(wanted[d]));
    for (Direction d : {kU, kV}) {
        if (wanted[d] && nodes_along(m, d) < 3)
            return fail(CD_ERROR_UNSUPPORTED, __func__, "%s is 1, which needs 3 nodes: this membrane has %zu there",
                        names[d], nodes_along(m, d));
        for (bool at_last : {false, true})
            if (wanted[d] && m.edge[edge_of(d, at_last)] == CD_NODE_MATCHED)
                return fail(CD_ERROR_UNSUPPORTED, __func__, "%s is 1, but edge %d is CD_NODE_MATCHED", names[d],
                            int(edge_of(d, at_last)));
    }
    MembraneFeatures closed = features(m);
    for (Direction d : {kU, kV}) closed.ring[d] = wanted[d] != 0;
    CD_CHECK(is_built(__func__, left_out(closed)));
    if (!set_ring(m, along_u != 0, along_v != 0)) return fail(CD_ERROR_MEMORY, __func__, "no memory");
    wake(m);
    return CD_OK;
}

cd_status cd_membrane_get_ring(const cd_membrane* membrane, int32_t* out_along_u, int32_t* out_along_v) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(out_along_u);
    CD_NOT_NULL(out_along_v);
    *out_along_u = m.ring[kU];
    *out_along_v = m.ring[kV];
    return CD_OK;
}

// ---- time -----------------------------------------------------------------------------------------------------------

cd_status cd_membrane_step(cd_membrane* membrane, double dt, size_t count) {
    CD_OPEN(membrane, m);
    CD_CHECK(shared::can_step(__func__, m, dt, count));
    if (count == 0) return CD_OK;
    if constexpr (CD_WITH_CLOTH)
        if (has_lengths(m)) CD_CHECK(shared::takes_all(__func__, what_cloth_lacks(m)));
    CD_CHECK(shared::knows_colliders(__func__, m));
    const MembraneOutcome outcome = step_membrane(m, dt, count);
    if (outcome.diverged_at) return shared::diverged_at(__func__, outcome.diverged_at);
    CD_CHECK(shared::was_told_distances(__func__, m));
    if (outcome.converged) return CD_OK;
    return fail(CD_ERROR_TOLERANCE, __func__, "a residual of %g is left after %zu iterations, tolerance is %g",
                m.residual, m.iterations, m.tolerance);
}

// ---- measuring ------------------------------------------------------------------------------------------------------

cd_status cd_membrane_get_volume(const cd_membrane* membrane, double* out_volume) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(out_volume);
    if (m.components != 3)
        return fail(CD_ERROR_UNSUPPORTED, __func__, "out_volume needs 3 components: this membrane has %zu",
                    m.components);
    *out_volume = volume(m);
    return CD_OK;
}
