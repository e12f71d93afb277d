// SPDX-License-Identifier: MIT
#include "server/world/ownership.h"

namespace jostle::server {

void Ownership::remove(EntityId entity) {
    for (auto& [client, entities] : owned_)
        if (entities.erase(entity) > 0) return;
}

bool Ownership::owns(ClientId client, EntityId entity) const {
    const auto at = owned_.find(client);
    return at != owned_.end() && at->second.contains(entity);
}

int Ownership::count(ClientId client) const {
    const auto at = owned_.find(client);
    return at == owned_.end() ? 0 : static_cast<int>(at->second.size());
}

std::vector<EntityId> Ownership::owned_by(ClientId client) const {
    const auto at = owned_.find(client);
    if (at == owned_.end()) return {};
    return {at->second.begin(), at->second.end()};
}

void Ownership::write(SavedHostState& host_state) const {
    for (const auto& [client, entities] : owned_)
        for (const EntityId entity : entities) host_state.owned.push_back({client, entity});
}

void Ownership::restore(const SavedHostState& host_state) {
    for (const SavedHostState::Owned& owned : host_state.owned) add(owned.client, owned.entity);
}

}  // namespace jostle::server
