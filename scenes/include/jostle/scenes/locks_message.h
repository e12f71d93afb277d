// SPDX-License-Identifier: MIT
//
// Directions in which a body cannot move, as a message and back.
#pragma once

#include "jostle/physics/defs.h"

namespace jostle::v1 {
class Locks;
}

namespace jostle::scenes {

v1::Locks locks_message(physics::AxisLocks locks);
physics::AxisLocks locks_of(const v1::Locks& message);

}  // namespace jostle::scenes
