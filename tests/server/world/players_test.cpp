// SPDX-License-Identifier: MIT
#include "server/world/players.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using test::error_of;

std::vector<PlayerEventKind> kinds_of(const PlayerList& list) {
    std::vector<PlayerEventKind> kinds;
    for (const PlayerEvent& event : list.recent) kinds.push_back(event.kind);
    return kinds;
}

TEST(Players, events_follow_the_order_of_the_changes) {
    using Kind = PlayerEventKind;
    Players players;
    const PlayerListPtr empty = players.publish(1);
    EXPECT_EQ(players.publish(2), empty);
    players.join({.client = 4, .name = "dora", .color = 0xff8000, .joined_tick = 3});
    players.join({.client = 2, .name = "bob", .role = PlayerRole::spectator, .joined_tick = 3});
    const PlayerListPtr two = players.publish(3);
    ASSERT_EQ(two->players.size(), 2u);
    EXPECT_EQ(two->players[0]->name, "bob") << "sorted by client";
    EXPECT_EQ(two->recent[0].player->name, "dora") << "in the order in which they joined";
    EXPECT_EQ(two->recent[0].tick, 3u);
    ASSERT_TRUE(players.rename(2, "rob").ok());
    ASSERT_TRUE(players.rename(2, "rob").ok()) << "no event";
    ASSERT_TRUE(players.set_role(2, PlayerRole::builder).ok());
    players.disconnect(4);
    players.disconnect(4);
    players.join({.client = 4, .name = "another name"});
    EXPECT_TRUE(players.leave(2));
    EXPECT_FALSE(players.leave(2));
    const PlayerListPtr last = players.publish(9);
    EXPECT_EQ(kinds_of(*last),
              (std::vector{Kind::joined, Kind::joined, Kind::renamed, Kind::role_changed,
                           Kind::disconnected, Kind::resumed, Kind::left}));
    EXPECT_EQ(last->revision, 7u);
    EXPECT_EQ(last->recent.back().player->role, PlayerRole::builder) << "as it was before";
    EXPECT_EQ(last->find(4)->name, "dora") << "a client that resumes keeps its name";
    EXPECT_EQ(last->find(2), nullptr);
    EXPECT_EQ(two->find(2)->name, "bob") << "published lists do not change";
    EXPECT_EQ(error_of(players.rename(2, "x")).message, "player 2 does not exist");
}

TEST(Players, a_list_has_the_newest_256_events) {
    Players players;
    for (ClientId client = 1; client <= 300; client++) players.join({.client = client});
    EXPECT_EQ(players.publish(1)->recent.size(), 256u);
    players.leave(7);
    const PlayerListPtr list = players.publish(2);
    EXPECT_EQ(list->revision, 301u);
    EXPECT_EQ(list->recent.size(), 256u);
    EXPECT_EQ(list->recent.front().player->client, 46u);
    EXPECT_EQ(list->recent.back().kind, PlayerEventKind::left);
}

TEST(Players, restored_players_cause_no_events) {
    Players players;
    players.join({.client = 9, .name = "ida", .role = PlayerRole::owner, .joined_tick = 77});
    players.disconnect(9);
    SavedHostState saved;
    players.write(saved);
    Players copy;
    copy.restore(saved);
    EXPECT_EQ(*copy.find(9), *players.find(9));
    const PlayerListPtr list = copy.publish(1);
    EXPECT_EQ(list->players.size(), 1u);
    EXPECT_EQ(list->revision, 0u);
}

TEST(Players, names_have_1_to_32_printable_bytes) {
    for (const char* name : {"x", "Zo\xc3\xab", "01234567890123456789012345678901"})
        EXPECT_TRUE(check_player_name(name, "name").ok()) << name;
    EXPECT_EQ(error_of(check_player_name("", "rename.name")).message,
              "rename.name has 0 bytes; it must have 1 to 32");
    for (const char* name : {"012345678901234567890123456789012", "a\nb", "\xff", "a\x1b[31m"})
        EXPECT_EQ(error_of(check_player_name(name, "name")).code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace jostle::server
