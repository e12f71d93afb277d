// SPDX-License-Identifier: MIT
#include "server/messages/event_message.h"

#include <gtest/gtest.h>

#include "jostle/v1/play.pb.h"

namespace jostle::server {
namespace {

TickEvents one_of_each_kind() {
    const ContactEvent contact{
        .a = 3, .b = 4, .point = {1, 2, 3}, .normal = {0, 1, 0}, .speed = 5, .impulse = 6};
    return {.tick = 9,
            .contacts_began = {contact},
            .contacts_ended = {contact},
            .contacts = {contact},
            .hits = {contact},
            .triggers_entered = {{11, 1}},
            .triggers_stayed = {{12, 1}},
            .triggers_left = {{13, 1}},
            .joints_broke = {{5, 6, 70, 80}},
            .fell_asleep = {21, 22},
            .woke = {23}};
}

void expect_contact(const v1::ContactEvent& event) {
    EXPECT_EQ(event.entity_a(), 3u);
    EXPECT_EQ(event.entity_b(), 4u);
    EXPECT_EQ(event.point().z(), 3);
    EXPECT_EQ(event.normal().y(), 1);
    EXPECT_EQ(event.speed(), 5);
    EXPECT_EQ(event.impulse(), 6);
}

TEST(EventMessage, encodes_each_event_kind_in_its_field) {
    const std::string shared = encode_shared_events(one_of_each_kind());
    v1::Snapshot snapshot;
    ASSERT_TRUE(snapshot.ParseFromString(encode_events_header(7, shared.size()) + shared));
    ASSERT_EQ(snapshot.events_size(), 1);
    const v1::Events& events = snapshot.events(0);
    EXPECT_EQ(events.tick(), 9u);
    EXPECT_EQ(events.missed(), 7u);
    ASSERT_EQ(events.contacts_began_size(), 1);
    expect_contact(events.contacts_began(0));
    ASSERT_EQ(events.contacts_size(), 1);
    expect_contact(events.contacts(0));
    ASSERT_EQ(events.hits_size(), 1);
    expect_contact(events.hits(0));
    ASSERT_EQ(events.contacts_ended_size(), 1);
    EXPECT_EQ(events.contacts_ended(0).entity_b(), 4u);
    EXPECT_FALSE(events.contacts_ended(0).has_point()) << "separated bodies have no contact point";
    EXPECT_EQ(events.contacts_ended(0).speed(), 0);
    ASSERT_EQ(events.triggers_entered_size(), 1);
    EXPECT_EQ(events.triggers_entered(0).trigger(), 11u);
    ASSERT_EQ(events.triggers_stayed_size(), 1);
    EXPECT_EQ(events.triggers_stayed(0).trigger(), 12u);
    ASSERT_EQ(events.triggers_left_size(), 1);
    EXPECT_EQ(events.triggers_left(0).trigger(), 13u);
    EXPECT_EQ(events.triggers_left(0).entity(), 1u);
    ASSERT_EQ(events.joints_broke_size(), 1);
    EXPECT_EQ(events.joints_broke(0).force(), 70);
    EXPECT_EQ(events.joints_broke(0).torque(), 80);
    EXPECT_EQ(events.fell_asleep_size(), 2);
    EXPECT_EQ(events.fell_asleep(1), 22u);
    ASSERT_EQ(events.woke_size(), 1);
    EXPECT_EQ(events.woke(0), 23u);
}

TEST(EventMessage, covers_every_message_field) {
    v1::Events events;
    ASSERT_TRUE(events.ParseFromString(encode_shared_events(one_of_each_kind())));
    const auto* fields = v1::Events::descriptor();
    for (int i = 0; i < fields->field_count(); i++) {
        const auto* field = fields->field(i);
        if (!field->is_repeated()) continue;
        EXPECT_GT(events.GetReflection()->FieldSize(events, field), 0) << field->name();
    }
}

}  // namespace
}  // namespace jostle::server
