// Vectors in space.
#pragma once

#include <math.h>

namespace cd {

struct Vector {
    double x = 0, y = 0, z = 0;
};

inline Vector operator+(const Vector& p, const Vector& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
inline Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
inline Vector operator*(const Vector& p, double by) { return {p.x * by, p.y * by, p.z * by}; }
inline Vector operator/(const Vector& p, double by) { return {p.x / by, p.y / by, p.z / by}; }

inline double dot(const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline double length(const Vector& p) { return sqrt(dot(p, p)); }
inline Vector cross(const Vector& p, const Vector& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

} // namespace cd
