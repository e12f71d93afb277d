// SPDX-License-Identifier: MIT
//
// Vectors in messages to ours and back. Unchecked: who reads a stranger's numbers checks them.
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
