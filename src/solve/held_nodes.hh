// A few nodes of a sheet that are held, by the impulses that hold them (Lagrange multipliers). With E the columns of
// the unit matrix for these nodes and B the system of the sheet without them,
//
//      dw = B^-1 (r + E f),     E^T dw = 0,     so     f = -(E^T B^-1 E)^-1 E^T B^-1 r.
//
// That is the answer of B between motions that leave these nodes alone: as symmetric and as definite as B itself, so
// whatever is stable with B is so here.
#pragma once

#include <math.h>

#include "solve/planes.hh"

namespace cd {

struct HeldNodes {
    static constexpr size_t kMost = 16;

    size_t count = 0;
    size_t* place = nullptr; // in planes, ascending
    double* root = nullptr;  // Cholesky's, of E^T B^-1 E: kMost numbers a row

    void carve(Carver& carve) {
        place = reinterpret_cast<size_t*>(carve.numbers(kMost));
        root = carve.numbers(kMost * kMost);
    }
    // entry(a, b), b <= a: of E^T B^-1 E.
    template <class Entry> void factor(const Entry& entry) const {
        for (size_t a = 0; a < count; ++a)
            for (size_t b = 0; b <= a; ++b) {
                double sum = entry(a, b);
                for (size_t i = 0; i < b; ++i) sum -= row(a)[i] * row(b)[i];
                row(a)[b] = a == b ? sqrt(sum) : sum / row(b)[b];
            }
    }
    // f: in, how the nodes would move; out, the impulses that hold them.
    void balance(double* f) const {
        for (size_t a = 0; a < count; ++a) {
            for (size_t i = 0; i < a; ++i) f[a] -= row(a)[i] * f[i];
            f[a] /= row(a)[a];
        }
        for (size_t a = count; a-- > 0;) {
            for (size_t i = a + 1; i < count; ++i) f[a] -= row(i)[a] * f[i];
            f[a] /= row(a)[a];
        }
        for (size_t a = 0; a < count; ++a) f[a] = -f[a];
    }
    void clear(double* plane) const {
        for (size_t a = 0; a < count; ++a) plane[place[a]] = 0;
    }

private:
    double* row(size_t a) const { return root + a * kMost; }
};

} // namespace cd
