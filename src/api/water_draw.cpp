// water.h: drawing.
#include "api/water_handle.hh"

using namespace cd;

namespace {

struct Attribute {
    const char* name;
    size_t offset, bytes;

    bool on() const { return offset != SIZE_MAX; }
};

cd_status is_format(const char* function, const WaterVertexFormat& f) {
    const Attribute all[] = {{"position_offset", f.position_offset, 3 * sizeof(float)},
                             {"normal_offset", f.normal_offset, 3 * sizeof(float)},
                             {"depth_offset", f.depth_offset, sizeof(float)}};
    for (const Attribute& a : all) {
        if (!a.on() && &a != all) continue;
        CD_CHECK(is_part(function, a.name, a.offset, a.bytes, f.stride));
        for (const Attribute* b = all; b != &a; ++b)
            if (b->on() && a.offset < b->offset + b->bytes && b->offset < a.offset + a.bytes)
                return fail(CD_ERROR_RANGE, function, "%s is %zu, which overlaps with %s %zu", a.name, a.offset,
                            b->name, b->offset);
    }
    return CD_OK;
}

cd_status is_choice(const char* function, int32_t skip_dry) {
    if (skip_dry == 0 || skip_dry == 1) return CD_OK;
    return fail(CD_ERROR_VALUE, function, "skip_dry is %d, must be 0 or 1", int(skip_dry));
}

} // namespace

cd_status cd_water_write_vertices(const cd_water* water, void* buffer, size_t size, size_t stride,
                                  size_t position_offset, size_t normal_offset, size_t depth_offset) {
    CD_OPEN(water, w);
    CD_NOT_NULL(buffer);
    const WaterVertexFormat format{{stride, position_offset, normal_offset}, depth_offset};
    CD_CHECK(is_format(__func__, format));
    const size_t cells = w.cells[kX] * w.cells[kY];
    size_t needed;
    if (!multiply(cells, stride, needed) || size < needed)
        return fail(CD_ERROR_RANGE, __func__, "size is %zu, must be at least that of %zu vertices of stride %zu", size,
                    cells, stride);
    write_vertices(w, static_cast<unsigned char*>(buffer), format);
    return CD_OK;
}

cd_status cd_water_get_index_count(const cd_water* water, int32_t skip_dry, size_t* out_count) {
    CD_OPEN(water, w);
    CD_NOT_NULL(out_count);
    CD_CHECK(is_choice(__func__, skip_dry));
    *out_count = index_count(w, skip_dry != 0);
    return CD_OK;
}

cd_status cd_water_write_indices(const cd_water* water, int32_t skip_dry, void* buffer, size_t size,
                                 size_t index_size) {
    CD_OPEN(water, w);
    CD_CHECK(is_choice(__func__, skip_dry));
    if (index_size != 2 && index_size != 4)
        return fail(CD_ERROR_VALUE, __func__, "index_size is %zu, must be 2 or 4", index_size);
    const size_t cells = w.cells[kX] * w.cells[kY];
    if (cells > most_vertices(index_size))
        return fail(CD_ERROR_UNSUPPORTED, __func__, "index_size is %zu, too small for %zu vertices", index_size, cells);
    const size_t needed = index_count(w, skip_dry != 0) * index_size; // fits: see create_water
    if (size < needed) return fail(CD_ERROR_RANGE, __func__, "size is %zu, must be at least %zu", size, needed);
    if (needed > 0) CD_NOT_NULL(buffer);
    write_indices(w, skip_dry != 0, static_cast<unsigned char*>(buffer), index_size);
    return CD_OK;
}
