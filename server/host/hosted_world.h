// SPDX-License-Identifier: MIT
//
// A world with its entities, their owners and who holds what: the only place where a command
// becomes a World call, and where a frame is copied from a world. Owned by one thread
// (host/world_host).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "host/command.h"
#include "host/entity_registry.h"
#include "host/frame.h"
#include "host/grabs.h"
#include "host/ownership.h"
#include "host/query_frame.h"
#include "jostle/scenes/scene.h"

namespace jostle::server {

struct HostLimits {
    int bodies_max = 20000;     // of the whole world
    int bodies_owned_max = 50;  // of one client
};

class HostedWorld {
public:
    static Result<HostedWorld> create(const scenes::SceneDescription& scene,
                                      const HostLimits& limits, int threads);

    // Applies an input at most once: a sequence that is not above the client's last one is refused.
    InputResult apply(const Command& command, std::uint32_t tick);
    // Pulls what is held, then steps.
    Status step(double dt);
    // Fills what a world knows of a frame; the host adds times.
    void copy_into(Frame& frame);
    // What happened in the last step; nothing when nothing did. Before the next command.
    std::optional<TickEvents> events_of_step(std::uint32_t tick) const;
    // Those whose state stopped being a number in the last step and that were not told before.
    std::vector<std::shared_ptr<const EntityDescription>> newly_quarantined();
    QueryFramePtr query_frame(std::uint32_t tick, CopyParts parts);

    const physics::World& world() const { return world_; }

private:
    HostedWorld(physics::World world, const HostLimits& limits)
        : world_(std::move(world)), limits_(limits) {}

    Status accept_sequence(ClientId client, std::uint32_t sequence);
    void remove(EntityId id);
    // Never null; an error says why it cannot be moved.
    Result<const Entity*> dynamic_entity(EntityId id) const;

    // `about` becomes the entity that the input is about, also when it is refused.
    Status apply_action(const SpawnCommand& c, ClientId client, EntityId& about);
    Status apply_action(const ImpulseCommand& c, ClientId client, EntityId& about);
    Status apply_action(const GrabCommand& c, ClientId client, EntityId& about);
    Status apply_action(const DragCommand& c, ClientId client, EntityId& about);
    Status apply_action(const ReleaseCommand& c, ClientId client, EntityId& about);
    Status apply_action(const DeleteCommand& c, ClientId client, EntityId& about);
    Status apply_action(const ExplodeCommand& c, ClientId client, EntityId& about);
    Status apply_action(const LeaveCommand& c, ClientId client, EntityId& about);

    physics::World world_;
    HostLimits limits_;
    EntityRegistry entities_;
    Ownership ownership_;
    Grabs grabs_;
    std::map<ClientId, std::uint32_t> last_sequences_;  // of the inputs of each client
    std::set<EntityId> quarantined_;                    // told
    std::vector<physics::BodyState> bodies_;            // reused by copy_into
};

}  // namespace jostle::server
