// SPDX-License-Identifier: MIT
//
// Which client owns which entities: what it spawned, and may delete. The scene's belong to nobody.
// Owned by HostedWorld; one thread.
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
    // The entity is gone. One that nobody owns is fine.
    void remove(EntityId entity);
    // The client is gone: what it still owned is nobody's.
    void forget(ClientId client) { owned_.erase(client); }

    bool owns(ClientId client, EntityId entity) const;
    int count(ClientId client) const;
    std::vector<EntityId> owned_by(ClientId client) const;  // in rising order

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    std::map<ClientId, std::set<EntityId>> owned_;
};

}  // namespace jostle::server
