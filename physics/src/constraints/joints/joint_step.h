// SPDX-License-Identifier: MIT
//
// The parameters of a sub-step that all joints share.
#pragma once

#include <cstdint>

#include "jostle/physics/quat.h"

namespace jostle::physics {

// One body of a joint at the start of the step.
struct JointEnd {
    std::int32_t hot = 0;  // see JointConstraintWideMeta
    Vec3 center, arm;      // centre of mass; from it to the frame's origin
    Quat rotation, frame;  // of the body; of the frame, world
};

// Parameters for a sub-step of h seconds. Joints have the maximum stiffness of the sub-step, so
// more sub-steps make them stiffer.
struct JointStep {
    float h = 0, inverse_h = 0;
    // For rows without a user-defined spring (constraints/softness.h).
    float position_rate = 0, velocity_scale = 1, impulse_scale = 0;
    float direct_rate = 0;                // 1/s: correction rate of point errors in direct groups
    float push_speed = 0, push_spin = 0;  // m/s, rad/s: maxima for rows without a spring
};

JointStep joint_step(double h);

}  // namespace jostle::physics
