// SPDX-License-Identifier: MIT
//
// Triangle meshes: built once, immutable, shared.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

class Bvh;

inline constexpr std::size_t max_mesh_triangles = 4u << 20;

struct TriangleMesh {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    // Derived by build_mesh.
    // The triangle across edge k (from corner k to corner k + 1); 0xffffffff: none, or several.
    std::vector<std::array<std::uint32_t, 3>> neighbours;
    std::shared_ptr<const Bvh> tree;  // of the triangles
    Aabb bounds;
    std::uint64_t content_hash = 0;
};

// Vertices at the same place count as one when neighbours are sought; triangles without area
// (narrower than 1e-9 of the size) are dropped. Errors name the vertex or triangle.
Result<std::shared_ptr<const TriangleMesh>> build_mesh(
    std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace jostle::physics
