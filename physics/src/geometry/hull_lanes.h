// SPDX-License-Identifier: MIT
//
// Vertices, faces and edges of a hull in SIMD layout. Vertices are in double precision, four per
// block, for the support function. Face normals and edge arcs are in single precision, eight per
// block, for the separating axis test, which rejects most of them. The last element is repeated to
// fill a block.
//
// Lanes are combined only in the support function, where ties are resolved by index, so results do
// not depend on the SIMD width.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jostle/physics/hull.h"

namespace jostle::physics {

struct VertexLanes {
    alignas(16) double x[4], y[4], z[4];
};
struct DirectionLanes {
    alignas(16) float x[8], y[8], z[8];
};
// The arc of normals between those of an edge's two faces, perpendicular to the edge.
struct ArcLanes {
    DirectionLanes first, second;  // the normals of the two faces
    // A direction, projected perpendicular to the edge, lies on the arc if its dot products with
    // both of these are not negative.
    DirectionLanes after_first, before_second;
    DirectionLanes along;  // unit vector along the edge
};

struct HullLanes {
    std::vector<VertexLanes> vertices;
    // The same from the centre of mass, in single precision: the support function selects by them.
    std::vector<DirectionLanes> near_vertices;
    std::vector<DirectionLanes> normals;
    std::vector<ArcLanes> arcs;
    // m, radius of a ball around the centre of mass that contains the hull.
    double outer_radius = 0;
};

HullLanes lanes_of(const ConvexHull& hull);

// Returns the index of the vertex that is furthest along d (any length); of several, the first.
std::size_t furthest_vertex(const HullLanes& lanes, Vec3 d);

// Writes the dot product of each normal with a unit vector, to 1e-6, as many values as there are
// lanes, and returns the largest.
float normals_along(const HullLanes& lanes, Vec3 d, float* to);

// A ball inside one shape and a ball inside another. Along a direction n from the first to the
// second, the separation of the shapes is at most that of the balls, n . apart - radii.
struct InnerBalls {
    Vec3 apart;  // m, from the first centre to the second, in the hull's local frame
    double radii = 0;
};
// Computes an upper bound of the separation along each normal, and along the best normal of each
// arc, m: the minimum over the pairs of balls plus a margin for rounding. `sign` is -1 if the
// normals point from the second shape to the first. Writes as many values as there are lanes.
void show_normals(const HullLanes& lanes, std::span<const InnerBalls> balls, double sign,
                  float* to);
void show_arcs(const HullLanes& lanes, std::span<const InnerBalls> balls, double sign, float* to);

}  // namespace jostle::physics
