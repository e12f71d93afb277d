// SPDX-License-Identifier: MIT
//
// A mesh that bounds a solid: every edge has two triangles with consistent orientation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/result.h"

namespace jostle::modules::convex_decomposition {

using Triangle = std::array<physics::Vec3, 3>;

struct ClosedMesh {
    std::vector<Triangle> triangles;
    physics::Aabb bounds;
    double volume = 0;  // m^3
};

physics::Result<ClosedMesh> make_closed_mesh(std::span<const physics::Vec3> vertices,
                                             std::span<const std::uint32_t> indices);

// Counts the crossings of a ray along x.
bool is_inside(const std::vector<Triangle>& surface, physics::Vec3 point);
double distance_to_surface(const std::vector<Triangle>& surface, physics::Vec3 point);

}  // namespace jostle::modules::convex_decomposition
