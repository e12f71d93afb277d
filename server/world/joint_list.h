// SPDX-License-Identifier: MIT
//
// The joints of a world that clients can show. Owned by HostedWorld; one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
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
    physics::JointId joint = {};  // in the world
};

// In ascending order of id. A new list is made only when a joint appears or disappears, so equal
// pointers mean equal lists. Lists of one registry share the descriptions of the same joints.
using JointList = std::vector<std::shared_ptr<const JointDescription>>;

class JointRegistry {
public:
    // The joints that one call describes at most. A world of 200,000 joints is listed over 49
    // ticks, because describing a joint takes about 1 us and must not delay a tick.
    static constexpr std::size_t described_per_call_max = 4096;

    using FindEntity = std::function<EntityId(physics::BodyId)>;  // 0: not found

    // The list of a world, without grabs and velocity rows, which have no shape, and without joints
    // of bodies that are no entities. Call once per tick: joints beyond described_per_call_max
    // follow in the next call. Takes no time while no joint is created or destroyed.
    const std::shared_ptr<const JointList>& list(const physics::World& world,
                                                 const FindEntity& find_entity);

    // The id of a joint of the world in lists, also of one that no list contains yet.
    std::uint32_t id_of(physics::JointId joint);
    // The joint with an id, which may have ended; null: there was none. Linear in the joints.
    physics::JointId find(std::uint32_t id) const;

private:
    struct Slot {
        bool known = false;  // a joint of this generation was described, or is not listed
        std::uint32_t generation = 0;
        std::uint32_t id = 0;                           // 0: none yet
        const JointDescription* description = nullptr;  // in list_; null: not listed
    };
    // Forgets the joint of a slot; returns whether it was listed.
    static bool forget(Slot& slot);
    // Makes the slot that of the joint; returns whether an earlier joint was listed.
    static bool assign(Slot& slot, physics::JointId joint);

    std::uint32_t next_id_ = 1;
    std::vector<Slot> slots_;                // by JointId::index
    std::shared_ptr<const JointList> list_;  // null: not made yet
    std::uint64_t revision_ = 0;             // of the world when list_ was made
    bool incomplete_ = false;                // joints follow in the next call
    bool has_removed_ = false;               // list_ has joints whose slots were reused
};

}  // namespace jostle::server
