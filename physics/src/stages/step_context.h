// SPDX-License-Identifier: MIT
//
// What every stage of one step shares; made anew each step.
#pragma once

#include "constraints/contact_settings.h"
#include "state/world_state.h"

namespace jostle::physics {

struct StepContext {
    WorldState& world;
    TaskTeam& team;
    double dt = 0;  // s
    ContactSettings contacts;
};

}  // namespace jostle::physics
