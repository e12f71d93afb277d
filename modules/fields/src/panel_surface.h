// SPDX-License-Identifier: MIT
//
// The surface of a convex shape as flat triangles, for what acts on its surface: water, blasts.
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
    // What the panels only stand for: a push on a ball has no torque about its centre, one on what
    // is round about an axis none about that.
    bool round = false;
    double ball = 0;                 // m, its radius; 0: it is none
    physics::Vec3 center = {};       // of the ball, or a point of the axis
    physics::Vec3 axis = {0, 1, 0};  // unit
};

// In the frame in which `pose` places it. Exact for boxes and hulls. of what is round, 12 panels
// run about the axis, so far out that they hold the shape's volume. A compound gives one surface
// for each child. Planes, meshes and height fields have none.
std::vector<PanelSurface> panel_surfaces(const physics::Geometry& geometry,
                                         const physics::Transform& pose);

// Halves triangles across their longest edges until none is longer than `longest` (m) nor larger
// than `largest` (m^2), or there are `most`. Those that are largest come first.
void refine(PanelSurface& surface, double longest, double largest, std::size_t most);

// Half the cross product of two edges: the area, along the normal.
physics::Vec3 area_of(const PanelSurface& surface, const std::array<std::uint32_t, 3>& triangle);

}  // namespace jostle::modules::fields_detail
