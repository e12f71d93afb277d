// SPDX-License-Identifier: MIT
//
// The grabs of clients: at most one body per client, pulled by a grab joint, or one point of a rope
// or cloth, held by a grab (jostle/modules/point_grab.h). Joints and grabs belong to the world, so
// they are part of its state. Owned by HostedWorld; one thread.
#pragma once

#include <map>
#include <optional>

#include "jostle/modules/deformables.h"
#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class Grabs {
public:
    // Grabs a dynamic body at a point in world coordinates and releases the client's previous grab.
    physics::Status grab(physics::World& world, ClientId client, const physics::BodyState& body,
                         physics::Vec3 point);
    // Sets the target of the grab in world coordinates. Returns the grabbed body; nothing if the
    // client has no grab.
    std::optional<physics::BodyId> drag(physics::World& world, ClientId client,
                                        physics::Vec3 target);
    // Grabs a node or vertex and releases the client's previous grab. Errors are those of
    // Deformables::grab(), without effect.
    physics::Status grab_deformable(physics::World& world, ClientId client,
                                    modules::Deformables& of, modules::DeformablePoint at);
    // Like drag(), for a grabbed rope or cloth. False: the client has none.
    bool drag_deformable(physics::World& world, ClientId client, physics::Vec3 target) const;
    void release(physics::World& world, ClientId client);
    // Releases the grabs of all clients on the body.
    void release_body(physics::World& world, physics::BodyId body);

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    struct Held {
        physics::BodyId body;
        physics::JointId joint;
    };
    void release_joint(physics::World& world, ClientId client);
    // `except`: keeps its grab; null: none.
    static void release_deformables(physics::World& world, ClientId client,
                                    const modules::Deformables* except);

    std::map<ClientId, Held> held_;
};

}  // namespace jostle::server
