// SPDX-License-Identifier: MIT
//
// Triangle meshes with adjacency, immutable once built.
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

/// Maximum number of triangles of a mesh.
inline constexpr std::size_t max_mesh_triangles = 4u << 20;

/// A triangle mesh in its local frame. Immutable and shared by any number of shapes, worlds and
/// threads. Create it with build_mesh().
struct TriangleMesh {
    std::vector<Vec3> vertices;                           ///< m
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex indices of the corners

    // The following fields are derived by build_mesh.

    /// neighbours[t][k] is the triangle across edge k of triangle t, from corner k to corner k + 1;
    /// 0xffffffff if there is none or more than one.
    std::vector<std::array<std::uint32_t, 3>> neighbours;
    /// folds[t][k] is the tangent of half the angle between the normals of triangle t and of its
    /// neighbour across edge k. Positive at a ridge seen from the front, negative at a valley,
    /// infinite if there is no neighbour.
    std::vector<std::array<float, 3>> folds;
    double weld_gap = 0;              ///< m: largest distance between vertices that count as one
    std::shared_ptr<const Bvh> tree;  ///< bounding volume hierarchy of the triangles
    Aabb bounds;                      ///< in the local frame
    std::uint64_t content_hash = 0;   ///< equal for equal contents
};

/// Builds a mesh of 1 to max_mesh_triangles triangles. Coordinates are within max_shape_size.
/// Vertices within 0.04 mm or 2e-6 of the mesh's size, but at most a fiftieth of the shortest edge
/// at them, count as one for adjacency. Degenerate triangles (narrower than 1e-9 of the mesh's
/// size) and repetitions of a triangle, in either winding, are dropped.
///
/// Errors: invalid_argument, naming the vertex or the triangle.
Result<std::shared_ptr<const TriangleMesh>> build_mesh(
    std::span<const Vec3> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace jostle::physics
