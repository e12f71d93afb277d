// SPDX-License-Identifier: MIT
//
// What the solver knows of a joint within one step; made anew each step.
#pragma once

#include <cstdint>

#include "jostle/physics/quat.h"

namespace jostle::physics {

struct JointSide {
    std::uint32_t hot = 0;  // index of the body's HotBody; 0: it does not move
    Vec3 arm;             // of the frame's origin from the centre of mass, at the start of the step
    Quat body;            // the body's rotation at the start
    Quat frame;           // the frame in the world, at the start
    bool pushed = false;  // whether joints can move it
    Vec3 inverse_mass;    // per world axis
    Vec3 given_v, given_w;  // what the joint gave the body in this sub-step so far
    Mat3 inverse_inertia = diagonal({0, 0, 0});  // world axes
};

struct JointWork {
    std::uint32_t joint = 0;
    JointSide a, b;
    Vec3 apart;                  // of b's frame origin from a's at the start of the step, m
    Vec3 force_sum, torque_sum;  // N s, N m s over the step so far
};

}  // namespace jostle::physics
