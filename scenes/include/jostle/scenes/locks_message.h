// SPDX-License-Identifier: MIT
//
// Converts axis locks to a message and back.
#pragma once

#include "jostle/physics/defs.h"

namespace jostle::v1 {
class Locks;
}

namespace jostle::scenes {

/// Any thread.
v1::Locks locks_message(physics::AxisLocks locks);
physics::AxisLocks locks_of(const v1::Locks& message);

}  // namespace jostle::scenes
