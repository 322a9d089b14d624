#include "api/shared.hh"
#include "model/keep.hh"

using namespace cd;

cd_status cd_saved_shape(const void* bytes, size_t size, cd_kind* out_kind, size_t* out_first, size_t* out_second,
                         size_t* out_components, cd_precision* out_precision) {
    CD_NOT_NULL(bytes);
    CD_CHECK(shared::can_save(__func__));
    if constexpr (CD_WITH_SAVE) {
        uint32_t kind = 0;
        Shape shape{};
        CD_CHECK(read_shape(__func__, static_cast<const unsigned char*>(bytes), size, kind, shape));
        if (out_kind) *out_kind = cd_kind(kind);
        if (out_first) *out_first = size_t(shape.sizes[0]);
        if (out_second) *out_second = size_t(shape.sizes[1]);
        if (out_components) *out_components = size_t(shape.components);
        if (out_precision) *out_precision = shape.precision;
    }
    return CD_OK;
}
