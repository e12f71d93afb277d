// SPDX-License-Identifier: MIT
//
// Convex hulls: polyhedra with adjacency and mass properties, immutable once built.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

/// Maximum number of input points of build_hull().
inline constexpr std::size_t max_hull_points = 100000;
inline constexpr std::size_t max_hull_vertices = 252;  ///< maximum number of vertices of a hull
inline constexpr std::size_t max_face_vertices = 64;   ///< maximum number of vertices of a face

/// A face of a convex hull.
struct HullFace {
    Vec3 normal;        ///< unit vector, outward
    double offset = 0;  ///< m; dot(normal, x) = offset on the face, at most offset for all vertices
    /// Range in face_vertices, counter-clockwise seen from outside.
    std::uint32_t first = 0, count = 0;
};

/// An edge of a convex hull.
struct HullEdge {
    std::uint16_t from = 0, to = 0;  ///< vertices; from -> to runs counter-clockwise around `left`
    std::uint16_t left = 0, right = 0;  ///< adjacent faces
};

struct HullLanes;  ///< vertices, faces and edges in SIMD layout, for the narrow phase

/// A convex polyhedron in its local frame. Immutable and shared by any number of shapes, worlds and
/// threads. Create it with build_hull().
struct ConvexHull {
    std::vector<Vec3> vertices;                ///< m
    std::vector<HullFace> faces;               ///< coplanar triangles are merged
    std::vector<std::uint16_t> face_vertices;  ///< indices of vertices, face by face
    std::vector<HullEdge> edges;               ///< each edge once

    // Mass properties of the solid with density 1.
    double volume = 0;                        ///< m^3
    Vec3 center;                              ///< centre of mass, m
    Mat3 unit_inertia = diagonal({0, 0, 0});  ///< about `center`, m^5
    double inner_radius = 0;         ///< m, radius of a ball around `center` that fits inside
    Aabb bounds;                     ///< in the local frame
    std::uint64_t content_hash = 0;  ///< equal for equal contents
    std::shared_ptr<const HullLanes> lanes;  ///< not null in a hull from build_hull()

    /// Returns the vertex indices of a face.
    std::span<const std::uint16_t> vertices_of(const HullFace& face) const {
        return {face_vertices.data() + face.first, face.count};
    }
};

/// Builds the convex hull of 4 to max_hull_points points, in any order, that do not lie in one
/// plane. Coordinates are within max_shape_size. Interior points and duplicates are dropped.
/// Triangles that are coplanar within 1e-6 of the size are merged into faces.
///
/// Errors: invalid_argument, naming the point or the count that exceeds its maximum.
///
/// Quickhull (Barber, Dobkin, Huhdanpaa, "The Quickhull Algorithm for Convex Hulls", 1996) on
/// coordinates rounded to 2^-30 of the size. On these coordinates every topological predicate is
/// exact, so the algorithm handles any input. Vertices retain the original coordinates.
Result<std::shared_ptr<const ConvexHull>> build_hull(std::span<const Vec3> points);

}  // namespace jostle::physics
