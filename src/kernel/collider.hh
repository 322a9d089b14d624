// What the nodes of ropes and cloth do not go through.
#pragma once

namespace cd {

struct Collider {
    double shape;    // a cd_shape; the kernels get none that is CD_SHAPE_NONE
    double point[3]; // of the plane, or the capsule's first end [m]
    double way[3];   // the plane's outward normal, of length 1, or from the capsule's first end to its last [m]
    double radius, friction;
    double velocity[3]; // [m/s]
    double since;       // the time at which it was there [s]

    double place(int k, double time) const { return point[k] + (time - since) * velocity[k]; }
};

} // namespace cd
