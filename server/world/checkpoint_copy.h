// SPDX-License-Identifier: MIT
//
// The complete state of a world after a tick.
#pragma once

#include <cstdint>

#include "jostle/physics/restore_point.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

struct CheckpointCopy {
    std::uint32_t tick = 0;
    physics::RestorePoint bodies;
    SavedHostState host_state;
};

}  // namespace jostle::server
