// SPDX-License-Identifier: MIT
//
// The place of a deformable, such as a rope, in the islands of a world. All bodies that a
// deformable may push are tied to each other, so they are in one island: one group of
// SubstepContext contains all of them and owns the deformable, also if groups run concurrently, and
// the bodies fall asleep and wake together. The ties apply no force (island_coupling.h).
#pragma once

#include <span>
#include <vector>

#include "jostle/physics/state_visitor.h"
#include "jostle/physics/step_listener.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Ties of one deformable. Belongs to the state of its module.
class IslandTies {
public:
    /// Ties these bodies (sorted by id, each once, dynamic) and releases all others. A single body
    /// is tied to the world, so that the solver moves it: the group then shows its position at the
    /// start of each sub-step. Changes the world only if the bodies differ from the last call or a
    /// tie has ended. Call between steps or in before_step(). Errors are those of create_joint().
    physics::Status update(physics::World& world, std::span<const physics::BodyId> bodies);
    /// Releases all bodies.
    void release(physics::World& world);
    /// The tied bodies, sorted by id.
    std::span<const physics::BodyId> bodies() const { return bodies_; }
    /// Returns whether the group owns the deformable. False without bodies.
    bool owned_by(const physics::SubstepContext& substep) const;

    void visit(physics::StateVisitor& v);

private:
    std::vector<physics::BodyId> bodies_;
    std::vector<physics::JointId> ties_;
};

}  // namespace jostle::modules
