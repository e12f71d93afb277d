// SPDX-License-Identifier: MIT
//
// The allowed velocity nearest to a desired one, where planes restrict the velocity. This is a
// quadratic program in three variables. It is solved exactly by enumerating active sets, of at most
// three planes.
#pragma once

#include <array>
#include <span>

#include "jostle/physics/vec3.h"

namespace jostle::modules::character_detail {

struct VelocityPlane {
    physics::Vec3 normal;  // unit
    double min_speed = 0;  // m/s along the normal
};

// Further planes are ignored.
inline constexpr std::size_t velocity_planes_max = 16;

// Returns the nearest allowed velocity. If none is allowed, returns one with a small violation.
physics::Vec3 nearest_velocity(physics::Vec3 desired, std::span<const VelocityPlane> planes);

// A set of planes. Of planes whose normals agree within 1 degree, the strictest one applies.
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
