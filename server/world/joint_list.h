// SPDX-License-Identifier: MIT
//
// The joints of a world that clients can show. Owned by HostedWorld; one thread.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "jostle/physics/world.h"
#include "server/world/command.h"

namespace jostle::server {

// The constant properties of a joint, as of its appearance.
struct JointDescription {
    std::uint32_t id = 0;                 // never reused by the registry
    EntityId entity_a = 0, entity_b = 0;  // entity_a 0: the world
    physics::JointDef def;
};

// In ascending order of id. A new list is made only when a joint appears or disappears, so equal
// pointers mean equal lists. Lists of one registry share the descriptions of the same joints.
using JointList = std::vector<std::shared_ptr<const JointDescription>>;

class JointRegistry {
public:
    using FindEntity = std::function<EntityId(physics::BodyId)>;  // 0: not found

    // The list of a world, without grabs and velocity rows, which have no shape, and without joints
    // of bodies that are no entities. Takes no time while no joint is created or destroyed.
    const std::shared_ptr<const JointList>& list(const physics::World& world,
                                                 const FindEntity& find_entity);

private:
    std::uint32_t next_id_ = 1;
    std::map<physics::JointId, std::shared_ptr<const JointDescription>> known_;
    std::shared_ptr<const JointList> list_;  // null: not made yet
    std::uint64_t revision_ = 0;             // of the world when list_ was made
};

}  // namespace jostle::server
