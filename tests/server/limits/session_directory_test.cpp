// SPDX-License-Identifier: MIT
#include "server/limits/session_directory.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(SessionDirectory, counts_clients_and_rejects_when_full) {
    SessionDirectory sessions(2);
    const auto one = sessions.enter("w1", "192.0.2.1"), two = sessions.enter("w2", "192.0.2.2");
    ASSERT_TRUE(one.ok() && two.ok());
    EXPECT_NE(*one, *two);
    EXPECT_NE(*one, 0u) << "id 0 is reserved for the scene";
    EXPECT_FALSE(sessions.enter("w1", "192.0.2.1").ok());
    EXPECT_EQ(sessions.clients(), 2);
    EXPECT_EQ(sessions.clients_in("w1"), 1);
    sessions.leave(*one);
    sessions.leave(*one);
    EXPECT_EQ(sessions.clients(), 1);
    EXPECT_EQ(sessions.clients_in("w1"), 0);
    EXPECT_NE(*sessions.enter("w1", "192.0.2.1"), *one) << "ids must not be reused";
}

TEST(SessionDirectory, limits_clients_per_address) {
    SessionDirectory sessions(100, 3);
    const auto first = sessions.enter("w1", "192.0.2.1");
    EXPECT_TRUE(sessions.enter("w1", "192.0.2.1").ok() && sessions.enter("w2", "192.0.2.1").ok());
    EXPECT_EQ(sessions.enter("w1", "192.0.2.1").error().message,
              "this address already has 3 clients, the maximum");
    EXPECT_TRUE(sessions.enter("w1", "192.0.2.2").ok());
    sessions.leave(*first);
    EXPECT_TRUE(sessions.enter("w1", "192.0.2.1").ok());
}

TEST(SessionDirectory, limits_clients_per_subject_but_not_anonymous_clients) {
    SessionDirectory sessions(100, 100, 1);
    const auto first = sessions.enter("w1", "192.0.2.1", "ann");
    EXPECT_EQ(sessions.enter("w2", "192.0.2.2", "ann").error().message,
              "the subject of the token already has 1 session, the maximum "
              "(limits.sessions_per_subject); end another one first");
    EXPECT_TRUE(sessions.is_at_limit("ann"));
    EXPECT_TRUE(sessions.enter("w1", "192.0.2.1", "bob").ok());
    EXPECT_TRUE(sessions.enter("w1", "192.0.2.1").ok() && sessions.enter("w1", "192.0.2.1").ok());
    sessions.leave(*first);
    EXPECT_FALSE(sessions.is_at_limit("ann"));
    sessions.restore_client(77, "w1", "192.0.2.1");
    sessions.set_subject(77, "ann");
    sessions.set_subject(77, "ann");
    EXPECT_FALSE(sessions.enter("w1", "192.0.2.1", "ann").ok());
    sessions.leave(77);
    EXPECT_TRUE(sessions.enter("w1", "192.0.2.1", "ann").ok());
}

}  // namespace
}  // namespace jostle::server
