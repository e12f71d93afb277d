// SPDX-License-Identifier: MIT
//
// Common representation of boxes, hulls and triangles for the separating axis test: vertices,
// faces, edges.
#pragma once

#include <span>

#include "jostle/base/check.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/hull_lanes.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

// In the shape's own frame. A triangle is a prism of zero height: two faces, and one side face of
// two corners per edge. Every edge then has two faces whose normals are less than 180 degrees
// apart.
struct Polyhedron {
    std::span<const Vec3> vertices;
    std::span<const HullFace> faces;
    std::span<const std::uint16_t> face_vertices;
    std::span<const HullEdge> edges;
    Vec3 middle;
    double inner_radius = 0;           // m: radius of a ball around `middle` that fits inside
    const HullLanes* lanes = nullptr;  // hulls only

    std::span<const std::uint16_t> vertices_of(const HullFace& face) const {
        return face_vertices.subspan(face.first, face.count);
    }
};

// The faces of a box, in the order -x, +x, -y, +y, -z, +z: four corners each, counter-clockwise
// seen from outside. Corner k has +x if bit 0 is set, +y for bit 1, +z for bit 2.
inline constexpr std::uint16_t box_loops[24] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4,
                                                2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
inline Vec3 box_corner(Vec3 half_extents, int k) {
    const Vec3 h = half_extents;
    return {(k & 1) != 0 ? h.x : -h.x, (k & 2) != 0 ? h.y : -h.y, (k & 4) != 0 ? h.z : -h.z};
}

// Storage for the parts that a box or a triangle does not store itself.
struct PolyhedronParts {
    UninitializedArray<Vec3, 8> vertices;
    UninitializedArray<HullFace, 6> faces;
};

// `shape` is a polyhedron. The result points into `parts` and the shape.
Polyhedron polyhedron_of(const Convex& shape, PolyhedronParts& parts);

// The index of the vertex furthest along d (any length). The first of equal ones wins.
std::size_t furthest_vertex(const Polyhedron& shape, Vec3 d);

// Calls visit(face, dot product of its normal with d) in ascending order, for all faces whose dot
// product may be the largest up to 1e-6. `d` is a unit vector.
template <class Visit>
void for_each_face_along(const Polyhedron& shape, Vec3 d, Visit&& visit) {
    const std::size_t count = shape.faces.size();
    if (shape.lanes == nullptr) {
        for (std::size_t k = 0; k < count; k++) visit(k, dot(shape.faces[k].normal, d));
        return;
    }
    alignas(16) float along[2 * max_hull_vertices + 8];
    ASSERT(count <= 2 * max_hull_vertices);
    const float least = normals_along(*shape.lanes, d, along) - 1e-5f;
    for (std::size_t k = 0; k < count; k++)
        if (along[k] >= least) visit(k, dot(shape.faces[k].normal, d));
}

// The separation of balls along each normal of a shape, and along the best direction of each of its
// normal arcs (see geometry/hull_lanes.h). `to` has space for 8 more values than there are and is
// 16-byte aligned.
void show_normals(const Polyhedron& shape, std::span<const InnerBalls> balls, double sign,
                  float* to);
void show_arcs(const Polyhedron& shape, std::span<const InnerBalls> balls, double sign, float* to);

}  // namespace jostle::physics
