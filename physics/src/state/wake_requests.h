// SPDX-License-Identifier: MIT
//
// Who is to wake. Stages file requests; they are applied at two points of the step, in order of
// bodies, so that nothing depends on who found what first (stages/sleep/wake_bodies.h). Not part of
// the state: empty when a step is over.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

struct WakeRequest {
    std::uint32_t body = 0xffffffff;  // one that sleeps, with its island or in place
    double mass = 0;                  // kg: so much around it is to wake with it
    // Only the load on it changed: it goes back to sleep soon if it still rests.
    bool briefly = false;
    auto operator<=>(const WakeRequest&) const = default;
};
using WakeRequests = std::vector<WakeRequest>;

// So much that, if something of that momentum came to rest in it at once, it would be slow. kg from
// kg m/s.
inline double mass_to_wake(double momentum) {
    return momentum / tuning::gentle_speed;
}

}  // namespace jostle::physics
