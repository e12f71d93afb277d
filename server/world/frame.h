// SPDX-License-Identifier: MIT
//
// The only way out of a world: an immutable copy of what clients may see, made once per tick and
// shared.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "jostle/physics/world.h"
#include "server/util/clock.h"
#include "server/world/command.h"
#include "server/world/module_channels.h"
#include "server/world/pose_list.h"
#include "server/world/tick_events.h"

namespace jostle::server {

// What an entity is: said once, when it appears.
struct EntityDescription {
    EntityId id = 0;
    physics::BodyType type = physics::BodyType::dynamic;
    std::vector<physics::ShapeState> shapes;
    ClientId owner = 0;
    std::optional<std::uint32_t> color;
    std::string name;
    double mass = 0;            // kg
    bool controllable = false;  // a module lets somebody drive it
    bool jointed = false;
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    physics::AxisLocks locks = 0;
    double bounding_radius = 0;  // m from its origin to its furthest corner; infinite for planes
};

// In rising order of id. A new one is made only when something appears or goes, so equal pointers
// mean equal entity lists.
using EntityList = std::vector<std::shared_ptr<const EntityDescription>>;

// What somebody drives, as jostle/modules/controlled_entity_state.h tells it.
struct ControlledEntityState {
    ClientId client = 0;
    EntityId entity = 0;
    std::string module;  // its tag
    std::vector<std::uint32_t> words;
};

struct Frame {
    std::uint32_t tick = 0;  // from 1
    Clock::time_point due;   // when the tick was due
    // The same beside the world's epoch and the tick's number: how much was left out since.
    std::int64_t late_us = 0;
    PoseList entities;  // as in the entity list
    // The newest tick, this one included, in which a client could see something change: a pose, who
    // is awake, the entity list, a channel. And the newest one before that, as of the tick before:
    // until then what the frame before shows was as it is there.
    std::uint32_t changed_at = 0, previous_changed_at = 0;
    std::shared_ptr<const EntityList> entity_list;
    // Never null; empty unless a client asked for events.
    std::shared_ptr<const RecentEvents> events;
    // What modules tell clients; null: nothing. One that says the same as in the frame before has
    // the same values.
    std::shared_ptr<const Channels> channels;
    // Of this tick, while a client is there who simulates; null: nothing is driven.
    std::shared_ptr<const std::vector<ControlledEntityState>> controlled_entities;
    int awake = 0, contacts = 0;
    double step_ms = 0;                        // of this tick: the solver alone
    double tick_ms_mean = 0, tick_ms_max = 0;  // of whole ticks, over the last second
    std::optional<std::string> paused;         // why the world does not step
    std::uint32_t late_ticks = 0;              // since the world began
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace jostle::server
