// SPDX-License-Identifier: MIT
#include "server/messages/event_message.h"

#include <tuple>

#include "jostle/v1/play.pb.h"
#include "server/messages/message_parts.h"

namespace jostle::server {

namespace {

void write_ends(v1::ContactEvent& to, const ContactEvent& from) {
    to.set_entity_a(from.a);
    to.set_entity_b(from.b);
}

// Fields that a kind does not use are zero, which takes no bytes.
void write_contact(v1::ContactEvent& to, const ContactEvent& from) {
    write_ends(to, from);
    write_vector(*to.mutable_point(), from.point);
    write_vector(*to.mutable_normal(), from.normal);
    to.set_speed(from.speed);
    to.set_impulse(from.impulse);
}

void write_trigger(v1::TriggerEvent& to, const TriggerEvent& from) {
    to.set_trigger(from.trigger);
    to.set_entity(from.entity);
}

void write_break(v1::JointBreakEvent& to, const JointBreakEvent& from) {
    to.set_entity_a(from.a);
    to.set_entity_b(from.b);
    to.set_force(from.force);
    to.set_torque(from.torque);
}

// The storage of one kind of event in a tick, its field in the message, and its encoder.
template <class From, class To>
struct Kind {
    std::vector<From> TickEvents::*from;
    To* (v1::Events::*add)();
    void (*write)(To&, const From&);

    void encode(v1::Events& to, const TickEvents& events) const {
        for (const From& event : events.*from) write(*(to.*add)(), event);
    }
};

// The same for kinds with one entity each.
struct EntityKind {
    std::vector<EntityId> TickEvents::*from;
    google::protobuf::RepeatedField<std::uint32_t>* (v1::Events::*field)();

    void encode(v1::Events& to, const TickEvents& events) const {
        (to.*field)()->Add((events.*from).begin(), (events.*from).end());
    }
};

using v1::Events;
constexpr std::tuple kinds{
    Kind{&TickEvents::contacts_began, &Events::add_contacts_began, write_contact},
    Kind{&TickEvents::contacts_ended, &Events::add_contacts_ended, write_ends},
    Kind{&TickEvents::contacts, &Events::add_contacts, write_contact},
    Kind{&TickEvents::hits, &Events::add_hits, write_contact},
    Kind{&TickEvents::triggers_entered, &Events::add_triggers_entered, write_trigger},
    Kind{&TickEvents::triggers_stayed, &Events::add_triggers_stayed, write_trigger},
    Kind{&TickEvents::triggers_left, &Events::add_triggers_left, write_trigger},
    Kind{&TickEvents::joints_broke, &Events::add_joints_broke, write_break},
    EntityKind{&TickEvents::fell_asleep, &Events::mutable_fell_asleep},
    EntityKind{&TickEvents::woke, &Events::mutable_woke},
};
static_assert(std::tuple_size_v<decltype(kinds)> == TickEvents::kinds);

}  // namespace

std::string encode_shared_events(const TickEvents& from) {
    v1::Events events;
    events.set_tick(from.tick);
    std::apply([&](const auto&... kind) { (kind.encode(events, from), ...); }, kinds);
    return events.SerializeAsString();
}

std::string encode_events_header(std::uint32_t missed, std::size_t shared_bytes) {
    v1::Events own;
    own.set_missed(missed);
    return encode_header(v1::Snapshot::kEventsFieldNumber, own.SerializeAsString(), shared_bytes);
}

}  // namespace jostle::server
