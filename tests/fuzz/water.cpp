#include "water.hpp"

#include <math.h>

#include "random.hpp"

namespace fuzz {

static size_t pick_cells(double few) { return 1 + (chance(few) ? below(4) : chance(0.6) ? below(14) : below(40)); }
static double pick_cell_size() { return run.sane || chance(0.7) ? decades(-1, 1.5) : decades(-30, 30); }

Water::Water() {
    nx = pick_cells(0.25);
    ny = pick_cells(0.35);
    new_dx = pick_cell_size();
    new_dy = chance(0.5) ? new_dx : pick_cell_size();
    precision = cd_precision(below(2));
    trace(text("water_create %zu x %zu cells of %.17g x %.17g, precision %d", nx, ny, new_dx, new_dy, int(precision)));
    create();
}

cd_status Water::make(const cd_allocator* allocator, cd_water** out) {
    return cd_water_create(nx, ny, new_dx, new_dy, precision, allocator, out);
}

Water::Lengths Water::cell() const {
    Lengths out = {};
    cd_water_get_shape(first(), nullptr, nullptr, &out.x, &out.y, nullptr);
    return out;
}

Water::Lengths Water::whole() const { return {double(nx) * cell().x, double(ny) * cell().y}; }

bool Water::extent(cd_field field, Extent& out) const {
    if (field < CD_MASK || field > CD_WALL_Y) return false;
    const bool on_x_faces = field == CD_VELOCITY_X || field == CD_FORCE_X || field == CD_WALL_X;
    const bool on_y_faces = field == CD_VELOCITY_Y || field == CD_FORCE_Y || field == CD_WALL_Y;
    out = {ny + on_y_faces, nx + on_x_faces, 1};
    return true;
}

cd_status Water::view(cd_water* handle, cd_field field, View& out) const {
    out.component_stride = 0;
    return cd_water_view(handle, field, &out.data, &out.inner_stride, &out.outer_stride);
}

// ---- what must hold ------------------------------------------------------------------------------------------------

// No depth is negative, absent cells are dry, what is closed is not crossed, and time is finite.
void Water::check_state() {
    double time = 0;
    cd_water_get_time(first(), &time);
    if (!isfinite(time)) return problem("water: time %g", time);
    const Doubles depth = all_of(CD_DEPTH), mask = all_of(CD_MASK);
    for (size_t i = 0; i < depth.size(); ++i)
        if (depth[i] < 0) return problem("water: depth %g in cell %zu", depth[i], i);
    if (!is_finite()) return;
    for (size_t i = 0; i < mask.size(); ++i)
        if (mask[i] == 0 && depth[i] != 0) return problem("water: depth %g in absent cell %zu", depth[i], i);
    check_faces(false);
    check_faces(true);
}

// Of the faces across one direction: those that no water can cross are still, and the two ends of a period are one.
void Water::check_faces(bool along_y) const {
    const size_t n = along_y ? ny : nx, lines = along_y ? nx : ny, columns = along_y ? nx : nx + 1;
    const Doubles velocity = all_of(along_y ? CD_VELOCITY_Y : CD_VELOCITY_X), mask = all_of(CD_MASK);
    const Doubles walls = all_of(along_y ? CD_WALL_Y : CD_WALL_X);
    cd_border border[2] = {};
    for (int end = 0; end < 2; ++end)
        cd_water_get_side(first(), (along_y ? CD_SIDE_Y_FIRST : CD_SIDE_X_FIRST) + end, &border[end], nullptr, nullptr);
    const bool periodic = border[0] == CD_BORDER_PERIODIC;
    for (size_t line = 0; line < lines; ++line) {
        const auto face = [&](size_t i) { return along_y ? i * columns + line : line * columns + i; };
        const auto is_absent = [&](size_t i) {
            return !mask.empty() && mask[along_y ? i * nx + line : line * nx + i] == 0;
        };
        for (size_t i = 0; i <= n; ++i) {
            const bool outer = i == 0 || i == n;
            const size_t before = i > 0 ? i - 1 : periodic ? n - 1 : 0, behind = i < n ? i : periodic ? 0 : n - 1;
            bool closed = is_absent(before) || is_absent(behind);
            closed |= outer && border[i == n] == CD_BORDER_WALL;
            if (!walls.empty() && (!outer || periodic)) closed |= walls[face(outer ? 0 : i)] == 1;
            if (closed && velocity[face(i)] != 0)
                return problem("water: velocity %g across a closed face along %c, number %zu of line %zu",
                               velocity[face(i)], along_y ? 'y' : 'x', i, line);
        }
        if (periodic && velocity[face(0)] != velocity[face(n)])
            return problem("water: velocities %g and %g across the two ends of a period along %c, line %zu",
                           velocity[face(0)], velocity[face(n)], along_y ? 'y' : 'x', line);
    }
}

bool Water::is_driven() const {
    for (double source : all_of(CD_SOURCE))
        if (source != 0) return true;
    for (int side = CD_SIDE_X_FIRST; side <= CD_SIDE_Y_LAST; ++side) {
        cd_border border = {};
        cd_water_get_side(first(), side, &border, nullptr, nullptr);
        if (border != CD_BORDER_WALL && border != CD_BORDER_PERIODIC) return true;
    }
    return false;
}

Water::Account Water::account() const {
    Account a = {};
    cd_water_get_account(first(), &a.initial, &a.in, &a.out, &a.error);
    cd_water_get_volume(first(), &a.volume);
    return a;
}

void Water::before_step(double) { before = account(); }

void Water::after_step(const Step& s) {
    if (s.status == CD_ERROR_DIVERGED) {
        cd_method method = CD_METHOD_IMPLICIT;
        double lambda = 0;
        cd_water_get_method(first(), &method);
        cd_water_get_lambda(first(), &lambda);
        double time = 0;
        cd_water_get_time(first(), &time);
        // Steps may have let it grow before; from here, in such a time no source or tide leaves the range of float32.
        const bool stays_near = time < 1e10 && s.size_before < 1e6;
        const bool is_tame = run.sane && past.moderate && !past.crafted;
        if (is_tame && stays_near && method == CD_METHOD_IMPLICIT && lambda >= 0.5)
            problem("water: diverged, lambda %g, dt %g", lambda, s.dt);
        return;
    }
    if (s.status == CD_OK && !past.crafted && !past.diverged) check_account(s);
}

// The volume changes only by what the account tells, but for rounding.
void Water::check_account(const Step& s) {
    const Account now = account();
    if (!isfinite(before.volume) || !isfinite(before.error)) return;
    if (!isfinite(now.volume) || !isfinite(now.error)) {
        if (run.sane && past.moderate) problem("water: volume %g, error of the account %g", now.volume, now.error);
        return;
    }
    if (now.in < before.in || now.out < before.out)
        problem("water: account in from %g to %g, out from %g to %g", before.in, now.in, before.out, now.out);
    const bool wide = precision == CD_FLOAT64;
    const double moved = before.volume + now.volume + (now.in - before.in) + (now.out - before.out);
    const double area = whole().x * whole().y, steps = double(s.count);
    // Depths are rounded, those below the smallest are cleared in each of up to 64 parts, and the account's sums round.
    const double room = (wide ? 1e-12 : 3e-6) * moved * steps + 0x1p-74 * area * steps +
                        1e-14 * (fabs(now.initial) + now.in + now.out);
    const double lost = fabs(now.error - before.error);
    if (lost > room && now.volume < 1e200)
        problem(
            "water: the account is wrong by %g and then by %g, where rounding explains %g; volume %g and %g, in %g, "
            "out %g, dt %g, %zu steps",
            before.error, now.error, room, before.volume, now.volume, now.in, now.out, s.dt, s.count);
}

} // namespace fuzz
