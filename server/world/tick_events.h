// SPDX-License-Identifier: MIT
//
// What happened in one tick, between entities: an immutable copy of the world's events, made only
// while a client of that world asks for them. Each list is sorted by the entities. A pair of
// entities that touches with several shapes is listed once per pair of shapes.
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
    physics::Vec3 point, normal;  // m, world; unit, from a to b. Not of ends
    double speed = 0;             // m/s of approach: of begins and hits
    double impulse = 0;           // N s over the tick: of contacts that press
};

struct TriggerEvent {
    EntityId trigger = 0, entity = 0;
};

struct JointBreakEvent {
    EntityId a = 0, b = 0;
    double force = 0, torque = 0;  // N, N m
};

// The names are those of physics::Events and of the Events message. A new kind is a list here, a
// row in tick_events.cpp and a row in protocol/event_message.cpp.
struct TickEvents {
    static constexpr std::size_t kinds = 10;

    std::uint32_t tick = 0;
    std::vector<ContactEvent> contacts_began, contacts_ended, contacts, hits;
    std::vector<TriggerEvent> triggers_entered, triggers_stayed, triggers_left;
    std::vector<JointBreakEvent> joints_broke;
    std::vector<EntityId> fell_asleep, woke;
};

// The newest ticks in which something happened, oldest first. Ticks are counted from the world's
// beginning, so that a reader knows how many it has missed: ticks.back() has number `count`.
struct RecentEvents {
    static constexpr std::size_t ticks_max = 64;

    std::uint32_t count = 0;
    std::vector<std::shared_ptr<const TickEvents>> ticks;
};

using EntityOfBody = std::function<EntityId(physics::BodyId)>;

// Nothing when nothing happened. Quarantined bodies are the operator's, not the clients'.
std::optional<TickEvents> copy_events(const physics::Events& events, std::uint32_t tick,
                                      const EntityOfBody& entity_of);

}  // namespace jostle::server
