// Checks of what is drawn: vertices in the caller's layout, and their indices.
#pragma once

#include "api/shared.hh"
#include "model/draw.hh"

namespace cd {

inline cd_status can_draw(const char* function) { return is_built(function, CD_WITH_DRAW ? nullptr : "drawing is"); }

// Floats of a vertex; an offset of SIZE_MAX leaves them out, but for the first ones of a layout.
struct VertexAttribute {
    const char* name;
    size_t offset, bytes;

    bool on() const { return offset != SIZE_MAX; }
};

template <size_t n> cd_status is_layout(const char* function, const VertexAttribute (&all)[n], size_t stride) {
    size_t least = 0;
    for (const VertexAttribute& a : all) least += a.on() || &a == all ? a.bytes : 0;
    if (stride < least) return fail(CD_ERROR_RANGE, function, "stride is %zu, must be at least %zu", stride, least);
    for (const VertexAttribute& a : all) {
        if (!a.on() && &a != all) continue;
        if (!lies_within(a.offset, a.bytes, stride))
            return fail(CD_ERROR_RANGE, function, "%s is %zu, from which %zu bytes reach past stride, %zu", a.name,
                        a.offset, a.bytes, stride);
        for (const VertexAttribute* b = all; b != &a; ++b)
            if (b->on() && a.offset < b->offset + b->bytes && b->offset < a.offset + a.bytes)
                return fail(CD_ERROR_RANGE, function, "%s is %zu, which overlaps with %s %zu", a.name, a.offset,
                            b->name, b->offset);
    }
    return CD_OK;
}

inline cd_status has_room(const char* function, size_t size, size_t vertices, size_t stride) {
    size_t needed;
    if (multiply(vertices, stride, needed) && size >= needed) return CD_OK;
    return fail(CD_ERROR_RANGE, function, "size is %zu, must be at least that of %zu vertices of stride %zu", size,
                vertices, stride);
}

inline cd_status has_bytes(const char* function, const void* buffer, size_t size, size_t needed) {
    if (size < needed) return fail(CD_ERROR_RANGE, function, "size is %zu, must be at least %zu", size, needed);
    return needed > 0 ? not_null(function, "buffer", buffer) : CD_OK;
}

inline cd_status can_index(const char* function, size_t index_size, size_t vertices) {
    if (index_size != 2 && index_size != 4)
        return fail(CD_ERROR_VALUE, function, "index_size is %zu, must be 2 or 4", index_size);
    if (vertices <= most_vertices(index_size)) return CD_OK;
    return fail(CD_ERROR_UNSUPPORTED, function, "index_size is %zu, too small for %zu vertices", index_size, vertices);
}

} // namespace cd
