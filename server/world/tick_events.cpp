// SPDX-License-Identifier: MIT
#include "server/world/tick_events.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace jostle::server {

using physics::Events;

namespace {

// Converts an event between bodies to an event between entities.
ContactEvent convert(const physics::ContactBegin& e, const EntityOfBody& entity_of) {
    return {.a = entity_of(e.body_a),
            .b = entity_of(e.body_b),
            .point = e.point,
            .normal = e.normal,
            .speed = e.approach_speed};
}

ContactEvent convert(const physics::ContactEnd& e, const EntityOfBody& entity_of) {
    return {.a = entity_of(e.body_a), .b = entity_of(e.body_b)};
}

ContactEvent convert(const physics::ContactStay& e, const EntityOfBody& entity_of) {
    return {.a = entity_of(e.body_a),
            .b = entity_of(e.body_b),
            .point = e.point,
            .normal = e.normal,
            .impulse = e.normal_impulse};
}

ContactEvent convert(const physics::ContactHit& e, const EntityOfBody& entity_of) {
    return {.a = entity_of(e.body_a),
            .b = entity_of(e.body_b),
            .point = e.point,
            .normal = e.normal,
            .speed = e.approach_speed};
}

TriggerEvent convert(const physics::TriggerEvent& e, const EntityOfBody& entity_of) {
    return {entity_of(e.trigger_body), entity_of(e.body)};
}

JointBreakEvent convert(const physics::JointBreak& e, const EntityOfBody& entity_of) {
    return {entity_of(e.body_a), entity_of(e.body_b), e.force, e.torque};
}

EntityId convert(physics::BodyId body, const EntityOfBody& entity_of) {
    return entity_of(body);
}

// The sort keys of the lists.
auto order_of(const ContactEvent& e) {
    return std::pair(e.a, e.b);
}
auto order_of(const TriggerEvent& e) {
    return std::pair(e.trigger, e.entity);
}
auto order_of(const JointBreakEvent& e) {
    return std::pair(e.a, e.b);
}
auto order_of(EntityId entity) {
    return entity;
}

// The lists of a kind of event in physics::Events and in TickEvents.
template <class Source, class Copy>
struct Kind {
    std::span<const Source> Events::*source;
    std::vector<Copy> TickEvents::*copy;
};

constexpr std::tuple kinds{
    Kind{&Events::contacts_began, &TickEvents::contacts_began},
    Kind{&Events::contacts_ended, &TickEvents::contacts_ended},
    Kind{&Events::contacts, &TickEvents::contacts},
    Kind{&Events::hits, &TickEvents::hits},
    Kind{&Events::triggers_entered, &TickEvents::triggers_entered},
    Kind{&Events::triggers_stayed, &TickEvents::triggers_stayed},
    Kind{&Events::triggers_left, &TickEvents::triggers_left},
    Kind{&Events::joints_broke, &TickEvents::joints_broke},
    Kind{&Events::fell_asleep, &TickEvents::fell_asleep},
    Kind{&Events::woke, &TickEvents::woke},
};
static_assert(std::tuple_size_v<decltype(kinds)> == TickEvents::kinds);

template <class Source, class Copy>
std::vector<Copy> copy_list(std::span<const Source> events, const EntityOfBody& entity_of) {
    std::vector<Copy> out;
    out.reserve(events.size());
    for (const Source& event : events) out.push_back(convert(event, entity_of));
    // Stable, so that shape pairs of the same two entities retain the order of the world.
    std::ranges::stable_sort(out, {}, [](const Copy& event) { return order_of(event); });
    return out;
}

}  // namespace

std::optional<TickEvents> copy_events(const Events& events, std::uint32_t tick,
                                      const EntityOfBody& entity_of) {
    TickEvents out{.tick = tick};
    bool any = false;
    const auto copy_kind = [&]<class Source, class Copy>(const Kind<Source, Copy>& kind) {
        out.*kind.copy = copy_list<Source, Copy>(events.*kind.source, entity_of);
        any = any || !(events.*kind.source).empty();
    };
    std::apply([&](const auto&... kind) { (copy_kind(kind), ...); }, kinds);
    if (!any) return std::nullopt;
    return out;
}

}  // namespace jostle::server
