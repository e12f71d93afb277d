// SPDX-License-Identifier: MIT
#include "jostle/client/world_data.h"

#include <gtest/gtest.h>

namespace jostle::client {
namespace {

v1::PlayerEvent event(v1::PlayerEventKind kind, std::uint32_t client, const char* name) {
    v1::PlayerEvent event;
    event.set_kind(kind);
    event.mutable_player()->set_client(client);
    event.mutable_player()->set_name(name);
    return event;
}

TEST(WorldData, players_are_the_complete_list_with_later_events) {
    WorldData data;
    v1::Snapshot first;
    v1::PlayerUpdate& complete = *first.add_players();
    complete.set_complete(true);
    for (const std::uint32_t client : {1u, 2u}) complete.add_players()->set_client(client);
    v1::PlayerPing& ping = *first.add_players()->add_pings();
    ping.set_client(2);
    ping.set_ping_ms(31);
    data.apply(first);
    v1::Snapshot second;
    v1::PlayerUpdate& update = *second.add_players();
    *update.add_events() = event(v1::PLAYER_EVENT_KIND_LEFT, 1, "");
    *update.add_events() = event(v1::PLAYER_EVENT_KIND_RENAMED, 2, "rob");
    *update.add_events() = event(v1::PLAYER_EVENT_KIND_JOINED, 3, "cy");
    data.apply(second);
    ASSERT_EQ(data.players().size(), 2u);
    EXPECT_EQ(data.players().at(2).name(), "rob");
    EXPECT_EQ(data.players().at(2).ping_ms(), 31u) << "events do not carry it";
    EXPECT_EQ(data.players().at(3).name(), "cy");
}

TEST(WorldData, attributes_change_by_key_and_end_with_their_target) {
    WorldData data;
    v1::Attribute hp;
    hp.set_key("hp");
    hp.set_integer(10);
    v1::Snapshot snapshot;
    v1::AttributeUpdate& update = *snapshot.add_attributes();
    *update.add_sets() = attributes_input(AttributeTarget::entity(7), {hp}).set_attributes().set();
    *update.add_sets() = attributes_input(AttributeTarget::world(), {hp}).set_attributes().set();
    data.apply(snapshot);
    EXPECT_EQ(data.attribute(AttributeTarget::entity(7), "hp")->integer(), 10);
    EXPECT_EQ(data.attribute(AttributeTarget::player(7), "hp"), nullptr);
    const std::uint64_t revision = data.attribute_revision();
    v1::Snapshot end;
    end.add_attributes()->add_entities_ended(7);
    v1::Attribute removed;
    removed.set_key("hp");
    *end.add_attributes()->add_sets() =
        attributes_input(AttributeTarget::world(), {removed}).set_attributes().set();
    data.apply(end);
    EXPECT_TRUE(data.attributes().empty());
    EXPECT_GT(data.attribute_revision(), revision);
}

}  // namespace
}  // namespace jostle::client
