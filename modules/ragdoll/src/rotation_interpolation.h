// SPDX-License-Identifier: MIT
//
// Interpolation of rotations without the C library.
#pragma once

#include "jostle/physics/quat.h"
#include "jostle/physics/transform.h"

namespace jostle::modules {

// Rotation vector of the shorter arc: |v| radians about v, at most pi.
inline physics::Vec3 rotation_vector(physics::Quat q) {
    using namespace physics;
    if (q.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
    const Vec3 v{q.x, q.y, q.z};
    const double s = length(v);
    return s < 1e-12 ? v * 2 : v * (2 * arc_tangent(s, q.w) / s);
}

// Interpolates along the shorter arc.
inline physics::Quat interpolate(physics::Quat from, physics::Quat to, double fraction) {
    using namespace physics;
    return normalized(from_rotation_vector(rotation_vector(to * conjugate(from)) * fraction) *
                      from);
}
inline physics::Transform interpolate(const physics::Transform& from, const physics::Transform& to,
                                      double fraction) {
    return {from.position + (to.position - from.position) * fraction,
            interpolate(from.rotation, to.rotation, fraction)};
}

// Rotation angle about the z axis, -pi to pi.
inline double angle_about_z(physics::Quat q) {
    double angle = 2 * physics::arc_tangent(q.z, q.w);
    if (angle > physics::pi) angle -= 2 * physics::pi;
    if (angle < -physics::pi) angle += 2 * physics::pi;
    return angle;
}

inline physics::Transform inverse(const physics::Transform& t) {
    const physics::Quat back = conjugate(t.rotation);
    return {rotate(back, -t.position), back};
}

}  // namespace jostle::modules
