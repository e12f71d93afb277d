// SPDX-License-Identifier: MIT
//
// The surface of a convex shape as flat triangles, for surface forces such as those of water and
// explosions.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::modules::fields_detail {

struct PanelSurface {
    std::vector<physics::Vec3> vertices;                  // m
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
    double area = 0;                                      // m^2, of all triangles
    // The panels approximate a round shape. A force on a ball has no torque about its centre, and a
    // force on a shape of revolution has none about its axis.
    bool round = false;
    double ball = 0;                 // m, radius of the ball; 0 if it is not a ball
    physics::Vec3 center = {};       // of the ball, or a point on the axis
    physics::Vec3 axis = {0, 1, 0};  // unit
};

// Returns the panels of a shape in the frame in which `pose` places it. They are exact for boxes
// and hulls. A round shape has 12 panels around its axis, at a radius that preserves the volume. A
// compound has one surface per child. Planes, meshes and height fields have none.
std::vector<PanelSurface> panel_surfaces(const physics::Geometry& geometry,
                                         const physics::Transform& pose);

// Bisects triangles across their longest edges until none is longer than `longest` (m) or larger
// than `largest` (m^2), or until there are `most`. Larger triangles are bisected first.
void refine(PanelSurface& surface, double longest, double largest, std::size_t most);

// Half the cross product of two edges: the area times the normal.
physics::Vec3 area_of(const PanelSurface& surface, const std::array<std::uint32_t, 3>& triangle);

}  // namespace jostle::modules::fields_detail
