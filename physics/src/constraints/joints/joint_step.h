// SPDX-License-Identifier: MIT
//
// The numbers of a sub-step that all joints share.
#pragma once

namespace jostle::physics {

// Of h seconds. Joints are as stiff as the sub-step can carry: more sub-steps are stiffer.
struct JointStep {
    float h = 0, inverse_h = 0;
    // Of what the user did not make a spring (constraints/softness.h).
    float position_rate = 0, velocity_scale = 1, impulse_scale = 0;
    float direct_rate = 0;                // 1/s: of what joints that are solved at once are apart
    float push_speed = 0, push_spin = 0;  // m/s, rad/s: at most, of what is no spring
};

JointStep joint_step(double h);

}  // namespace jostle::physics
