// SPDX-License-Identifier: MIT
//
// A convex solid as its faces, and cutting it by planes. Two faces that share an edge keep the same
// bits of its ends, so cells stay closed and their volumes add up to rounding.
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
    std::uint32_t neighbour = outer_face;  // whose cell lies beyond
    std::vector<physics::Vec3> points;     // counter-clockwise seen from outside
};

struct ConvexCell {
    std::vector<CellFace> faces;

    bool empty() const { return faces.empty(); }
};

struct CellMass {
    double volume = 0;
    physics::Vec3 center;
    physics::Mat3 inertia = physics::diagonal({0, 0, 0});  // about the centre, density 1
};

ConvexCell cell_of(const physics::ConvexHull& hull);
ConvexCell cell_of_box(physics::Vec3 half_extents);
// Keeps what lies at dot(normal, x) <= offset. Points within `grain` of the plane are on it.
ConvexCell clipped(const ConvexCell& cell, physics::Vec3 normal, double offset,
                   std::uint32_t neighbour, double plane_tolerance);
CellMass mass_of(const ConvexCell& cell);
physics::Aabb bounds_of(const ConvexCell& cell);  // of one that is not empty
// Whether boxes overlap, or are no further apart than that along each axis.
bool are_near(const physics::Aabb& a, const physics::Aabb& b, double apart);
// Squared distance of the corner that is furthest from a point.
double furthest_squared(const ConvexCell& cell, physics::Vec3 from);

}  // namespace jostle::modules::destruction_detail
