// SPDX-License-Identifier: MIT
//
// Who holds what: at most one body a client, by a joint that pulls it as a hand would. Owned by
// HostedWorld; one thread. The joints are the world's, so they are part of its state.
#pragma once

#include <map>
#include <optional>

#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class Grabs {
public:
    // Takes hold of the body, which is dynamic, at a point of the world, and lets go of what the
    // client held.
    physics::Status grab(physics::World& world, ClientId client, const physics::BodyState& body,
                         physics::Vec3 point);
    // Pulls what is held towards a point of the world. The body; nothing when nothing is held.
    std::optional<physics::BodyId> drag(physics::World& world, ClientId client,
                                        physics::Vec3 target);
    void release(physics::World& world, ClientId client);
    // Everyone lets go of the body.
    void release_body(physics::World& world, physics::BodyId body);

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    struct Held {
        physics::BodyId body;
        physics::JointId joint;
    };
    std::map<ClientId, Held> held_;
};

}  // namespace jostle::server
