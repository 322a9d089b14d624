// membrane.h: drawing.
#include "api/draw.hh"
#include "api/membrane_handle.hh"

using namespace cd;

cd_status cd_membrane_write_vertices(const cd_membrane* membrane, void* buffer, size_t size, size_t stride,
                                     size_t position_offset, size_t normal_offset) {
    CD_OPEN(membrane, m);
    CD_CHECK(can_draw(__func__));
    CD_NOT_NULL(buffer);
    const VertexFormat format{stride, position_offset, normal_offset};
    const VertexAttribute all[] = {{"position_offset", position_offset, 3 * sizeof(float)},
                                   {"normal_offset", normal_offset, 3 * sizeof(float)}};
    CD_CHECK(is_layout(__func__, all, stride));
    CD_CHECK(has_room(__func__, size, m.nodes, stride));
    if constexpr (CD_WITH_DRAW) write_vertices(m, static_cast<unsigned char*>(buffer), format);
    return CD_OK;
}

cd_status cd_membrane_get_index_count(const cd_membrane* membrane, size_t* out_count) {
    CD_OPEN(membrane, m);
    CD_CHECK(can_draw(__func__));
    CD_NOT_NULL(out_count);
    if constexpr (CD_WITH_DRAW) *out_count = index_count(m);
    return CD_OK;
}

cd_status cd_membrane_write_indices(const cd_membrane* membrane, void* buffer, size_t size, size_t index_size) {
    CD_OPEN(membrane, m);
    CD_CHECK(can_draw(__func__));
    CD_CHECK(can_index(__func__, index_size, m.nodes));
    if constexpr (CD_WITH_DRAW) {
        const size_t needed = index_count(m) * index_size; // less than the membrane's own memory: see create_membrane
        CD_CHECK(has_bytes(__func__, buffer, size, needed));
        write_indices(m, static_cast<unsigned char*>(buffer), index_size);
    }
    return CD_OK;
}
