// SPDX-License-Identifier: MIT
//
// Wake requests. Stages file them; they are applied at two points of the step in order of bodies,
// so that the result does not depend on the order of discovery (stages/sleep/wake_bodies.h). Not
// part of the state: empty after a step.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

struct WakeRequest {
    std::uint32_t body = 0xffffffff;  // a body that sleeps, with its island or in place
    double mass = 0;                  // kg of its surroundings that wake with it
    // Only its load changed: it soon sleeps again if it still rests.
    bool briefly = false;
    auto operator<=>(const WakeRequest&) const = default;
};
using WakeRequests = std::vector<WakeRequest>;

// Returns the mass that a momentum in kg m/s would move at the speed gentle_speed, kg.
inline double mass_to_wake(double momentum) {
    return momentum / tuning::gentle_speed;
}

}  // namespace jostle::physics
