// SPDX-License-Identifier: MIT
#include "server/session/outbox.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(Outbox, pops_in_order_and_counts_replies_only) {
    Outbox outbox;
    outbox.push_reply("pong");
    outbox.push_shared(std::make_shared<const std::string>("update"));
    outbox.push_reply("notice");
    EXPECT_EQ(outbox.replies(), 2u);
    EXPECT_EQ(outbox.pop()->header, "pong");
    EXPECT_EQ(*outbox.pop()->shared, "update");
    EXPECT_EQ(outbox.replies(), 1u);
    EXPECT_EQ(outbox.pop()->header, "notice");
    EXPECT_FALSE(outbox.pop().has_value());
    EXPECT_EQ(outbox.replies(), 0u);
}

TEST(Outbox, clear_resets_the_reply_count) {
    Outbox outbox;
    for (int i = 0; i < 3; i++) outbox.push_reply("pong");
    outbox.clear();
    EXPECT_TRUE(outbox.empty());
    EXPECT_EQ(outbox.replies(), 0u);
}

}  // namespace
}  // namespace jostle::server
