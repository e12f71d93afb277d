// SPDX-License-Identifier: MIT
//
// Triangle meshes: built once, immutable, shared by any number of shapes and worlds, from any
// thread.
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
    std::vector<Vec3> vertices;                           // m
    std::vector<std::array<std::uint32_t, 3>> triangles;  // corners, as indices of vertices

    // Derived by build_mesh.
    // The triangle across edge k (from corner k to corner k + 1); 0xffffffff: none, or several.
    std::vector<std::array<std::uint32_t, 3>> neighbours;
    std::shared_ptr<const Bvh> tree;  // of the triangles
    Aabb bounds;
    std::uint64_t content_hash = 0;
};

// Of 1 to max_mesh_triangles; coordinates within max_shape_size. Vertices at the same place count
// as one when neighbours are sought. Triangles without area (narrower than 1e-9 of the mesh's size)
// are dropped. An error names the vertex or the triangle.
Result<std::shared_ptr<const TriangleMesh>> build_mesh(
    std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace jostle::physics
