// Alternating directions with shifts (Peaceman and Rachford 1955; Wachspress): an approximate answer for the system of
// a separable sheet, S = A_u M_v + M_u A_v, by solves of lines alone.
//
// With M the masses and one shift p after the other, from x = 0,
//      (M^-1 A_u + p) t = M^-1 r - z,      z = (M^-1 A_v - p) x,      (M^-1 A_v + p) x <- z + 2 p t,
// which multiplies the part of the error that has the rates a along u and b along v by
// (p - a) (p - b) / ((p + a) (p + b)) (model.md, 31). Shifts that cover [least, greatest rate], each twice the one
// before, leave about 1e-4 of it; two or three, 1e-3. z needs no springs: after a step with p, before one with q, it is
// z + 2 p t - (p + q) x. The largest shift comes last: it damps what rounding at small ones did to the stiff parts. The
// directions commute, so all this is symmetric, as a preconditioner must be.
//
// Where single nodes are held (held_nodes.hh), how they would move is the product of r with the response to an impulse
// at each, if these are kept, or else takes all shifts once more.
#pragma once

#include "solve/held_nodes.hh"
#include "solve/planes.hh"
#include "solve/sheet_system.hh"
#include "solve/spring_line.hh"

namespace cd {

struct ShiftedLines {
    static constexpr size_t kMostShifts = 24;
    static constexpr size_t kKept = 4; // responses to impulses at held nodes: of more of them none are kept

    double* shift = nullptr; // ends with a 0, which is all there is where no shifts cover the rates
    const double* inverse_mass[2];
    double *gain[2], *carry[2], *pull[2]; // per shift a line's numbers, `stride` apart
    size_t stride[2];
    double *z, *t, *below;
    const HeldNodes* held = nullptr; // null: none
    double* response[kKept];         // planes

    // held_nodes: null where no single nodes can be.
    void carve(const Grid& grid, const HeldNodes* held_nodes, Carver& coefficients, Carver& scratch);
    bool ready() const { return shift && shift[0] > 0; }
    void choose(double least, double greatest);
    // Factors direction d for all shifts. system(shift): ground(i) of masses 1, of a line's node with that shift;
    // spring(i). weight(i): its mass.
    template <class Make> void factor(int d, size_t nodes, const Make& system) {
        for (size_t k = 0; shift[k] > 0; ++k) {
            const auto line = system(shift[k]);
            double *const g = gain[d] + k * stride[d], *const c = carry[d] + k * stride[d],
                          *const p = pull[d] + k * stride[d];
            factor_spring_line(nodes, line, c, p);
            p[nodes - 1] = 0;
            for (size_t i = 0; i < nodes; ++i) g[i] = line.weight(i) / line.ground(i);
            for (size_t i = nodes; i < stride[d]; ++i) g[i] = c[i] = p[i] = 0;
        }
    }
    // Makes ready for the held nodes. r, x: scratch, planes.
    void hold(const SheetSystem& system, const Parts& bands, const Parts& strips, double* r, double* x) const;
    // x = S^-1 r, nearly, 0 at the held nodes. r is 0 there, and afterwards what it was.
    void cycle(const SheetSystem& system, const Parts& bands, const Parts& strips, double* r, double* x) const;

private:
    bool keeps_responses() const { return held->count <= kKept; }
    // x = S^-1 r, nearly, of the sheet without held nodes.
    void shift_all(const SheetSystem& system, const Parts& bands, const Parts& strips, const double* r,
                   double* x) const;
};

} // namespace cd
