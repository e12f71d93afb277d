// SPDX-License-Identifier: MIT
//
// The angles between two world frames that joints limit.
#pragma once

#include "jostle/physics/quat.h"

namespace jostle::physics {

double hinge_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double twist_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double swing_angle(Quat frame_a, Quat frame_b);  // rad, 0..pi

}  // namespace jostle::physics
