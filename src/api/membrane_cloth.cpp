// membrane.h: cloth, its parameters and what surrounds it.
#include "api/membrane_handle.hh"
#include "api/surroundings.hh"

using namespace cd;

// ---- springs that have a length -------------------------------------------------------------------------------------

CD_GETTER(membrane, get_shear, double, out_stiffness, x.cloth.shear)
CD_GETTER(membrane, get_compression, double, out_rate, x.cloth.compression)
CD_GETTER(membrane, get_breaking_strain, double, out_strain, x.cloth.breaking_strain)
CD_GETTER(membrane, get_broken, size_t, out_springs, x.broken)

cd_status cd_membrane_set_rest_length(cd_membrane* membrane, double along_u, double along_v) {
    CD_OPEN(membrane, m);
    const bool cloth = along_u != 0 || along_v != 0;
    if (cloth) CD_CHECK(in_range(__func__, "along_u", along_u, kLeastMass, kMost, kOrBothZero));
    if (cloth) CD_CHECK(in_range(__func__, "along_v", along_v, kLeastMass, kMost, kOrBothZero));
    if (cloth && !can_have_lengths(m))
        return fail(CD_ERROR_UNSUPPORTED, __func__,
                    "along_u is %g, but the membrane has %zu and %zu springs and %zu components: cloth needs springs "
                    "both ways and 3 components",
                    along_u, m.springs[kU], m.springs[kV], m.components);
    MembraneFeatures wanted = features(m);
    wanted.cloth = cloth;
    for (Direction d : {kU, kV})
        if (!cloth) wanted.spring_length[d] = wanted.breaking_strain[d] = false;
    if (!cloth) wanted.air = wanted.wind = false;
    if (!cloth) wanted.colliders = {}, wanted.loads = false;
    CD_CHECK(shared::change_features(__func__, m, wanted));
    if (cloth && !has_lengths(m)) m.lambda = 1;
    if (!cloth) m.cloth = {};
    m.cloth.length[kU] = cloth ? along_u : 0; // not -0
    m.cloth.length[kV] = cloth ? along_v : 0;
    fill_uniform(m, CD_REST_LENGTH_U);
    fill_uniform(m, CD_REST_LENGTH_V);
    changed(m);
    return CD_OK;
}

cd_status cd_membrane_get_rest_length(const cd_membrane* membrane, double* out_along_u, double* out_along_v) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(out_along_u);
    CD_NOT_NULL(out_along_v);
    *out_along_u = m.cloth.length[kU];
    *out_along_v = m.cloth.length[kV];
    return CD_OK;
}

cd_status cd_membrane_set_shear(cd_membrane* membrane, double stiffness) {
    CD_OPEN(membrane, m);
    CD_CHECK(in_range(__func__, "stiffness", stiffness, 0, kMost));
    CD_CHECK(is_cloth(__func__, m, "only cloth has shear"));
    m.cloth.shear = stiffness + 0.0; // not -0
    changed(m);
    return CD_OK;
}

cd_status cd_membrane_set_compression(cd_membrane* membrane, double rate) {
    CD_OPEN(membrane, m);
    CD_CHECK(in_range(__func__, "rate", rate, 0, kMost));
    CD_CHECK(is_cloth(__func__, m, "only cloth crumples"));
    m.cloth.compression = rate + 0.0; // not -0
    changed(m);
    return CD_OK;
}

cd_status cd_membrane_set_breaking_strain(cd_membrane* membrane, double strain) {
    CD_OPEN(membrane, m);
    if (!(isinf(strain) && strain > 0)) CD_CHECK(in_range(__func__, "strain", strain, kLeastMass, kMost, kOrInfinity));
    CD_CHECK(is_cloth(__func__, m, "only cloth tears"));
    MembraneFeatures wanted = features(m);
    for (Direction d : {kU, kV}) wanted.spring_stiffness[d] |= strain < INFINITY;
    CD_CHECK(shared::change_features(__func__, m, wanted));
    m.cloth.breaking_strain = strain;
    fill_uniform(m, CD_BREAKING_STRAIN_U);
    fill_uniform(m, CD_BREAKING_STRAIN_V);
    return CD_OK;
}

static cd_status is_effort(const char* function, const char* name, size_t iterations, uint64_t least, uint64_t most) {
    if (iterations >= least && iterations <= most) return CD_OK;
    return fail(CD_ERROR_VALUE, function, "%s is %zu, must be %zu to %zu", name, iterations, size_t(least),
                size_t(most));
}

cd_status cd_membrane_set_effort(cd_membrane* membrane, size_t newton, size_t gradient) {
    CD_OPEN(membrane, m);
    CD_CHECK(is_effort(__func__, "newton", newton, 1, kMostNewton));
    CD_CHECK(is_effort(__func__, "gradient", gradient, 0, kMostGradient));
    CD_CHECK(is_cloth(__func__, m, "only steps of cloth have an effort"));
    m.cloth.newton = newton;
    m.cloth.gradient = gradient;
    return CD_OK;
}

cd_status cd_membrane_get_effort(const cd_membrane* membrane, size_t* out_newton, size_t* out_gradient) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(out_newton);
    CD_NOT_NULL(out_gradient);
    *out_newton = size_t(m.cloth.newton);
    *out_gradient = size_t(m.cloth.gradient);
    return CD_OK;
}

// ---- what surrounds it ----------------------------------------------------------------------------------------------

CD_SURROUNDINGS_FUNCTIONS(membrane)
CD_FUNCTION(membrane, , set_thickness, (double distance),
            shared::set_thickness(__func__, x, "distance", distance, x.cloth.thickness))
CD_GETTER(membrane, get_thickness, double, out_distance, x.cloth.thickness)
