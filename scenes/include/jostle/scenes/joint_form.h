// SPDX-License-Identifier: MIT
//
// Converts a joint of a world to a message for display.
#pragma once

#include "jostle/physics/joint_defs.h"

namespace jostle::v1 {
class Joint;
}

namespace jostle::scenes {

/// Writes frames and kind of the joint. The frames are rounded, positions to 2^-16 m and rotations
/// to 2^-14, so that copies of a joint yield equal messages. Any thread.
void write_joint_form(v1::Joint& out, const physics::JointDef& def);

}  // namespace jostle::scenes
