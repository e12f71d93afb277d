// SPDX-License-Identifier: MIT
#include "server/messages/room_message.h"

#include <gtest/gtest.h>

#include "jostle/v1/play.pb.h"

namespace jostle::server {
namespace {

v1::RoomUpdate update_for(const RoomState& room, PlayerRole role) {
    v1::Snapshot snapshot;
    EXPECT_TRUE(snapshot.ParseFromString(encode_room_update(room, role)));
    return snapshot.room();
}

TEST(RoomMessage, bans_and_join_code_are_only_for_roles_that_may_change_them) {
    RoomState room{.properties = {.title = "Night race", .join_code = "sesame"}};
    room.bans = {{.member = "subject/eve", .reason = "spam"},
                 {.member = "network/192.0.2.7", .until = 600}};
    const v1::RoomUpdate owner = update_for(room, PlayerRole::owner);
    EXPECT_EQ(owner.settings().join_code(), "sesame");
    ASSERT_EQ(owner.bans_size(), 2);
    EXPECT_EQ(owner.bans(0).member(), "subject/eve");
    EXPECT_EQ(owner.bans(0).reason(), "spam");
    EXPECT_TRUE(owner.bans(0).permanent());
    EXPECT_FALSE(owner.bans(1).permanent());
    const v1::RoomUpdate builder = update_for(room, PlayerRole::builder);
    EXPECT_EQ(builder.settings().title(), "Night race");
    EXPECT_EQ(builder.settings().join_code(), "");
    EXPECT_EQ(builder.bans_size(), 0);

    ASSERT_TRUE(set_permission(room.properties, "builder.ban", "any").ok());
    EXPECT_EQ(update_for(room, PlayerRole::builder).bans_size(), 2);
    EXPECT_EQ(update_for(room, PlayerRole::builder).settings().join_code(), "");
    ASSERT_TRUE(set_permission(room.properties, "builder.settings", "any").ok());
    EXPECT_EQ(update_for(room, PlayerRole::builder).settings().join_code(), "sesame");
}

TEST(RoomMessage, equal_rooms_have_equal_bytes) {
    RoomState room;
    for (const char* key : {"player.explode", "player.spawn", "builder.kick", "player.joints"})
        ASSERT_TRUE(set_permission(room.properties, key, "own").ok()) << key;
    const RoomState copy = room;
    EXPECT_EQ(encode_room_update(room, PlayerRole::player),
              encode_room_update(copy, PlayerRole::player));
}

}  // namespace
}  // namespace jostle::server
