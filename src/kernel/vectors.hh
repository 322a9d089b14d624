// Vectors and matrices of space, N side by side.
#pragma once

#include "kernel/lanes.hh"

namespace cd {
namespace CD_ISA {

template <int N> struct Vector {
    using L = Lanes<N>;
    L x, y, z;
    static constexpr L Vector::*parts[3] = {&Vector::x, &Vector::y, &Vector::z};

    static Vector load(const double* const* planes, ptrdiff_t at) {
        return {L::load(planes[0] + at), L::load(planes[1] + at), L::load(planes[2] + at)};
    }
    void store(double* const* planes, ptrdiff_t at) const {
        x.store(planes[0] + at), y.store(planes[1] + at), z.store(planes[2] + at);
    }
    friend Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Vector operator*(L s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
    friend L dot(Vector a, Vector b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
    friend Vector select(L by, Vector a, Vector b) {
        return {select(by, a.x, b.x), select(by, a.y, b.y), select(by, a.z, b.z)};
    }
    friend Vector pairs_exchanged(Vector a) {
        return {pairs_exchanged(a.x), pairs_exchanged(a.y), pairs_exchanged(a.z)};
    }
};

// Three rows.
template <int N> struct Matrix {
    using L = Lanes<N>;
    using V = Vector<N>;
    V x, y, z;
    static constexpr V Matrix::*rows[3] = {&Matrix::x, &Matrix::y, &Matrix::z};

    friend V operator*(const Matrix& a, V b) { return {dot(a.x, b), dot(a.y, b), dot(a.z, b)}; }
    friend Matrix operator+(const Matrix& a, const Matrix& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Matrix operator-(const Matrix& a, const Matrix& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Matrix operator*(L s, const Matrix& a) { return {s * a.x, s * a.y, s * a.z}; }
    friend Matrix pairs_exchanged(const Matrix& a) {
        return {pairs_exchanged(a.x), pairs_exchanged(a.y), pairs_exchanged(a.z)};
    }
    static Matrix diagonal(L d) { return {{d, L{}, L{}}, {L{}, d, L{}}, {L{}, L{}, d}}; }
};
template <int N> Vector<N> transposed_times(const Matrix<N>& a, Vector<N> b) {
    return b.x * a.x + (b.y * a.y + b.z * a.z);
}
// a + d times the identity.
template <int N> Matrix<N> plus_diagonal(Matrix<N> a, Lanes<N> d) {
    a.x.x = a.x.x + d, a.y.y = a.y.y + d, a.z.z = a.z.z + d;
    return a;
}
template <int N> Vector<N> cross(Vector<N> a, Vector<N> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// The k-th of three.
template <int N> const Lanes<N>& component(const Vector<N>& a, size_t k) { return a.*Vector<N>::parts[k]; }
template <int N> Lanes<N>& component(Vector<N>& a, size_t k) { return a.*Vector<N>::parts[k]; }
template <int N> const Vector<N>& row(const Matrix<N>& a, size_t k) { return a.*Matrix<N>::rows[k]; }
template <int N> Vector<N>& row(Matrix<N>& a, size_t k) { return a.*Matrix<N>::rows[k]; }
template <int N> Vector<N> column(const Matrix<N>& a, size_t k) {
    return {component(a.x, k), component(a.y, k), component(a.z, k)};
}
// A turn about the third axis.
template <int N> struct Turn {
    using L = Lanes<N>;
    using V = Vector<N>;
    using M = Matrix<N>;
    L cosine, sine;

    friend V operator*(Turn t, V a) { return {t.cosine * a.x - t.sine * a.y, t.sine * a.x + t.cosine * a.y, a.z}; }
    friend M operator*(Turn t, const M& a) {
        return {t.cosine * a.x - t.sine * a.y, t.sine * a.x + t.cosine * a.y, a.z};
    }
    friend M times_transposed(const M& a, Turn t) { return {t * a.x, t * a.y, t * a.z}; }
    friend Turn transposed(Turn t) { return {t.cosine, L{} - t.sine}; }
};
template <int N> CD_INLINED inline Matrix<N> inverse(const Matrix<N>& a) {
    const Vector<N> x = cross(a.y, a.z), y = cross(a.z, a.x), z = cross(a.x, a.y); // columns of the adjugate
    const Lanes<N> scale = Lanes<N>::splat(1) / dot(a.x, x);
    return {scale * Vector<N>{x.x, y.x, z.x}, scale * Vector<N>{x.y, y.y, z.y}, scale * Vector<N>{x.z, y.z, z.z}};
}

} // namespace CD_ISA
} // namespace cd
