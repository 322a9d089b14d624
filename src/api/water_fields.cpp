// water.h: fields.
#include "api/water_handle.hh"
#include "base/sum.hh"

using namespace cd;

namespace {

enum class Per { kCell, kFaceX, kFaceY };
Per per(cd_field field) {
    switch (field) {
    case CD_VELOCITY_X:
    case CD_FORCE_X:
    case CD_WALL_X: return Per::kFaceX;
    case CD_VELOCITY_Y:
    case CD_FORCE_Y:
    case CD_WALL_Y: return Per::kFaceY;
    default: return Per::kCell;
    }
}
bool is_bytes(cd_field field) { return field == CD_MASK || field == CD_WALL_X || field == CD_WALL_Y; }
bool is_made(cd_field field) { return field == CD_SURFACE; } // of others

const Array<uint8_t>& bytes_of(const Water& w, cd_field field) {
    return field == CD_MASK ? w.mask : w.wall[field == CD_WALL_X ? kX : kY];
}
const Array<char>& numbers_of(const Water& w, cd_field field) {
    switch (field) {
    case CD_DEPTH: return w.depth;
    case CD_BED: return w.bed;
    case CD_VELOCITY_X: return w.velocity[kX];
    case CD_VELOCITY_Y: return w.velocity[kY];
    case CD_SOURCE: return w.source;
    case CD_PRESSURE: return w.pressure;
    case CD_FORCE_X: return w.force[kX];
    default: return w.force[kY];
    }
}

cd_status is_on(const char* function, const Water& w, cd_field field) {
    CD_CHECK(is_field(function, w, field));
    return must_be_on(function, "water", field,
                      is_made(field)    ? true
                      : is_bytes(field) ? bool(bytes_of(w, field))
                                        : bool(numbers_of(w, field)));
}

struct Place {
    size_t i, j;
};

// See api/fields.hh.
struct Rectangle {
    cd_field field;
    size_t first_x, first_y, n_x, n_y;
    mutable Sum deeper{}; // what a bed that keeps the surface has changed the depths by [m]

    cd_status check(const char* function, const Water& w, size_t count) const {
        CD_CHECK(is_on(function, w, field));
        const bool face_x = per(field) == Per::kFaceX, face_y = per(field) == Per::kFaceY;
        CD_CHECK(is_part(function, "first_x", first_x, "n_x", n_x, w.cells[kX] + (face_x ? 1 : 0),
                         face_x ? "x-faces of a row" : "cells along x"));
        CD_CHECK(is_part(function, "first_y", first_y, "n_y", n_y, w.cells[kY] + (face_y ? 1 : 0),
                         face_y ? "y-faces of a column" : "cells along y"));
        return is_count(function, "count", count, n_x * n_y);
    }

    template <class F> void each(const Water&, F f) const {
        size_t at = 0;
        for (size_t j = first_y; j < first_y + n_y; ++j)
            for (size_t i = first_x; i < first_x + n_x; ++i) f(at++, Place{i, j});
    }

    // The depth that a cell comes to have with a number in the field.
    double new_depth(const Water& w, const Place& p, double value) const {
        const double depth = depth_at(w, p.i, p.j), bed = bed_at(w, p.i, p.j);
        if (field == CD_DEPTH) return value + 0; // which makes 0 of -0
        double wanted = depth;
        if (field == CD_SURFACE && present(w, p.i, p.j)) wanted = value - bed;
        if (field == CD_BED && w.bed_rule == CD_BED_KEEPS_SURFACE && depth > 0) wanted = bed + depth - value;
        return wanted > 0 ? wanted : 0;
    }
    bool valid(const Water& w, const Place& p, double value) const {
        const double most = most_of(w);
        switch (field) {
        case CD_DEPTH: return value >= 0 && value <= (present(w, p.i, p.j) ? most : 0);
        case CD_BED:
        case CD_SURFACE: return fabs(value) <= most && new_depth(w, p, value) <= most;
        case CD_VELOCITY_X: return value == 0 || (fabs(value) <= most && crossable(w, kX, p.i, p.j));
        case CD_VELOCITY_Y: return value == 0 || (fabs(value) <= most && crossable(w, kY, p.i, p.j));
        case CD_MASK:
        case CD_WALL_X:
        case CD_WALL_Y: return value == 0 || value == 1;
        default: return fabs(value) <= most;
        }
    }
    cd_status check_all(const char*, const Water&, const Values&) const { return CD_OK; }

    Block block(const Water& w) const {
        if (is_bytes(field) || is_made(field)) return {};
        return {&numbers_of(w, field), place(w, first_x, first_y), {n_y, n_x, 1}, {w.pitch, 1, 0}};
    }
    bool takes_any(const Water&) const { return field == CD_SOURCE || field == CD_PRESSURE; }

    double get(const Water& w, const Place& p) const {
        if (field == CD_SURFACE) return bed_at(w, p.i, p.j) + depth_at(w, p.i, p.j);
        return bytes_of(w, field)[byte_place(w, p.i, p.j)];
    }
    void put(Water& w, const Place& p, double value) const {
        if (is_bytes(field)) bytes_of(w, field)[byte_place(w, p.i, p.j)] = uint8_t(value);
        else set_number(w, numbers_of(w, field), place(w, p.i, p.j), value);
    }
    void set(Water& w, const Place& p, double value) const {
        if (field == CD_DEPTH || field == CD_SURFACE || field == CD_BED) {
            const size_t at = place(w, p.i, p.j);
            const double old = get_number(w, w.depth, at);
            set_number(w, w.depth, at, new_depth(w, p, value));
            deeper.add(get_number(w, w.depth, at) - old);
            if (field == CD_BED) put(w, p, value);
            return;
        }
        put(w, p, value);
        if (per(field) == Per::kCell) return;
        // the face that is the same one on the opposite side
        const Axis a = per(field) == Per::kFaceX ? kX : kY;
        const size_t along = a == kX ? p.i : p.j, n = w.cells[a];
        if (!periodic(w, a) || (along > 0 && along < n)) return;
        put(w, a == kX ? Place{n - along, p.j} : Place{p.i, n - along}, value);
    }

    void written(Water& w) const {
        if (n_x == 0 || n_y == 0) return;
        w.prepared_dt = 0;
        const bool closes = is_bytes(field), on_seam = per(field) != Per::kCell && (periodic(w, kX) || periodic(w, kY));
        if (closes) stop_closed(w);
        if (closes || on_seam) disturb(w); // elsewhere too
        else disturb(w, {first_x, first_y, n_x, n_y});
        if (field == CD_BED) w.account.add(deeper.value() * cell_area(w));
        if (field == CD_DEPTH || field == CD_SURFACE || field == CD_MASK) restart_account(w);
    }
};

} // namespace

cd_status cd_water_write_f32(cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
                             const float* values, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    return write_part(__func__, w, Rectangle{field, first_x, first_y, n_x, n_y}, Values(values), count);
}

cd_status cd_water_write_f64(cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x, size_t n_y,
                             const double* values, size_t count) {
    CD_OPEN_QUIETLY(water, w);
    return write_part(__func__, w, Rectangle{field, first_x, first_y, n_x, n_y}, Values(values), count);
}

cd_status cd_water_read_f32(const cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
                            size_t n_y, float* out_values, size_t count) {
    CD_OPEN(water, w);
    return read_part(__func__, w, Rectangle{field, first_x, first_y, n_x, n_y}, Values(out_values), count);
}

cd_status cd_water_read_f64(const cd_water* water, cd_field field, size_t first_x, size_t first_y, size_t n_x,
                            size_t n_y, double* out_values, size_t count) {
    CD_OPEN(water, w);
    return read_part(__func__, w, Rectangle{field, first_x, first_y, n_x, n_y}, Values(out_values), count);
}

cd_status cd_water_view(const cd_water* water, cd_field field, const void** out_data, size_t* out_x_stride,
                        size_t* out_y_stride) {
    CD_OPEN(water, w);
    CD_CHECK(is_field(__func__, w, field));
    CD_NOT_NULL(out_data);
    CD_NOT_NULL(out_x_stride);
    CD_NOT_NULL(out_y_stride);
    CD_CHECK(has_view(__func__, field, !is_made(field) && !is_bytes(field)));
    CD_CHECK(is_on(__func__, w, field));
    *out_data = numbers_of(w, field).data;
    *out_x_stride = number_size(w);
    *out_y_stride = w.pitch * number_size(w);
    return CD_OK;
}
