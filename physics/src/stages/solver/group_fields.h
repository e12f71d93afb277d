// SPDX-License-Identifier: MIT
//
// The world's force fields as forces on the bodies of a joint group, beside the constant ones that
// these have.
#pragma once

#include <vector>

#include "physics/src/stages/solver/joint_group_scratch.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

class GroupFields final : public ExternalForces {
public:
    // Before the group's step: remembers the constant forces if there are fields.
    GroupFields(const WorldState& world, const JointGroup& group);
    // Whether one may reach a body of the group within dt.
    bool reach(double dt) const;
    void push(std::vector<DirectBody>& bodies, double from, double h, double lookahead) override;

private:
    const WorldState& world_;
    const JointGroup& group_;
    std::vector<Vec3> constant_;  // force, torque of each body
};

}  // namespace jostle::physics
