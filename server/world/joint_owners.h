// SPDX-License-Identifier: MIT
//
// The joints that clients created and the client that owns each of them. Joints that ended with a
// body or broke do not count. Owned by HostedWorld; one thread.
#pragma once

#include <map>

#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class JointOwners {
public:
    void add(physics::JointId joint, ClientId client) { owners_[joint] = client; }
    void remove(physics::JointId joint) { owners_.erase(joint); }
    // The client left; its joints have no owner from now on.
    void forget(ClientId client) {
        std::erase_if(owners_, [&](const auto& entry) { return entry.second == client; });
    }
    // Forgets the joints that do not exist any more.
    void remove_ended(const physics::World& world) {
        std::erase_if(owners_, [&](const auto& entry) { return !world.contains(entry.first); });
    }
    // scene_client: no client owns it.
    ClientId owner_of(physics::JointId joint) const {
        const auto at = owners_.find(joint);
        return at == owners_.end() ? scene_client : at->second;
    }
    int count(const physics::World& world, ClientId client) const {
        int count = 0;
        for (const auto& [joint, owner] : owners_)
            if (owner == client && world.contains(joint)) count++;
        return count;
    }

    void write(const physics::World& world, SavedHostState& host_state) const {
        for (const auto& [joint, client] : owners_)
            if (world.contains(joint)) host_state.owned_joints.push_back({client, joint});
    }
    void restore(const SavedHostState& host_state) {
        for (const SavedHostState::OwnedJoint& owned : host_state.owned_joints)
            add(owned.joint, owned.client);
    }

private:
    std::map<physics::JointId, ClientId> owners_;
};

}  // namespace jostle::server
