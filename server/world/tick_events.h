// SPDX-License-Identifier: MIT
//
// The events of one tick between entities: an immutable copy of the world's events, made only while
// a client subscribes to events. Each list is sorted by entity. Two entities that touch with
// several shapes are listed once per shape pair.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "jostle/physics/events.h"
#include "server/world/command.h"

namespace jostle::server {

struct ContactEvent {
    EntityId a = 0, b = 0;
    physics::Vec3 point, normal;  // m, world; unit, from a to b. Not set for contacts_ended
    double speed = 0;             // m/s, approach speed; only contacts_began and hits
    double impulse = 0;           // N s over the tick; only contacts
};

struct TriggerEvent {
    EntityId trigger = 0, entity = 0;
};

struct JointBreakEvent {
    EntityId a = 0, b = 0;
    double force = 0, torque = 0;  // N, N m
};

// The names equal those of physics::Events and of the Events message. A new kind needs a list here,
// a row in tick_events.cpp and a row in messages/event_message.cpp.
struct TickEvents {
    static constexpr std::size_t kinds = 10;

    std::uint32_t tick = 0;
    std::vector<ContactEvent> contacts_began, contacts_ended, contacts, hits;
    std::vector<TriggerEvent> triggers_entered, triggers_stayed, triggers_left;
    std::vector<JointBreakEvent> joints_broke;
    std::vector<EntityId> fell_asleep, woke;
};

// The newest ticks with events, oldest first. `count` is the number of ticks with events since the
// start of the world and the number of ticks.back(), so a reader can compute how many it missed.
struct RecentEvents {
    static constexpr std::size_t ticks_max = 64;

    std::uint32_t count = 0;
    std::vector<std::shared_ptr<const TickEvents>> ticks;
};

using EntityOfBody = std::function<EntityId(physics::BodyId)>;

// Nothing: the step had no events. Quarantined bodies are not copied; they are logged for
// operators.
std::optional<TickEvents> copy_events(const physics::Events& events, std::uint32_t tick,
                                      const EntityOfBody& entity_of);

}  // namespace jostle::server
