// SPDX-License-Identifier: MIT
//
// Clones bodies and groups that joints connect.
#pragma once

#include <cstddef>
#include <vector>

#include "server/world/action_context.h"

namespace jostle::server {

inline constexpr std::size_t clone_bodies_max = 64;

// A body and, if `all`, the dynamic bodies that joints connect to it, with the joints between them.
// The group ends after clone_bodies_max + 1 bodies.
struct JointedGroup {
    std::vector<EntityId> entities;        // the named one, then the others in ascending order
    std::vector<physics::JointId> joints;  // sorted, without grabs
};
JointedGroup jointed_group(const HostedState& state, EntityId entity, bool all);

Status clone_bodies(const ActionContext& context, const CloneCommand& command);

}  // namespace jostle::server
