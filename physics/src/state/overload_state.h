// SPDX-License-Identifier: MIT
//
// What a world with a budget for its step (WorldDef::step_budget) leaves out while its steps cost
// more: the order is that of the levels, and each includes those before it. The level is part of
// the state; it changes after a step by what that step did, counted, never by a clock
// (stages/update_step_budget.h). Without a budget it is 0 and all below is as if it were not there.
#pragma once

#include <cstdint>

#include "jostle/physics/defs.h"

namespace jostle::physics {

struct OverloadState {
    std::uint8_t level = 0;  // 0 to max_overload_level
    std::uint8_t easy = 0;   // steps in a row that cost so little that the next level down may do
};

// Level 1: manifolds are used again over more motion.
inline bool reuses_manifolds_longer(const OverloadState& overload_level) {
    return overload_level.level >= 1;
}
// Level 2: what moves passes its impacts on what moves to the contact solver. Sweeps against static
// and kinematic bodies stay: nothing passes through the scenery.
inline bool leaves_impacts_to_contacts(const OverloadState& overload_level) {
    return overload_level.level >= 2;
}
// Level 3: islands take half of their sub-steps, where that leaves two; not what is slender, tall
// or heavily loaded, which would fall.
inline bool halves_substeps(const OverloadState& overload_level) {
    return overload_level.level >= 3;
}

}  // namespace jostle::physics
