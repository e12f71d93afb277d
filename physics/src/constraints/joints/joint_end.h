// SPDX-License-Identifier: MIT
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

}  // namespace jostle::physics
