// SPDX-License-Identifier: MIT
//
// The angles that joints limit, of two frames in the world.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

double hinge_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double twist_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double swing_angle(Quat frame_a, Quat frame_b);  // rad, 0..pi

}  // namespace jostle::physics
