// SPDX-License-Identifier: MIT
//
// Section properties of a flat convex polygon, for beams.
#pragma once

#include <span>

#include "jostle/physics/vec3.h"

namespace jostle::modules::destruction_detail {

struct Section {
    double area = 0;
    physics::Vec3 center, axis;  // principal axis u; v = normal x u
    double moment_u = 0, moment_v = 0;
    double reach_u = 0, reach_v = 0;
};

// `points` are in order about the unit normal.
Section section_of(std::span<const physics::Vec3> points, physics::Vec3 normal);

}  // namespace jostle::modules::destruction_detail
