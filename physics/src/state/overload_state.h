// SPDX-License-Identifier: MIT
//
// Overload level of a world with a step budget (WorldDef::step_budget): the measures that reduce
// the work of a step. Each level includes the previous ones. The level is part of the state. It
// changes after a step, depending on the counted work of that step, never on a clock
// (stages/update_step_budget.h). Without a budget it is 0 and has no effect.
#pragma once

#include <cstdint>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"

namespace jostle::physics {

struct OverloadState {
    std::uint8_t level = 0;  // 0 to max_overload_level
    std::uint8_t easy = 0;   // consecutive steps cheap enough for the next lower level
};

// Level 1: manifolds are reused over more motion.
inline bool reuses_manifolds_longer(const OverloadState& overload_level) {
    ASSERT(overload_level.level <= max_overload_level);
    return overload_level.level >= 1;
}
// Level 2: impacts between moving bodies are left to the contact solver. Sweeps against static and
// kinematic bodies remain, so no body passes through them.
inline bool leaves_impacts_to_contacts(const OverloadState& overload_level) {
    return overload_level.level >= 2;
}
// Level 3: islands take half of their sub-steps if that leaves at least two; slender, tall and
// heavily loaded islands, which would collapse, are exempt.
inline bool halves_substeps(const OverloadState& overload_level) {
    return overload_level.level >= 3;
}

}  // namespace jostle::physics
