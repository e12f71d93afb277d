// SPDX-License-Identifier: MIT
//
// The state of a hosted world beyond its bodies: entities, owners, grabs, controlled entities,
// players, attributes and the last sequence number of each client. Together with the saved world it
// determines the next tick, except for inputs that were not applied yet.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/ids.h"
#include "server/world/attribute.h"
#include "server/world/command.h"
#include "server/world/room_state.h"
#include "server/world/undo_log.h"

namespace jostle::server {

struct SavedHostState {
    struct Entity {
        EntityId id = 0;
        physics::BodyId body;
        ClientId owner = 0;
        std::optional<std::uint32_t> color;
        std::string name;
        double mass = 0, bounding_radius = 0;  // as in its EntityDescription
    };
    struct Held {
        ClientId client = 0;
        physics::BodyId body;
        physics::JointId joint;
    };
    struct Controlled {
        ClientId client = 0;
        physics::BodyId body;
    };
    struct Owned {
        ClientId client = 0;
        EntityId entity = 0;
    };
    struct ProcessedInput {
        ClientId client = 0;
        std::uint32_t sequence = 0;
    };

    struct SavedPlayer {
        ClientId client = 0;
        std::string name;
        std::uint32_t role = 0;  // PlayerRole
        std::optional<std::uint32_t> color;
        std::uint32_t connected = 0;  // 1: connected
        std::uint32_t joined_tick = 0;
    };
    struct SavedAttribute {
        AttributeTarget target;
        ClientId owner = 0;  // of the target
        std::string key;
        Attribute attribute;
    };
    // An entity whose properties an edit changed.
    struct Updated {
        EntityId entity = 0;
        std::uint32_t revision = 0;
        std::uint32_t frozen = 0;  // 1: frozen
    };
    struct OwnedJoint {
        ClientId client = 0;
        physics::JointId joint;
    };
    struct ClientUndo {
        ClientId client = 0;
        std::vector<UndoStep> steps;  // oldest first
    };

    std::uint32_t tick = 0;
    EntityId next_id = 1;
    std::vector<Entity> entities;  // in ascending order of id
    std::vector<Owned> owned;
    std::vector<Held> held;
    std::vector<Controlled> controlled_entities;
    std::vector<ProcessedInput> processed;
    std::vector<EntityId> quarantined;
    std::vector<physics::BodyId> scene_bodies;
    std::vector<physics::JointId> scene_joints;
    std::vector<SavedPlayer> players;            // in ascending order of client
    std::vector<SavedAttribute> attributes;      // in ascending order of target and key
    std::uint32_t messages = 0;                  // number of user messages
    std::optional<RoomState> room = {};          // nothing: the world is no room
    std::uint32_t revisions = 0;                 // number of updates of entities
    std::vector<Updated> updated_entities = {};  // in ascending order of id
    std::vector<OwnedJoint> owned_joints = {};
    std::vector<ClientUndo> undo = {};  // in ascending order of client

    // Whether clients edited bodies, made joints or have actions to undo.
    bool has_edits() const { return revisions != 0 || !owned_joints.empty() || !undo.empty(); }
};

// The clients of the world, each with the sequence number of its last processed input (0: none).
std::map<ClientId, std::uint32_t> clients_of(const SavedHostState& host_state);

// A hash of the players, the attributes, the number of messages, the room and the edits.
std::uint64_t data_hash(const SavedHostState& host_state);

// A world without players, attributes and messages is encoded as earlier versions did.
std::string encode_host_state(const SavedHostState& host_state);
// corrupt_data: the bytes are not an encoded host state. failed_precondition: they have a version
// that this server does not read.
Result<SavedHostState> decode_host_state(std::string_view bytes);

}  // namespace jostle::server
