// SPDX-License-Identifier: MIT
//
// Convex solids as lists of faces, and clipping by planes. Two faces that share an edge have
// bit-identical end points, so cells stay closed and their volumes add up to rounding error.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mat3.h"

namespace jostle::modules::destruction_detail {

inline constexpr std::uint32_t outer_face = 0xffffffff;

struct CellFace {
    physics::Vec3 normal;                  // unit, outward
    std::uint32_t neighbour = outer_face;  // the cell on the other side
    std::vector<physics::Vec3> points;     // counter-clockwise seen from outside
};

struct ConvexCell {
    std::vector<CellFace> faces;

    bool empty() const { return faces.empty(); }
};

struct CellMass {
    double volume = 0;
    physics::Vec3 center;
    physics::Mat3 inertia = physics::diagonal({0, 0, 0});  // about the centre, at density 1
};

ConvexCell cell_of(const physics::ConvexHull& hull);
ConvexCell cell_of_box(physics::Vec3 half_extents);
// Returns the part with dot(normal, x) <= offset. Points within `plane_tolerance` of the plane are
// on it.
ConvexCell clipped(const ConvexCell& cell, physics::Vec3 normal, double offset,
                   std::uint32_t neighbour, double plane_tolerance);
CellMass mass_of(const ConvexCell& cell);
physics::Aabb bounds_of(const ConvexCell& cell);  // of a cell that is not empty
// Returns true if the boxes overlap or are at most `apart` apart along each axis.
bool are_near(const physics::Aabb& a, const physics::Aabb& b, double apart);
// Squared distance of the farthest corner from a point.
double furthest_squared(const ConvexCell& cell, physics::Vec3 from);

}  // namespace jostle::modules::destruction_detail
