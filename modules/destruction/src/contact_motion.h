// SPDX-License-Identifier: MIT
//
// Velocity and effective mass of a body at a point.
#pragma once

#include "jostle/physics/world.h"

namespace jostle::modules::destruction_detail {

// Inverse effective mass of a body at a point along a unit direction, 1/kg; 0 if it cannot move.
inline double inverse_effective_mass(const physics::BodyState& body, physics::Vec3 point,
                                     physics::Vec3 n) {
    if (!(body.mass > 0)) return 0;
    const physics::Vec3 turn = cross(point - body.center, n);
    return 1 / body.mass + dot(turn, inverse(body.inertia) * turn);
}

inline physics::Vec3 velocity_at(const physics::BodyState& body, physics::Vec3 point) {
    return body.linear_velocity + cross(body.angular_velocity, point - body.center);
}

}  // namespace jostle::modules::destruction_detail
