// A few nodes of a sheet that are held, or tied by springs and dampers, by the impulses that do it (Lagrange
// multipliers). With E the columns of the unit matrix for these nodes, B the system of the sheet without them, c the
// compliance of each, 0 where it is held, and e by how much its velocity would change if nothing else acted on it,
//
//      dw = B^-1 (r + E f),     E^T dw = e - c f,     so     f = (E^T B^-1 E + c)^-1 (e - E^T B^-1 r).
//
// That is the answer of B + E c^-1 E^T, where nodes are held of B between motions that leave them alone: as symmetric
// and as definite as B itself, so whatever is stable with B is so here. The pull of a tie is not in r: of a stiff one
// most would cancel.
#pragma once

#include <math.h>

#include "solve/planes.hh"

namespace cd {

struct HeldNodes {
    static constexpr size_t kMost = 16;

    size_t count = 0;
    size_t* place = nullptr;      // in planes, ascending
    double* compliance = nullptr; // c
    double* root = nullptr;       // Cholesky's, of E^T B^-1 E + c: kMost numbers a row

    void carve(Carver& carve) {
        place = reinterpret_cast<size_t*>(carve.numbers(kMost));
        compliance = carve.numbers(kMost);
        root = carve.numbers(kMost * kMost);
    }
    // entry(a, b), b <= a: of E^T B^-1 E.
    template <class Entry> void factor(const Entry& entry) const {
        for (size_t a = 0; a < count; ++a)
            for (size_t b = 0; b <= a; ++b) {
                double sum = entry(a, b) + (a == b ? compliance[a] : 0);
                for (size_t i = 0; i < b; ++i) sum -= row(a)[i] * row(b)[i];
                row(a)[b] = a == b ? sqrt(sum) : sum / row(b)[b];
            }
    }
    bool is_held(size_t a) const { return compliance[a] == 0; }
    // f: in, e less how the nodes would move; out, the impulses.
    void balance(double* f) const {
        for (size_t a = 0; a < count; ++a) {
            for (size_t i = 0; i < a; ++i) f[a] -= row(a)[i] * f[i];
            f[a] /= row(a)[a];
        }
        for (size_t a = count; a-- > 0;) {
            for (size_t i = a + 1; i < count; ++i) f[a] -= row(i)[a] * f[i];
            f[a] /= row(a)[a];
        }
    }
    // Where nodes are held.
    void clear(double* plane) const {
        for (size_t a = 0; a < count; ++a)
            if (is_held(a)) plane[place[a]] = 0;
    }

private:
    double* row(size_t a) const { return root + a * kMost; }
};

} // namespace cd
