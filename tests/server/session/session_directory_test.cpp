// SPDX-License-Identifier: MIT
#include "session/session_directory.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

TEST(SessionDirectory, counts_clients_and_says_when_it_is_full) {
    SessionDirectory sessions(2);
    const auto one = sessions.enter("w1"), two = sessions.enter("w2");
    ASSERT_TRUE(one && two);
    EXPECT_NE(*one, *two);
    EXPECT_NE(*one, 0u) << "0 is the scene";
    EXPECT_FALSE(sessions.enter("w1"));
    EXPECT_EQ(sessions.clients(), 2);
    EXPECT_EQ(sessions.clients_in("w1"), 1);
    sessions.leave(*one);
    sessions.leave(*one);
    EXPECT_EQ(sessions.clients(), 1);
    EXPECT_EQ(sessions.clients_in("w1"), 0);
    EXPECT_NE(*sessions.enter("w1"), *one) << "ids are not used again";
}

}  // namespace
}  // namespace jostle::server
