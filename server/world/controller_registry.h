// SPDX-License-Identifier: MIT
//
// The controlled entities of clients: at most one body per client and one client per body. The
// controls themselves are state of the body's module. Owned by HostedWorld; one thread.
#pragma once

#include <map>
#include <optional>

#include "jostle/modules/controlled_entity_state.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/frame.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class ControllerRegistry {
public:
    // Releases the body that the client controlled before. permission_denied: no module controls
    // the body, or another client does.
    Status possess(physics::World& world, ClientId client, physics::BodyId body);
    // Returns the controlled body; nothing if the client controls none.
    std::optional<physics::BodyId> control(physics::World& world, ClientId client,
                                           const physics::Controls& controls);
    // Sets neutral controls and frees the body for other clients.
    void release(physics::World& world, ClientId client);
    void release_body(physics::World& world, physics::BodyId body);

    // The module state of each controlled entity, for clients that predict it.
    std::vector<ControlledEntityState> controlled_states(
        physics::World& world, const modules::BodyNameLookup& name_of) const;

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    std::map<ClientId, physics::BodyId> controlled_;
};

// The module that controls the body; null: none.
physics::Module* controlling_module(physics::World& world, physics::BodyId body);
bool is_controllable(const physics::World& world, physics::BodyId body);

}  // namespace jostle::server
