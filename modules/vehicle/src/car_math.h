// SPDX-License-Identifier: MIT
//
// Small functions that parts of a car share.
#pragma once

#include "jostle/modules/vehicle_def.h"
#include "jostle/physics/quat.h"

namespace jostle::modules::vehicle_detail {

// Impulse of drag and downforce at velocity v over the time h, N s; implicit in the drag.
inline physics::Vec3 aerodynamic_impulse(const Aerodynamics& air, physics::Vec3 v, physics::Vec3 up,
                                         double mass, double h) {
    const double speed = length(v), flow = 0.5 * air.density * speed * h;
    const double drag = flow * air.drag_area;
    const double press = physics::minimum(flow * speed * air.downforce_area, 100 * mass * h);
    return v * (-drag / (1 + drag / mass)) - up * press;
}

// The shortest rotation from one unit vector to another. For opposite vectors, half a turn about
// `otherwise`, which must be perpendicular to both.
inline physics::Quat rotation_between(physics::Vec3 from, physics::Vec3 to,
                                      physics::Vec3 otherwise) {
    const physics::Vec3 axis = cross(from, to);
    const physics::Quat q{axis.x, axis.y, axis.z, 1 + dot(from, to)};
    if (norm_squared(q) > 1e-12) return normalized(q);
    return {otherwise.x, otherwise.y, otherwise.z, 0};
}

}  // namespace jostle::modules::vehicle_detail
