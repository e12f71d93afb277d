// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::modules::vehicle_detail {

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
