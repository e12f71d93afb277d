// SPDX-License-Identifier: MIT
//
// Boxes, hulls and triangles as one thing for the separating axis test: vertices, faces, edges.
#pragma once

#include <span>

#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/hull_lanes.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

// In the shape's own frame. A triangle is a prism without height: two faces, and one side face of
// two corners per edge, so that every edge has two faces whose normals are less than a half turn
// apart.
struct Polyhedron {
    std::span<const Vec3> vertices;
    std::span<const HullFace> faces;
    std::span<const std::uint16_t> face_vertices;
    std::span<const HullEdge> edges;
    Vec3 middle;
    double inner_radius = 0;           // m: of a ball about `middle` that fits inside
    const HullLanes* lanes = nullptr;  // of a hull

    std::span<const std::uint16_t> vertices_of(const HullFace& face) const {
        return face_vertices.subspan(face.first, face.count);
    }
};

// Space for the parts that a box or a triangle does not keep itself.
struct PolyhedronParts {
    UninitializedArray<Vec3, 8> vertices;
    UninitializedArray<HullFace, 6> faces;
};

// `shape` is a polyhedron; the answer points into `parts` and the shape.
Polyhedron polyhedron_of(const Convex& shape, PolyhedronParts& parts);

// Which vertex lies furthest along d (any length); of equal ones the first.
std::size_t furthest_vertex(const Polyhedron& shape, Vec3 d);

// How far apart balls are along each of a shape's normals, and along the best of each of its arcs
// of normals: geometry/hull_lanes.h. `to` has room for 8 more than there are, and is 16-byte
// aligned.
void show_normals(const Polyhedron& shape, std::span<const InnerBalls> balls, double sign,
                  float* to);
void show_arcs(const Polyhedron& shape, std::span<const InnerBalls> balls, double sign, float* to);

}  // namespace jostle::physics
