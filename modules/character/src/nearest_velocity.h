// SPDX-License-Identifier: MIT
//
// The velocity nearest to the one that is wanted among those that planes allow: a quadratic program
// in three variables, solved exactly by trying which planes hold (at most three do).
#pragma once

#include <span>

#include "jostle/physics/vec3.h"

namespace jostle::modules::character_detail {

struct VelocityPlane {
    physics::Vec3 normal;  // unit
    double least = 0;      // m/s along the normal
};

// More planes than this are not looked at.
inline constexpr std::size_t velocity_planes_max = 16;

// Where no velocity is allowed, one that violates the planes little.
physics::Vec3 nearest_velocity(physics::Vec3 wanted, std::span<const VelocityPlane> planes);

}  // namespace jostle::modules::character_detail
