// SPDX-License-Identifier: MIT
//
// Who drives what: at most one body a client, and one client a body. What a driver holds is the
// state of the body's module. Owned by HostedWorld; one thread.
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
    // Lets go of what the client drove. Refused: no module lets anybody drive the body
    // (permission_denied), or somebody else does.
    Status possess(physics::World& world, ClientId client, physics::BodyId body);
    // The body that follows; nothing when the client drives none.
    std::optional<physics::BodyId> control(physics::World& world, ClientId client,
                                           const physics::Controls& controls);
    // The body's controls are as if nobody held them.
    void release(physics::World& world, ClientId client);
    void release_body(physics::World& world, physics::BodyId body);

    // What is driven, for clients that foresee it.
    std::vector<ControlledEntityState> controlled_states(
        physics::World& world, const modules::BodyNameLookup& name_of) const;

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    std::map<ClientId, physics::BodyId> controlled_;
};

// The module that lets somebody drive the body; null: none.
physics::Module* controlling_module(physics::World& world, physics::BodyId body);
bool is_controllable(const physics::World& world, physics::BodyId body);

}  // namespace jostle::server
