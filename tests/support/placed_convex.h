// SPDX-License-Identifier: MIT
//
// A transformed shape as GJK and SAT use it. For tests that include headers of physics/src.
#pragma once

#include "physics/src/geometry/support.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::test {

inline physics::Convex at(const physics::Geometry& geometry, physics::Vec3 position,
                          physics::Quat rotation = {}) {
    return physics::convex_of(physics::transformed_shape(geometry, {position, rotation}), {});
}

}  // namespace jostle::test
