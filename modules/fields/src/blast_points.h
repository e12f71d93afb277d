// SPDX-License-Identifier: MIT
//
// Where a blast meets a shape: points on its surface, each for about the same area.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::fields_detail {

struct BlastPoint {
    physics::Vec3 position;  // m, world
    physics::Vec3 area;      // m^2, outward
};

// About so many. The middles of panels that are refined until none has more than its share: the
// areas of each flat face sum to that of the face.
std::vector<BlastPoint> blast_points(const physics::Geometry& geometry,
                                     const physics::Transform& pose, std::uint32_t count);

}  // namespace jostle::modules::fields_detail
