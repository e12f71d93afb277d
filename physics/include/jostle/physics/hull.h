// SPDX-License-Identifier: MIT
//
// Convex hulls: built once, immutable, shared by any number of shapes and worlds, from any thread.
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

inline constexpr std::size_t max_hull_points = 100000;  // that build_hull takes
inline constexpr std::size_t max_hull_vertices = 252;   // of the finished hull
inline constexpr std::size_t max_face_vertices = 64;

struct HullFace {
    Vec3 normal;                         // unit, outward
    double offset = 0;                   // m: dot(normal, x) = offset on the face; none is above
    std::uint32_t first = 0, count = 0;  // in face_vertices, counter-clockwise seen from outside
};

struct HullEdge {
    std::uint16_t from = 0, to = 0;     // vertices; from -> to runs counter-clockwise round `left`
    std::uint16_t left = 0, right = 0;  // faces
};

struct HullLanes;  // vertices, faces and edges side by side, for the narrow phase

struct ConvexHull {
    std::vector<Vec3> vertices;
    std::vector<HullFace> faces;  // coplanar triangles are merged
    std::vector<std::uint16_t> face_vertices;
    std::vector<HullEdge> edges;  // each once

    // Of the solid, density 1.
    double volume = 0;                        // m^3
    Vec3 center;                              // of mass
    Mat3 unit_inertia = diagonal({0, 0, 0});  // about `center`, m^5
    double inner_radius = 0;                  // m: of a ball about `center` that fits inside
    Aabb bounds;
    std::uint64_t content_hash = 0;
    std::shared_ptr<const HullLanes> lanes;

    std::span<const std::uint16_t> vertices_of(const HullFace& face) const {
        return {face_vertices.data() + face.first, face.count};
    }
};

// The hull of 4 to max_hull_points points, in any order, that do not lie in one plane. Coordinates
// are within max_shape_size. Points inside and duplicates are dropped. Triangles that agree to 1e-6
// of the size are merged into faces. An error names the point or the number that is too large.
//
// Quickhull (Barber, Dobkin, Huhdanpaa, "The Quickhull Algorithm for Convex Hulls", 1996), on
// coordinates rounded to 2^-30 of the size: there each question of topology has an exact answer, so
// no input can break it. Vertices keep the coordinates that were given.
Result<std::shared_ptr<const ConvexHull>> build_hull(std::span<const Vec3> points);

}  // namespace jostle::physics
