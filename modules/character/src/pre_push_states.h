// SPDX-License-Identifier: MIT
//
// States of bodies before they were pushed in this step. Other bodies may block a pushed body, so
// its actual motion is known only after the world has stepped.
#pragma once

#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::character_detail {

class PrePushStates {
public:
    // Call before the first push.
    void store(const physics::World& world, physics::BodyId id);
    // Returns the stored state; the current state of a body that was not stored.
    physics::Result<physics::BodyState> of(const physics::World& world, physics::BodyId id) const;

private:
    std::vector<physics::BodyState> bodies_;  // only dynamic bodies
};

}  // namespace jostle::modules::character_detail
