// SPDX-License-Identifier: MIT
#include "server/world/sync_module_entities.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

using namespace physics;

namespace {

void forget_removed(HostedState& state) {
    std::vector<EntityId> removed;
    for (const auto& [id, entity] : state.entities.all())
        if (!state.world.contains(entity.body)) removed.push_back(id);
    for (const EntityId id : removed) forget_entity(state, id);
}

}  // namespace

void sync_module_entities(HostedState& state, std::vector<BodyState>& bodies) {
    if (state.world.modules().empty()) return;
    state.world.copy_bodies(bodies);
    const auto is_known = [&](const BodyState& body) {
        return state.entities.find_living(body.id) != 0;
    };
    const auto known = static_cast<std::size_t>(std::ranges::count_if(bodies, is_known));
    // Before the additions, because a new body may reuse the index of a removed one.
    ASSERT(known <= bodies.size() && known <= state.entities.size());
    if (known < state.entities.size()) forget_removed(state);
    if (known == bodies.size()) return;
    for (const BodyState& body : bodies)
        if (!is_known(body)) state.entities.add(state.world, body.id, 0, std::nullopt, {});
    ASSERT(state.entities.size() == bodies.size());
}

}  // namespace jostle::server
