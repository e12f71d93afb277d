// SPDX-License-Identifier: MIT
//
// The velocity nearest to the one that is wanted among those that planes allow: a quadratic program
// in three variables, solved exactly by trying which planes hold (at most three do).
#pragma once

#include <array>
#include <span>

#include "jostle/physics/vec3.h"

namespace jostle::modules::character_detail {

struct VelocityPlane {
    physics::Vec3 normal;  // unit
    double min_speed = 0;  // m/s along the normal
};

// More planes than this are not looked at.
inline constexpr std::size_t velocity_planes_max = 16;

// Where no velocity is allowed, one that violates the planes little.
physics::Vec3 nearest_velocity(physics::Vec3 desired, std::span<const VelocityPlane> planes);

// Planes as they are found; of those with one normal, to a degree, the strictest counts.
class VelocityPlanes {
public:
    void add(physics::Vec3 normal, double least);
    physics::Vec3 nearest(physics::Vec3 desired) const {
        return nearest_velocity(desired, {planes_.data(), count_});
    }

private:
    std::array<VelocityPlane, velocity_planes_max> planes_;
    std::size_t count_ = 0;
};

}  // namespace jostle::modules::character_detail
