// SPDX-License-Identifier: MIT
//
// Converts vectors from and to messages. Unchecked: callers must validate client values.
#pragma once

#include "jostle/physics/vec3.h"
#include "jostle/v1/common.pb.h"

namespace jostle::server {

inline physics::Vec3 to_vector(const v1::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

inline void write_vector(v1::Vec3& to, physics::Vec3 from) {
    to.set_x(from.x);
    to.set_y(from.y);
    to.set_z(from.z);
}

}  // namespace jostle::server
