// SPDX-License-Identifier: MIT
//
// How bodies moved before they were pushed in this step. What was pushed may be held by others: how
// it moves is sure only when the world has stepped.
#pragma once

#include <vector>

#include "jostle/physics/world.h"

namespace jostle::modules::character_detail {

class PrePushStates {
public:
    // Before the first push.
    void store(const physics::World& world, physics::BodyId id);
    // As remembered; of others as they are.
    physics::Result<physics::BodyState> of(const physics::World& world, physics::BodyId id) const;

private:
    std::vector<physics::BodyState> bodies_;  // dynamic ones
};

}  // namespace jostle::modules::character_detail
