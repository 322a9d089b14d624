#include "solve/conjugate_gradients.hh"

#include <math.h>

namespace cd {

void Preconditioner::operator()(const SheetSystem& system, bool both_ways, double* r, double* x) const {
    if (lines.ready()) return lines.cycle(system, bands, strips, r, x);
    if (!two) return first.cycle(r, x);
    double *const between = second.level[0].b, *const other = second.level[0].x;
    first.cycle(r, between);
    second.cycle(between, x);
    if (!both_ways) return;
    second.cycle(r, between);
    first.cycle(between, other);
    system.combine(1, x, 1, other);
}

Convergence solve_coupled(const SheetSystem& system, const Preconditioner& preconditioner, const Goal& goal,
                          const GradientPlanes& planes, double* r, double* x) {
    double *const start = planes.start, *const direction = planes.direction, *const steep = planes.steep,
                  *const applied = planes.applied; // no structured binding: C++17 lets no lambda capture one
    // Each node's residual over its diagonal entry: it counts as what it would change, not as a force, of which a stiff
    // spring makes much of little.
    const auto size_of_residual = [&] {
        system.multiply(r, system.inverse_diagonal, steep);
        return sqrt(system.dot(steep, steep));
    };
    const double norm = size_of_residual();
    system.clear(x);
    system.copy(r, start);
    if (norm == 0) return {};

    // Where rounding keeps the residual from falling, the iteration has no end of its own.
    constexpr size_t kPatience = 500; // iterations in which the least residual has to halve
    constexpr size_t kOneWay = 16;    // likewise, while the preconditioner goes one way
    bool both_ways = false;
    double least = 1;
    size_t halved = 0; // the iteration at which it last did

    // The residual that the iteration carries along drifts away from the true one by rounding. Where it claims success
    // the true one decides; if that has not halved since it was last asked, it will not get better.
    constexpr double kRounding = 0x1p-50, kNothing = 0x1p-400; // a sheet at rest but for this has no squares to add up
    Convergence out{0, 1, false};
    double true_before = norm, curvature = 0;
    // what the residual is measured by: at least so much that rounding does not show
    const auto measure = [&] {
        const double size = sqrt(system.dot(x, x));
        return norm + kRounding * (goal.size + size + kNothing) / goal.relative;
    };
    while (out.iterations < goal.most_iterations) {
        preconditioner(system, both_ways, r, steep);
        // conjugate to the last direction, whatever the preconditioner (Fletcher and Reeves' factor needs it symmetric)
        if (curvature > 0) system.combine(-system.dot(steep, applied) / curvature, direction, 1, steep);
        else system.copy(steep, direction);
        curvature = system.apply(direction, applied);
        ++out.iterations;
        if (!(curvature > 0)) break;
        const double length = system.dot(direction, r) / curvature;
        system.combine(1, x, length, direction);
        system.combine(1, r, -length, applied);
        out.residual = size_of_residual() / measure();
        if (out.residual < least / 2) least = out.residual, halved = out.iterations;
        if (out.iterations - halved > kPatience) break;
        const bool astray = out.iterations - halved > kOneWay && out.iterations < goal.most_iterations;
        if (preconditioner.two && !both_ways && astray) { // anew, as the directions so far need not be conjugate
            both_ways = true;
            out.residual = least = 1, halved = out.iterations, curvature = 0;
            system.clear(x);
            system.copy(start, r);
            continue;
        }
        if (out.residual > goal.relative) continue;
        system.apply(x, applied);
        system.copy(start, r);
        system.combine(1, r, -1, applied);
        const double left = size_of_residual();
        out.residual = left / measure();
        out.reached = out.residual <= goal.relative;
        if (out.reached || !(left < true_before / 2)) break;
        true_before = left;
        curvature = 0;
    }
    return out;
}

} // namespace cd
