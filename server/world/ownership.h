// SPDX-License-Identifier: MIT
//
// The entities that each client owns: it spawned them and may delete them. Entities of the scene
// have no owner. Owned by HostedWorld; one thread.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "server/world/command.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class Ownership {
public:
    void add(ClientId client, EntityId entity) { owned_[client].insert(entity); }
    // The entity was removed; it may have no owner.
    void remove(EntityId entity);
    // The client left; its remaining entities have no owner.
    void forget(ClientId client) { owned_.erase(client); }

    bool owns(ClientId client, EntityId entity) const;
    int count(ClientId client) const;
    std::vector<EntityId> owned_by(ClientId client) const;  // ascending

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    std::map<ClientId, std::set<EntityId>> owned_;
};

}  // namespace jostle::server
