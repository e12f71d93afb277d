// SPDX-License-Identifier: MIT
//
// The newest actions of each client that it can revert, with what it takes to revert them. Part of
// the state of the world: it is saved with it and replayed with the journal. Owned by HostedWorld;
// one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jostle/physics/ids.h"
#include "server/world/command.h"

namespace jostle::server {

// Fields that an EditCommand sets, as bits.
using EditFields = std::uint32_t;
inline constexpr EditFields edit_position = 1, edit_rotation = 2, edit_linear_velocity = 4,
                            edit_angular_velocity = 8, edit_mass = 16, edit_density = 32,
                            edit_friction = 64, edit_restitution = 128, edit_color = 256,
                            edit_frozen = 512, edit_gravity_scale = 1024;

struct UndoStep {
    enum class Kind : std::uint8_t {
        spawned,        // entities: removed by the undo
        deleted,        // entities: one, which record and joints create again
        edited,         // entities: one, whose `fields` return to those of the record
        joint_created,  // joint: removed by the undo
        joint_deleted,  // joints: one, which its record creates again
    };
    struct Joint {
        EntityId entity_a = 0, entity_b = 0;  // entity_a 0: the world
        ClientId owner = scene_client;
        std::string record = {};  // body_record.h
    };

    Kind kind = Kind::spawned;
    std::vector<EntityId> entities = {};
    physics::JointId joint = {};
    EditFields fields = 0;
    std::string record = {};  // body_record.h
    ClientId owner = scene_client;
    std::optional<std::uint32_t> color = {};
    std::string name = {};
    bool frozen = false;
    std::vector<Joint> joints = {};
};

class UndoLog {
public:
    static constexpr std::size_t steps_max = 32;  // of each client

    void add(ClientId client, UndoStep step) {
        std::deque<UndoStep>& steps = steps_[client];
        if (steps.size() == steps_max) steps.pop_front();
        steps.push_back(std::move(step));
    }
    // Null: the client has no action to revert.
    const UndoStep* newest(ClientId client) const {
        const auto at = steps_.find(client);
        return at == steps_.end() || at->second.empty() ? nullptr : &at->second.back();
    }
    // newest() is not null.
    UndoStep take(ClientId client) {
        std::deque<UndoStep>& steps = steps_.at(client);
        UndoStep step = std::move(steps.back());
        steps.pop_back();
        if (steps.empty()) steps_.erase(client);
        return step;
    }
    // A deleted entity exists again under another id.
    void replace(EntityId before, EntityId now) {
        for (auto& [client, steps] : steps_)
            for (UndoStep& step : steps) {
                for (EntityId& entity : step.entities)
                    if (entity == before) entity = now;
                for (UndoStep::Joint& joint : step.joints) {
                    if (joint.entity_a == before) joint.entity_a = now;
                    if (joint.entity_b == before) joint.entity_b = now;
                }
            }
    }
    void replace(physics::JointId before, physics::JointId now) {
        for (auto& [client, steps] : steps_)
            for (UndoStep& step : steps)
                if (step.joint == before) step.joint = now;
    }
    void forget(ClientId client) { steps_.erase(client); }

    const std::map<ClientId, std::deque<UndoStep>>& all() const { return steps_; }
    void restore(std::map<ClientId, std::deque<UndoStep>> steps) { steps_ = std::move(steps); }

private:
    std::map<ClientId, std::deque<UndoStep>> steps_;  // oldest first
};

}  // namespace jostle::server
