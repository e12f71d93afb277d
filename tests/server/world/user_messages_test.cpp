// SPDX-License-Identifier: MIT
#include "server/world/user_messages.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(UserMessages, numbers_are_consecutive_and_lists_are_immutable) {
    UserMessages messages;
    const RecentMessagesPtr none = messages.publish(1);
    EXPECT_EQ(none->count, 0u);
    EXPECT_EQ(messages.add({.from = 3, .topic = "chat", .data = "a"}), 1u);
    EXPECT_EQ(messages.add({.from = 4, .topic = "chat", .data = "b"}), 2u);
    const RecentMessagesPtr two = messages.publish(5);
    EXPECT_EQ(messages.publish(6), two);
    ASSERT_EQ(two->messages.size(), 2u);
    EXPECT_EQ(two->messages[1]->data, "b");
    EXPECT_EQ(two->messages[1]->tick, 5u);
    messages.add({.topic = "chat", .data = "c"});
    EXPECT_EQ(messages.publish(7)->count, 3u);
    EXPECT_EQ(two->messages.size(), 2u);
}

TEST(UserMessages, retains_256_messages_or_256_kib) {
    UserMessages messages;
    for (int tick = 1; tick <= 3; tick++) {
        for (int k = 0; k < 100; k++) messages.add({.data = "x"});
        messages.publish(static_cast<std::uint32_t>(tick));
    }
    RecentMessagesPtr recent = messages.publish(4);
    EXPECT_EQ(recent->messages.size(), 256u);
    EXPECT_EQ(recent->messages.front()->number, 45u);
    for (int k = 0; k < 10; k++) messages.add({.data = std::string(60'000, 'x')});
    recent = messages.publish(5);
    EXPECT_EQ(recent->messages.size(), 4u);
    EXPECT_EQ(recent->count, 310u);
    EXPECT_EQ(recent->messages.back()->number, 310u);
}

TEST(UserMessages, a_replay_that_does_not_publish_keeps_bounded_memory) {
    UserMessages messages;
    messages.set_count(100);
    EXPECT_EQ(messages.publish(1)->count, 100u);
    for (int k = 0; k < 1000; k++) messages.add({.data = "x"});
    const RecentMessagesPtr recent = messages.publish(2);
    EXPECT_EQ(recent->count, 1100u);
    EXPECT_EQ(recent->messages.size(), 256u);
    EXPECT_EQ(recent->messages.front()->number, 845u);
}

TEST(UserMessages, recipients) {
    UserMessages messages;
    messages.add({.data = "all"});
    messages.add({.data = "two", .to = {9, 4}});
    messages.add({.data = "server", .to_server = true});
    const RecentMessagesPtr recent = messages.publish(1);
    const auto is_for = [&](std::size_t index, ClientId client) {
        return recent->messages[index]->is_for(client);
    };
    EXPECT_TRUE(is_for(0, 1));
    EXPECT_TRUE(is_for(1, 4) && is_for(1, 9));
    EXPECT_FALSE(is_for(1, 5));
    EXPECT_FALSE(is_for(2, 1));
}

}  // namespace
}  // namespace jostle::server
