// SPDX-License-Identifier: MIT
#include "host/tick_events.h"

#include <algorithm>
#include <tuple>

namespace jostle::server {

using namespace physics;

namespace {

template <class Event>
ContactEvent between(const Event& event, const EntityOfBody& entity_of) {
    ContactEvent out;
    out.a = entity_of(event.body_a);
    out.b = entity_of(event.body_b);
    if constexpr (requires { event.point; }) {
        out.point = event.point;
        out.normal = event.normal;
    }
    if constexpr (requires { event.approach; }) out.speed = event.approach;
    if constexpr (requires { event.normal_impulse; }) out.impulse = event.normal_impulse;
    return out;
}

template <class Event>
std::vector<ContactEvent> contacts_of(std::span<const Event> events,
                                      const EntityOfBody& entity_of) {
    std::vector<ContactEvent> out;
    out.reserve(events.size());
    for (const Event& event : events) out.push_back(between(event, entity_of));
    // Stable: pairs of shapes of the same two entities stay in the world's order.
    std::ranges::stable_sort(out, {}, [](const auto& x) { return std::pair(x.a, x.b); });
    return out;
}

std::vector<TriggerEvent> triggers_of(std::span<const physics::TriggerEvent> events,
                                      const EntityOfBody& entity_of) {
    std::vector<TriggerEvent> out;
    out.reserve(events.size());
    for (const physics::TriggerEvent& event : events)
        out.push_back({entity_of(event.trigger_body), entity_of(event.body)});
    std::ranges::stable_sort(out, {}, [](const auto& x) { return std::pair(x.trigger, x.entity); });
    return out;
}

std::vector<JointBreakEvent> breaks_of(std::span<const JointBreak> events,
                                       const EntityOfBody& entity_of) {
    std::vector<JointBreakEvent> out;
    out.reserve(events.size());
    for (const JointBreak& event : events)
        out.push_back(
            {entity_of(event.body_a), entity_of(event.body_b), event.force, event.torque});
    std::ranges::stable_sort(out, {}, [](const auto& x) { return std::pair(x.a, x.b); });
    return out;
}

std::vector<EntityId> entities_of(std::span<const BodyId> bodies, const EntityOfBody& entity_of) {
    std::vector<EntityId> out;
    out.reserve(bodies.size());
    for (const BodyId body : bodies) out.push_back(entity_of(body));
    std::ranges::sort(out);
    return out;
}

bool nothing_in(const Events& e) {
    return e.contacts_began.empty() && e.contacts_ended.empty() && e.contacts.empty() &&
           e.hits.empty() && e.triggers_entered.empty() && e.triggers_stayed.empty() &&
           e.triggers_left.empty() && e.joints_broke.empty() && e.fell_asleep.empty() &&
           e.woke.empty();
}

}  // namespace

std::optional<TickEvents> copy_events(const Events& events, std::uint32_t tick,
                                      const EntityOfBody& entity_of) {
    if (nothing_in(events)) return std::nullopt;
    return TickEvents{.tick = tick,
                      .began = contacts_of(events.contacts_began, entity_of),
                      .ended = contacts_of(events.contacts_ended, entity_of),
                      .contacts = contacts_of(events.contacts, entity_of),
                      .hits = contacts_of(events.hits, entity_of),
                      .entered = triggers_of(events.triggers_entered, entity_of),
                      .stayed = triggers_of(events.triggers_stayed, entity_of),
                      .left = triggers_of(events.triggers_left, entity_of),
                      .joints_broke = breaks_of(events.joints_broke, entity_of),
                      .fell_asleep = entities_of(events.fell_asleep, entity_of),
                      .woke = entities_of(events.woke, entity_of)};
}

}  // namespace jostle::server
