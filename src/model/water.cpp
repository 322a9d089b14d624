// The water's parameters and memory.
#include "model/water.hh"

#include "base/status.hh"
#include "model/life.hh"
#include "model/water_hull.hh"
#include "solve/planes.hh"

namespace cd {

// ---- cells and faces ------------------------------------------------------------------------------------------------

bool crossable(const Water& w, Axis a, size_t i, size_t j) {
    return crossable(
        w.cells, w.side, a, i, j, [&](size_t x, size_t y) { return present(w, x, y); },
        [&](Axis axis, size_t x, size_t y) { return w.wall[axis] && w.wall[axis][byte_place(w, x, y)] != 0; });
}

namespace {

// The cells beside a face of an axis.
struct CellsBeside {
    size_t low, high;

    CellsBeside(const Water& w, Axis a, size_t i, size_t j) {
        const size_t at = a == kX ? i : j, n = w.cells[a], l = at > 0 ? at - 1 : n - 1, h = at < n ? at : 0;
        low = a == kX ? place(w, l, j) : place(w, i, l), high = a == kX ? place(w, h, j) : place(w, i, h);
    }
};

} // namespace

double face_depth(const Water& w, Axis a, size_t i, size_t j) {
    const size_t at = a == kX ? i : j, n = w.cells[a];
    if (((at == 0 || at == n) && !periodic(w, a)) || !crossable(w, a, i, j)) return 0;
    const CellsBeside cells(w, a, i, j);
    const double d_p = get_number(w, w.depth, cells.low), d_q = get_number(w, w.depth, cells.high);
    if (d_p > 0 && d_q > 0) return (d_p + d_q) / 2;
    const double rise = get_number(w, w.bed, cells.low) - get_number(w, w.bed, cells.high);
    const double on_it = rise > 0 ? d_p : d_q, reach = rise > 0 ? d_q - rise : d_p + rise; // over the higher bed
    return on_it > reach ? on_it : reach;
}

double moving_depth(const Water& w, Axis a, size_t i, size_t j) {
    if (!(face_depth(w, a, i, j) > 0)) return 0;
    const CellsBeside cells(w, a, i, j);
    return (get_number(w, w.depth, cells.low) + get_number(w, w.depth, cells.high)) / 2;
}

// ---- memory ---------------------------------------------------------------------------------------------------------

WaterFeatures features(const Water& w) {
    return {w.method,
            w.momentum,
            bool(w.source),
            bool(w.pressure),
            {bool(w.force[kX]), bool(w.force[kY])},
            bool(w.mask),
            {bool(w.wall[kX]), bool(w.wall[kY])},
            w.parallel.run != nullptr,
            w.hull_shape,
            w.sleep > 0};
}

bool set_features(Water& w, const WaterFeatures& wanted) {
    size_t scratch;
    if (!needs_of(w, wanted, scratch)) return false;
    const size_t state = w.plane * number_size(w), bytes = (w.cells[kX] + 1) * (w.cells[kY] + 1);
    Changes all;
    Change mask{all, w.mask, wanted.mask ? bytes : 0}, hulls{all, w.hulls, wanted.hulls.count * wanted.hulls.numbers()};
    Change others[] = {{all, w.depth, state},
                       {all, w.bed, state},
                       {all, w.velocity[kX], state},
                       {all, w.velocity[kY], state},
                       {all, w.source, wanted.source ? state : 0},
                       {all, w.pressure, wanted.pressure ? state : 0},
                       {all, w.force[kX], wanted.force[kX] ? state : 0},
                       {all, w.force[kY], wanted.force[kY] ? state : 0},
                       {all, w.wall[kX], wanted.wall[kX] ? bytes : 0},
                       {all, w.wall[kY], wanted.wall[kY] ? bytes : 0},
                       {all, w.scratch, scratch},
                       {all, w.tiles.stir, wanted.sleep ? w.tiles.size() : 0},
                       {all, w.tiles.marks, wanted.sleep ? w.tiles.size() : 0}};
    (void)others; // `all` knows them
    const bool same_hulls = wanted.hulls.along == w.hull_shape.along && wanted.hulls.across == w.hull_shape.across;
    if (wanted.method == w.method && wanted.momentum == w.momentum && same_hulls && all.keep_all()) return true;
    if (!all.take_all(w.memory)) return false;
    if (wanted.hulls.numbers() == w.hull_shape.numbers()) hulls.carry_over();
    all.put_all(w.memory);
    w.method = wanted.method;
    w.momentum = wanted.momentum;
    w.hull_shape = wanted.hulls;
    if (mask.is_new()) memset(w.mask.data, 1, w.mask.bytes());
    w.prepared_dt = 0;
    return true;
}

// ---- parameters and state -------------------------------------------------------------------------------------------

// The two faces at the ends of each line along an axis become one: it moves as they do in the mean, and a wall stands
// on it where one stood on either.
static void join_ends(Water& w, Axis a) {
    const size_t n = w.cells[a];
    for (size_t k = 0; k < w.cells[other(a)]; ++k) {
        const size_t first_x = a == kX ? 0 : k, first_y = a == kX ? k : 0;
        const size_t last_x = a == kX ? n : k, last_y = a == kX ? k : n;
        const size_t p = place(w, first_x, first_y), q = place(w, last_x, last_y);
        for (const Array<char>* array : {&w.velocity[a], &w.force[a]}) {
            if (!*array) continue;
            const double mean = get_number(w, *array, p) / 2 + get_number(w, *array, q) / 2;
            set_number(w, *array, p, mean);
            set_number(w, *array, q, mean);
        }
        if (!w.wall[a]) continue;
        uint8_t &at_p = w.wall[a][byte_place(w, first_x, first_y)], &at_q = w.wall[a][byte_place(w, last_x, last_y)];
        at_p = at_q = at_p | at_q;
    }
}

void set_side(Water& w, cd_side side, const WaterSide& wanted) {
    const Axis a = axis_of(side);
    const cd_side opposite = side_of(a, side == side_of(a, false));
    const bool was_periodic = periodic(w, a), is_periodic = wanted.kind == CD_BORDER_PERIODIC;
    const bool same_kind = wanted.kind == w.side[side].kind;
    w.side[side] = wanted;
    if (is_periodic) w.side[opposite] = wanted;
    else if (was_periodic) w.side[opposite] = {CD_BORDER_WALL, 0, 0};
    w.prepared_dt = 0;
    if (same_kind) return;
    if (is_periodic) join_ends(w, a);
    stop_closed(w);
}

void clear_state(Water& w) {
    for (const Array<char>* array : {&w.depth, &w.velocity[kX], &w.velocity[kY]})
        memset(array->data, 0, array->bytes());
    w.clock = {};
    w.account = {};
    w.first = kX;
    w.awake = w.cells[kX] * w.cells[kY];
    if constexpr (CD_WITH_HULL) reset_hulls(w);
}

bool all_finite(const Water& w) {
    bool finite = true;
    for (const Array<char>* array : {&w.depth, &w.velocity[kX], &w.velocity[kY]})
        each_number(w, layout_of(w), *array, [&](auto number) { finite &= isfinite(number) != 0; });
    if constexpr (CD_WITH_HULL) finite &= hulls_finite(w);
    return finite;
}

void stop_closed(Water& w) {
    for (Axis a : {kX, kY})
        each_face(w, a, [&](size_t i, size_t j) {
            if (!crossable(w, a, i, j)) set_number(w, w.velocity[a], place(w, i, j), 0);
        });
    each_cell(w, [&](size_t i, size_t j) {
        if (!present(w, i, j)) set_number(w, w.depth, place(w, i, j), 0);
    });
}

void restart_account(Water& w) { w.account = {volume(w), 0, 0}; }

// ---- life -----------------------------------------------------------------------------------------------------------

cd_status create_water(const char* function, size_t nx, size_t ny, double dx, double dy, cd_precision precision,
                       const cd_allocator& allocator, Water*& out) {
    Water shape{};
    shape.memory.allocator = allocator;
    shape.kernels = &best_kernels<WaterKernels>();
    shape.cells[kX] = nx;
    shape.cells[kY] = ny;
    shape.tiles.count[kX] = tiles_of(nx);
    shape.tiles.count[kY] = tiles_of(ny);
    shape.tiles.all_awake = true;
    shape.size[kX] = dx;
    shape.size[kY] = dy;
    shape.precision = precision;
    // With everything switched on, water of many rows and columns holds less than 80 planes of doubles. What narrow
    // ones need beyond that is counted where it is taken.
    size_t columns, rows, all;
    Grid grid{}; // that of the planes which steps work on
    if (!add(nx, 1, columns) || !add(ny, 1, rows) || !grid_of(columns, rows, grid) ||
        !multiply(rows, shape.pitch = grid.pitch, shape.plane) || !multiply(shape.plane, 80 * sizeof(double), all))
        return fail(CD_ERROR_SIZE, function, "nx %zu and ny %zu cells do not fit in memory", nx, ny);
    shape.lambda = kLinearLambda;
    shape.gravity = 9.81;
    shape.density = 1000;
    shape.awake = nx * ny;

    out = make(shape, kWaterTag);
    if (!out) return fail(CD_ERROR_MEMORY, function, "no memory for nx %zu and ny %zu cells", nx, ny);
    return CD_OK;
}

} // namespace cd
