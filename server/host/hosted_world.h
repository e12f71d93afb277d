// SPDX-License-Identifier: MIT
//
// A world with its entities, owners and hands: the only place where a command becomes a World call,
// and where a frame is copied from a world. Owned by one thread (host/world_host).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "host/command.h"
#include "host/drag_spring.h"
#include "host/frame.h"
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
    struct Entity {
        EntityId id = 0;
        physics::BodyId body;
        ClientId owner = 0;
        std::shared_ptr<const EntityDescription> description;
    };
    struct Client {
        std::uint32_t last_sequence = 0;
        int bodies = 0;
        std::optional<DragSpring> hand;
    };

    HostedWorld(physics::World world, const HostLimits& limits)
        : world_(std::move(world)), limits_(limits) {}

    EntityId add(physics::BodyId body, ClientId owner, std::optional<std::uint32_t> color,
                 std::string name);
    void remove(EntityId id);
    // Of a body that lives, or that was removed since the step before the last.
    EntityId entity_of(physics::BodyId body) const;
    const std::shared_ptr<const EntityList>& entity_list();
    // Never null.
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
    EntityId next_id_ = 1;
    std::map<EntityId, Entity> entities_;   // ordered: frames list entities by id
    std::vector<EntityId> entity_of_body_;  // by body index; 0: none
    // Bodies that were removed since the last step, and those that the last step's events may still
    // name.
    std::map<physics::BodyId, EntityId> removed_, removed_before_step_;
    std::set<EntityId> quarantined_;                 // told
    std::map<ClientId, Client> clients_;             // ordered: hands pull in order of client
    std::shared_ptr<const EntityList> entity_list_;  // null: changed since the last frame
    std::shared_ptr<const ShapePlaces> places_;      // of that entity list; null: not asked for yet
    std::vector<physics::BodyState> bodies_;         // reused by copy_into
};

}  // namespace jostle::server
