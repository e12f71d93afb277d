// SPDX-License-Identifier: MIT
#include "server/world/room_properties.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

TEST(RoomProperties, errors_name_the_field_and_what_is_accepted) {
    const auto message = [](auto&& change) {
        RoomProperties room;
        change(room);
        return error_of(check_properties(room)).message;
    };
    EXPECT_EQ(message([](auto& room) { room.title = std::string(65, 'x'); }),
              "room.title has 65 bytes; at most 64 are allowed");
    EXPECT_EQ(message([](auto& room) { room.description = "a\nb"; }),
              "room.description contains control characters or invalid UTF-8");
    EXPECT_EQ(
        message([](auto& room) { room.tags = {"Race"}; }),
        "room.tags: \"Race\" is not a tag; a tag has 1 to 32 characters of a-z, 0-9, _ and -");
    EXPECT_EQ(message([](auto& room) { room.capacity = 10001; }),
              "room.capacity is 10001; it must be from 0 to 10000");
    EXPECT_EQ(message([](auto& room) {
                  room.areas = {{"a", {2, 0, 0}, {1, 0, 0}}};
              }),
              "room.areas[0]: area \"a\": min.x is 2 and max.x is 1; min must not exceed max, and "
              "both must be within 1e+06 m");
    EXPECT_EQ(message([](auto& room) {
                  room.areas = {{"a", {}, {}}, {"a", {}, {}}};
              }),
              "room.areas[1]: the name \"a\" is taken");
    EXPECT_TRUE(check_properties({}).ok());
}

TEST(RoomProperties, keys_of_permissions_and_quotas_are_checked) {
    RoomProperties room;
    EXPECT_TRUE(set_permission(room, "builder.delete", "any").ok());
    EXPECT_EQ(room.permissions.of(PlayerRole::builder, RoomAction::remove), Reach::any);
    EXPECT_TRUE(set_quota(room, "player.bodies", 7).ok());
    EXPECT_EQ(room.quotas_of(PlayerRole::player).bodies, 7u);
    EXPECT_EQ(
        error_of(set_permission(room, "king.delete", "any")).message,
        "room.permissions: \"king.delete\" does not start with a role; use spectator, player, "
        "builder or owner and a point, as in \"player.explode\"");
    EXPECT_EQ(error_of(set_permission(room, "player.push", "all")).message,
              "room.permissions: \"player.push\" is \"all\"; it must be none, own, unowned or any");
    EXPECT_FALSE(set_permission(room, "player.fly", "any").ok());
    EXPECT_FALSE(set_quota(room, "player.money", 1).ok());
    EXPECT_FALSE(set_quota(room, "player.bodies", std::nan("")).ok());
    EXPECT_FALSE(set_quota(room, "player.bodies", -1).ok());
}

TEST(ProtectedArea, contains_points_within_a_radius) {
    const ProtectedArea area{"a", {0, 0, 0}, {2, 2, 2}};
    EXPECT_TRUE(area.contains({1, 1, 1}));
    EXPECT_FALSE(area.contains({2.1, 1, 1}));
    EXPECT_TRUE(area.contains({2.1, 1, 1}, 0.2));
    EXPECT_FALSE(area.contains({3, 3, 1}, 1.4)) << "the edge is sqrt(2) m away";
    EXPECT_TRUE(area.contains({3, 3, 1}, 1.42));
}

}  // namespace
}  // namespace jostle::server
