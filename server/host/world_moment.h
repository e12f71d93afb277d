// SPDX-License-Identifier: MIT
//
// A world after a tick, taken in between two.
#pragma once

#include <cstdint>

#include "host/host_image.h"
#include "jostle/physics/restore_point.h"

namespace jostle::server {

struct WorldMoment {
    std::uint32_t tick = 0;
    physics::RestorePoint bodies;
    HostImage image;
};

}  // namespace jostle::server
