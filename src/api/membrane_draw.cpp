// membrane.h: drawing.
#include "api/membrane_handle.hh"

using namespace cd;

namespace {

constexpr size_t kThreeFloats = 3 * sizeof(float);

cd_status is_format(const char* function, const VertexFormat& f) {
    const bool normals = f.normal_offset != SIZE_MAX;
    const size_t least = normals ? 2 * kThreeFloats : kThreeFloats;
    if (f.stride < least) return fail(CD_ERROR_RANGE, function, "stride is %zu, must be at least %zu", f.stride, least);
    CD_CHECK(is_part(function, "position_offset", f.position_offset, kThreeFloats, f.stride));
    if (!normals) return CD_OK;
    CD_CHECK(is_part(function, "normal_offset", f.normal_offset, kThreeFloats, f.stride));
    if (f.normal_offset + kThreeFloats <= f.position_offset || f.position_offset + kThreeFloats <= f.normal_offset)
        return CD_OK;
    return fail(CD_ERROR_RANGE, function, "normal_offset is %zu, less than %zu from position_offset %zu",
                f.normal_offset, kThreeFloats, f.position_offset);
}

} // namespace

cd_status cd_membrane_write_vertices(const cd_membrane* membrane, void* buffer, size_t size, size_t stride,
                                     size_t position_offset, size_t normal_offset) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(buffer);
    const VertexFormat format{stride, position_offset, normal_offset};
    CD_CHECK(is_format(__func__, format));
    size_t needed;
    if (!multiply(m.nodes, stride, needed) || size < needed)
        return fail(CD_ERROR_RANGE, __func__, "size is %zu, must be at least that of %zu vertices of stride %zu", size,
                    m.nodes, stride);
    write_vertices(m, static_cast<unsigned char*>(buffer), format);
    return CD_OK;
}

cd_status cd_membrane_get_index_count(const cd_membrane* membrane, size_t* out_count) {
    CD_OPEN(membrane, m);
    CD_NOT_NULL(out_count);
    *out_count = index_count(m);
    return CD_OK;
}

cd_status cd_membrane_write_indices(const cd_membrane* membrane, void* buffer, size_t size, size_t index_size) {
    CD_OPEN(membrane, m);
    if (index_size != 2 && index_size != 4)
        return fail(CD_ERROR_VALUE, __func__, "index_size is %zu, must be 2 or 4", index_size);
    if (m.nodes > most_vertices(index_size))
        return fail(CD_ERROR_UNSUPPORTED, __func__, "index_size is %zu, too small for %zu vertices", index_size,
                    m.nodes);
    const size_t needed = index_count(m) * index_size; // less than the membrane's own memory: see create_membrane
    if (size < needed) return fail(CD_ERROR_RANGE, __func__, "size is %zu, must be at least %zu", size, needed);
    if (needed > 0) CD_NOT_NULL(buffer);
    write_indices(m, static_cast<unsigned char*>(buffer), index_size);
    return CD_OK;
}
