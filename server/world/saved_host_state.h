// SPDX-License-Identifier: MIT
//
// What a hosted world is beside its bodies: who is which entity, who owns, holds and drives what,
// and how far each client's inputs have been counted. With the world's own bytes it is all that the
// next tick depends on, but for inputs that have not been applied.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/ids.h"
#include "server/world/command.h"

namespace jostle::server {

struct SavedHostState {
    struct Entity {
        EntityId id = 0;
        physics::BodyId body;
        ClientId owner = 0;
        std::optional<std::uint32_t> color;
        std::string name;
        double mass = 0, bounding_radius = 0;  // as clients were told
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

    std::uint32_t tick = 0;
    EntityId next_id = 1;
    std::vector<Entity> entities;  // in rising order of id
    std::vector<Owned> owned;
    std::vector<Held> held;
    std::vector<Controlled> controlled_entities;
    std::vector<ProcessedInput> processed;
    std::vector<EntityId> quarantined;
    std::vector<physics::BodyId> scene_bodies;
    std::vector<physics::JointId> scene_joints;
};

// Who played, and the last of the inputs of each that were counted.
std::map<ClientId, std::uint32_t> clients_of(const SavedHostState& host_state);

std::string encode_host_state(const SavedHostState& host_state);
// corrupt_data: the bytes are not such an image.
Result<SavedHostState> decode_host_state(std::string_view bytes);

}  // namespace jostle::server
