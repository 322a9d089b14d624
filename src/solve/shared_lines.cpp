#include "solve/shared_lines.hh"

namespace cd {

SharedLines::SharedLines(size_t nodes_, bool bend, bool ring_, Carver& carve)
    : nodes(nodes_), is_rod(bend || ring_), ring(ring_) {
    none = carve.numbers(nodes);
    if (!is_rod) {
        carry = carve.numbers(nodes);
        pull = carve.numbers(nodes);
        return;
    }
    const auto row = [&] { return carve.numbers(nodes); };
    rod = {row(), row(), row(), row(), row(), row(), row()};
    pin = reinterpret_cast<unsigned char*>(row());
    for (double*& r : response) r = ring ? row() : nullptr;
    static_assert(sizeof(RingClosure) % sizeof(double) == 0, "it lies among numbers");
    closure = ring ? reinterpret_cast<RingClosure*>(carve.numbers(sizeof(RingClosure) / sizeof(double))) : nullptr;
}

void SharedLines::solve(const MembraneKernels& kernels, const cd_parallel& parallel, const Grid& grid, double* plane,
                        double* slope) const {
    if (!CD_WITH_BEND || !is_rod)
        return in_parts(parallel, grid.columns, grid.rows, [&](size_t first, size_t count) {
            kernels.sheet.filter_lines(grid, carry, pull, plane, first, count);
        });
    // The chain's sweeps, for a stage in which no spring wishes for anything.
    const Lines lines{grid.rows, grid.pitch, 1, {plane, true}, {plane, true}, {}, {}};
    const NodeGains gains{none, nullptr, nullptr, nullptr};
    const RodCoefficients c{rod.keep, rod.close, rod.turn, rod.lever, rod.follow, rod.lean,
                            rod.bend, nullptr,   none,     gains,     pin};
    const Stage still{};
    in_parts(parallel, grid.columns, grid.rows, [&](size_t first, size_t count) {
        kernels.rod_sweep(lines, c, still, {}, plane, slope, first, count);
        if (ring) kernels.advance(lines, still, {}, *closure, plane, true, first, count);
    });
}

} // namespace cd
