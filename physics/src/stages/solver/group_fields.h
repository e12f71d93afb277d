// SPDX-License-Identifier: MIT
//
// The world's force fields as forces on the bodies of a joint group, in addition to their constant
// forces.
#pragma once

#include <vector>

#include "physics/src/stages/solver/joint_group_scratch.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

class GroupFields final : public ExternalForces {
public:
    // Create before the group's step. Saves the constant forces if there are fields.
    GroupFields(const WorldState& world, const JointGroup& group);
    // Returns whether a field may reach a body of the group within dt.
    bool reach(double dt) const;
    void push(std::vector<DirectBody>& bodies, double from, double h, double lookahead) override;

private:
    const WorldState& world_;
    const JointGroup& group_;
    std::vector<Vec3> constant_;  // force and torque of each body
};

}  // namespace jostle::physics
