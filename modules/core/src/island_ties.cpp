// SPDX-License-Identifier: MIT
#include "jostle/modules/island_ties.h"

#include <algorithm>

#include "jostle/modules/island_coupling.h"

namespace jostle::modules {

using namespace physics;

void IslandTies::release(World& world) {
    // Loaded ids are untrusted: they may be those of other joints.
    for (const JointId tie : ties_)
        if (const Result<JointState> joint = world.joint(tie);
            joint.ok() && is_island_coupling(joint->def.kind))
            static_cast<void>(world.destroy_joint(tie));
    ties_.clear();
    bodies_.clear();
}

Status IslandTies::update(World& world, std::span<const BodyId> bodies) {
    const auto holds = [&](JointId tie) { return world.contains(tie); };
    if (std::ranges::equal(bodies, bodies_) && std::ranges::all_of(ties_, holds)) return {};
    release(world);
    bodies_.assign(bodies.begin(), bodies.end());
    for (std::size_t k = bodies.size() == 1 ? 0 : 1; k < bodies.size(); k++) {
        const BodyId before = k == 0 ? BodyId{} : bodies[k - 1];
        const Result<JointId> tie = create_island_coupling(world, before, bodies[k]);
        if (!tie.ok()) {
            release(world);
            return tie.error();
        }
        ties_.push_back(*tie);
    }
    return {};
}

bool IslandTies::owned_by(const SubstepContext& substep) const {
    return !bodies_.empty() && substep.contains(bodies_.front());
}

void IslandTies::visit(StateVisitor& v) {
    v.all("bodies", bodies_, [&](BodyId& body) { v.field("body", body); });
    v.all("ties", ties_, [&](JointId& tie) { v.field("tie", tie); });
}

}  // namespace jostle::modules
