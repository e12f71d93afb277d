// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "jostle/physics/quat.h"

namespace jostle::physics {

// One body of a joint at the start of the step.
struct JointEnd {
    std::int32_t hot = 0;  // as JointConstraintWideMeta's
    Vec3 center, arm;      // of mass; of the frame's origin from it
    Quat rotation, frame;  // of the body; of the frame in the world
};

}  // namespace jostle::physics
