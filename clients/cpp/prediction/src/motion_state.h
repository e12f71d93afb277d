// SPDX-License-Identifier: MIT
//
// Poses and velocities. No functions of the C library are used, so that every build predicts
// identically.
#pragma once

#include "jostle/physics/transform.h"
#include "jostle/snapshot/quantize.h"

namespace jostle::client {

// Pose and velocity of a body.
struct MotionState {
    physics::Transform pose;
    physics::Vec3 linear, angular;  // m/s, rad/s
};

physics::Transform to_transform(const snapshot::Pose& pose);
snapshot::Pose to_pose(const physics::Transform& pose);

// Units of `jostle.motion` per m/s and rad/s (proto/WIRE.md, "Channels").
inline constexpr double velocity_units = 128;
struct Velocity {
    physics::Vec3 linear, angular;  // m/s, rad/s
};

// The rotation from a to b as axis times angle.
physics::Vec3 rotation_vector_between(const physics::Quat& a, const physics::Quat& b);
// Interpolates from a (0) to b (1).
physics::Transform interpolate(const physics::Transform& a, const physics::Transform& b, double t);

}  // namespace jostle::client
