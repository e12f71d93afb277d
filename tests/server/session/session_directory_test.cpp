// SPDX-License-Identifier: MIT
#include "session/session_directory.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

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

TEST(SessionDirectory, a_ticket_is_good_once_and_for_half_a_minute) {
    SessionDirectory sessions(2);
    const Clock::time_point now{};
    const std::string first = sessions.issue_ticket("w1", now),
                      second = sessions.issue_ticket("w2", now);
    EXPECT_NE(first, second);
    EXPECT_GE(first.size(), 32u);
    EXPECT_EQ(sessions.use_ticket(first, now + 29s), "w1");
    EXPECT_FALSE(sessions.use_ticket(first, now + 29s));
    EXPECT_FALSE(sessions.use_ticket(second, now + 31s));
    EXPECT_FALSE(sessions.use_ticket("", now));
}

TEST(SessionDirectory, of_too_many_tickets_the_first_to_expire_makes_room) {
    SessionDirectory sessions(2);
    const Clock::time_point now{};
    const std::string oldest = sessions.issue_ticket("w1", now);
    std::string newest;
    for (int i = 0; i < 10000; ++i) newest = sessions.issue_ticket("w2", now + 1ms);
    EXPECT_FALSE(sessions.use_ticket(oldest, now + 2ms));
    EXPECT_EQ(sessions.use_ticket(newest, now + 2ms), "w2");
}

}  // namespace
}  // namespace jostle::server
