// SPDX-License-Identifier: MIT
//
// Poses and what bodies do. Nothing here is of the C library, so that every build foresees the
// same.
#pragma once

#include "jostle/physics/transform.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::client {

// What a body does.
struct MotionState {
    physics::Transform pose;
    physics::Vec3 linear, angular;  // m/s, rad/s
};

physics::Transform to_transform(const wire::Pose& pose);
wire::Pose to_pose(const physics::Transform& pose);

// As `jostle.motion` tells them (proto/WIRE.md, "Channels").
inline constexpr double velocity_units = 128;
struct Velocity {
    physics::Vec3 linear, angular;  // m/s, rad/s
};

// The rotation from a to b as an axis times an angle.
physics::Vec3 rotation_vector_between(const physics::Quat& a, const physics::Quat& b);
// From a (0) to b (1).
physics::Transform interpolate(const physics::Transform& a, const physics::Transform& b, double t);

}  // namespace jostle::client
