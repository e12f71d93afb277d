// SPDX-License-Identifier: MIT
#include "server/world/room_codec.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

RoomState full_room() {
    RoomState room{.properties = {.title = "Yard",
                                  .description = "Build.",
                                  .tags = {"race", "cars"},
                                  .capacity = 8,
                                  .join_code = "1234",
                                  .unlisted = true,
                                  .close_when_empty = true,
                                  .areas = {{"tower", {-1, -2, -3}, {1, 2, 3}}}}};
    room.properties.permissions.set(PlayerRole::player, RoomAction::explode, Reach::none);
    room.properties.quotas[2].energy_per_second = 12.5;
    room.owner = "subject/ada";
    room.step = 1000, room.entered = 3;
    room.clients = {{.client = 4,
                     .role = PlayerRole::builder,
                     .member = "network/192.0.2.7",
                     .entered = 2,
                     .muted_until = 1200,
                     .energy = {-3.5, 999},
                     .removed = true,
                     .removed_reason = "why"},
                    {.client = 9, .role = PlayerRole::spectator, .spectator = true}};
    room.bans = {{"subject/eve", 0, "spam"}};
    room.grants = {{"subject/bob", PlayerRole::builder}};
    room.vote = RoomVote{.target = 9, .until = 1100, .clients = {4}};
    return room;
}

TEST(RoomCodec, decoded_room_equals_the_encoded_one) {
    EXPECT_EQ(*decode_room(encode_room(full_room())), full_room());
    EXPECT_EQ(*decode_room(encode_room(RoomState{})), RoomState{});
}

TEST(RoomCodec, refuses_every_prefix_and_other_versions) {
    std::string bytes = encode_room(full_room());
    for (std::size_t size = 1; size < bytes.size(); size++)
        EXPECT_FALSE(decode_room(bytes.substr(0, size)).ok()) << size;
    EXPECT_FALSE(decode_room(bytes + "x").ok());
    bytes[0] = 3;
    EXPECT_EQ(error_of(decode_room(bytes)).code, ErrorCode::failed_precondition);
}

TEST(RoomCodec, refuses_inconsistent_rooms) {
    RoomState room = full_room();
    std::swap(room.clients[0], room.clients[1]);
    EXPECT_FALSE(decode_room(encode_room(room)).ok()) << "clients out of order";
    room = full_room();
    room.clients[0].energy.step = 1001;
    EXPECT_FALSE(decode_room(encode_room(room)).ok()) << "a bucket of a later step";
    room = full_room();
    room.vote->target = 5;
    EXPECT_FALSE(decode_room(encode_room(room)).ok()) << "a vote about an absent client";
}

TEST(RoomCodec, commands_of_all_kinds) {
    const RoomCommand commands[] = {
        {EnterRoom{"subject/ada", true, true}},
        {SetRole{7, PlayerRole::owner}},
        {KickClient{7, "why"}},
        {BanClient{7, 2.5, "why"}},
        {UnbanMember{"subject/eve"}},
        {MuteClient{7, 30}},
        {CleanUpBodies{7}},
        {ProtectArea{{"tower", {-1, -2, -3}, {1, 2, 3}}}},
        {UnprotectArea{"tower"}},
        {VoteToKick{7}},
        {PauseRoom{true}},
        {ResetRoom{}},
        {UpdateRoom{std::make_shared<const RoomProperties>(full_room().properties)}},
        {StepRoom{3}},
        {SetRoomSpeed{25}},
        {RewindRoom{700}}};
    std::size_t index = 0;
    for (const RoomCommand& command : commands) {
        const std::string bytes = encode_room_command(command);
        const Result<RoomCommand> decoded = decode_room_command(bytes);
        ASSERT_TRUE(decoded.ok());
        EXPECT_EQ(decoded->kind.index(), index++);
        EXPECT_EQ(encode_room_command(*decoded), bytes);
        EXPECT_FALSE(decode_room_command(bytes + "x").ok());
    }
    EXPECT_EQ(index, std::variant_size_v<decltype(RoomCommand::kind)>);
    EXPECT_FALSE(decode_room_command("\x10").ok()) << "an unknown kind";
}

}  // namespace
}  // namespace jostle::server
