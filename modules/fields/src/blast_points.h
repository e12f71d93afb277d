// SPDX-License-Identifier: MIT
//
// Points on the surface of a shape that an explosion acts on, each representing about the same
// area.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::fields_detail {

struct BlastPoint {
    physics::Vec3 position;  // m, world
    physics::Vec3 area;      // m^2, outward
};

// Returns about `count` points: the centroids of panels that are refined until none exceeds the
// target area. The areas of the points on a flat face sum to the area of the face.
std::vector<BlastPoint> blast_points(const physics::Geometry& geometry,
                                     const physics::Transform& pose, std::uint32_t count);

}  // namespace jostle::modules::fields_detail
