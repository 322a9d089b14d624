// water.h: drawing.
#include "api/draw.hh"
#include "api/water_handle.hh"

using namespace cd;

namespace {

cd_status is_choice(const char* function, int32_t skip_dry) {
    if (skip_dry == 0 || skip_dry == 1) return CD_OK;
    return fail(CD_ERROR_VALUE, function, "skip_dry is %d, must be 0 or 1", int(skip_dry));
}

} // namespace

cd_status cd_water_write_vertices(const cd_water* water, void* buffer, size_t size, size_t stride,
                                  size_t position_offset, size_t normal_offset, size_t depth_offset) {
    CD_OPEN(water, w);
    CD_CHECK(can_draw(__func__));
    CD_NOT_NULL(buffer);
    const WaterVertexFormat format{{stride, position_offset, normal_offset}, depth_offset};
    const VertexAttribute all[] = {{"position_offset", position_offset, 3 * sizeof(float)},
                                   {"normal_offset", normal_offset, 3 * sizeof(float)},
                                   {"depth_offset", depth_offset, sizeof(float)}};
    CD_CHECK(is_layout(__func__, all, stride));
    CD_CHECK(has_room(__func__, size, w.cells[kX] * w.cells[kY], stride));
    if constexpr (CD_WITH_DRAW) write_vertices(w, static_cast<unsigned char*>(buffer), format);
    return CD_OK;
}

cd_status cd_water_get_index_count(const cd_water* water, int32_t skip_dry, size_t* out_count) {
    CD_OPEN(water, w);
    CD_CHECK(can_draw(__func__));
    CD_NOT_NULL(out_count);
    CD_CHECK(is_choice(__func__, skip_dry));
    if constexpr (CD_WITH_DRAW) *out_count = index_count(w, skip_dry != 0);
    return CD_OK;
}

cd_status cd_water_write_indices(const cd_water* water, int32_t skip_dry, void* buffer, size_t size,
                                 size_t index_size) {
    CD_OPEN(water, w);
    CD_CHECK(can_draw(__func__));
    CD_CHECK(is_choice(__func__, skip_dry));
    CD_CHECK(can_index(__func__, index_size, w.cells[kX] * w.cells[kY]));
    if constexpr (CD_WITH_DRAW) {
        const size_t needed = index_count(w, skip_dry != 0) * index_size; // fits: see create_water
        CD_CHECK(has_bytes(__func__, buffer, size, needed));
        write_indices(w, skip_dry != 0, static_cast<unsigned char*>(buffer), index_size);
    }
    return CD_OK;
}
