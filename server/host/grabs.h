// SPDX-License-Identifier: MIT
//
// Who holds what: at most one body a client, by a drag spring that pulls before each step. Owned by
// HostedWorld; one thread.
#pragma once

#include <map>
#include <optional>

#include "host/command.h"
#include "host/drag_spring.h"

namespace jostle::server {

class Grabs {
public:
    // Takes hold of the body at a point of the world, and lets go of what the client held.
    void grab(ClientId client, const physics::BodyState& body, physics::Vec3 point);
    // Pulls what is held towards a point of the world. The body; nothing when nothing is held.
    std::optional<physics::BodyId> drag(ClientId client, physics::Vec3 target);
    void release(ClientId client) { springs_.erase(client); }
    // The body is gone: everyone lets go of it.
    void release_body(physics::BodyId body);

    // One tick's pull at everything that is held, in order of client.
    void pull_all(physics::World& world, double dt);

private:
    std::map<ClientId, DragSpring> springs_;
};

}  // namespace jostle::server
