// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::modules::vehicle_detail {

// The shortest turn from one unit vector to another; half a turn about `otherwise`, square to
// both, where they are opposite.
inline physics::Quat rotation_between(physics::Vec3 from, physics::Vec3 to,
                                      physics::Vec3 otherwise) {
    const physics::Vec3 axis = cross(from, to);
    const physics::Quat q{axis.x, axis.y, axis.z, 1 + dot(from, to)};
    if (norm_squared(q) > 1e-12) return normalized(q);
    return {otherwise.x, otherwise.y, otherwise.z, 0};
}

}  // namespace jostle::modules::vehicle_detail
