// Vertices of whole rows, as kernels write them. What is absent, open, round a ring's end or out of double's range stays
// with model/membrane_draw.cpp and model/water_draw.cpp, which tell what normals are.
#pragma once

#include <stddef.h>

#include "kernel/lanes.hh"
#include "kernel/lines.hh"

namespace cd {

// How many vertices of a row are made together: one less than cells of a sheet are looked at, by eights.
constexpr size_t kDrawnTogether = 63;
// Beyond which squares a normal's size is not taken from its components.
constexpr double kLeastSquare = 0x1p-900, kMostSquare = 0x1p900;
// What rounding makes of a sum of area vectors: differences err by 2^-53 of themselves, products of them by 2^-51 of
// their size, and three additions make it 2^-50.
constexpr double kRoundedArea = 0x1p-50;

// Vertices from `column` on, of the rows `first` and on before `end`. out: where the first of them is written, three
// floats each, `stride` bytes after the last one's, all columns of a row before the next.
struct DrawnBlock {
    size_t column, count, first, end;
    unsigned char* out;
    size_t stride;
};

// The number of column u and row v of axis k lies at v * pitch + u.
struct DrawnSheet {
    StateNumbers axis[3]; // null: no component is drawn along it
    double spacing[3];    // between nodes over the unit square; 0 along every other axis
    size_t columns, rows, pitch;
};
// The surface is depth + bed, at j * pitch + i.
struct DrawnWater {
    StateNumbers depth, bed;
    size_t cells[2], pitch;
    double size[2]; // of a cell [m]
    bool ring[2];
};

namespace CD_ISA {

// Write normals; how many of the block's rows: the next one has a normal that is not in range.
size_t draw_sheet(const DrawnSheet& s, const DrawnBlock& b);
size_t draw_water(const DrawnWater& w, const DrawnBlock& b);

} // namespace CD_ISA
} // namespace cd
