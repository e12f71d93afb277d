// SPDX-License-Identifier: MIT
//
// The complete state of one body or joint, for inspectors. Computed on the tick thread between two
// ticks, so its cost is bounded; a plain value afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/world/hosted_state.h"

namespace jostle::server {

struct JointInspection {
    std::uint32_t id = 0;                 // as clients name it
    EntityId entity_a = 0, entity_b = 0;  // entity_a 0: the world
    ClientId owner = scene_client;
    physics::JointState state;
    physics::Vec3 anchor_a = {}, anchor_b = {};  // m, world
};

struct ContactInspection {
    EntityId entity = 0;                       // the other one
    std::uint32_t shape = 0, other_shape = 0;  // index in the shapes of the entities
    physics::Vec3 normal = {};                 // from the inspected entity to the other one
    struct Point {
        physics::Vec3 point = {};
        double separation = 0, impulse = 0;  // m, N s
    };
    std::vector<Point> points = {};
};

struct BodyInspection {
    static constexpr std::size_t contacts_max = 256, joints_max = 64, island_bodies_max = 1024;

    std::shared_ptr<const EntityDescription> description;
    physics::BodyState state;
    physics::BodyDef definition;
    std::vector<ContactInspection> contacts = {};
    std::size_t contact_count = 0;
    std::vector<JointInspection> joints = {};
    std::size_t joint_count = 0;
    EntityId island = 0;            // the lowest entity of the island; 0: not dynamic
    std::size_t island_bodies = 0;  // at most island_bodies_max are counted
};

// The id by which clients name a joint.
using JointNames = std::function<std::uint32_t(physics::JointId)>;

// not_found: no such entity, or no such joint.
Result<BodyInspection> inspect_body(const HostedState& state, EntityId entity,
                                    const JointNames& name_of);
Result<JointInspection> inspect_joint(const HostedState& state, physics::JointId joint,
                                      const JointNames& name_of);

}  // namespace jostle::server
