// SPDX-License-Identifier: MIT
#include "server/session/session_timeouts.h"

#include <gtest/gtest.h>

#include "tests/server/session/session_start.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

class SessionTimeoutsTest : public testing::Test {
protected:
    // Checks every 100 ms, as a transport does.
    void poll_until(Clock::time_point end) {
        for (; now < end; now += 100ms) timeouts.forgive_process_stall(now);
    }

    StreamSettings settings{.hello_timeout_seconds = 5, .client_timeout_seconds = 10};
    SessionTimeouts timeouts{settings, start};
    Clock::time_point now = start;
};

TEST_F(SessionTimeoutsTest, each_timeout_starts_with_its_own_event) {
    EXPECT_FALSE(timeouts.hello_timeout(start + 5s));
    EXPECT_EQ(timeouts.hello_timeout(start + 5001ms)->message,
              "no Hello arrived within 5 s; the first message must be a Hello");
    timeouts.on_received(start + 3s);
    EXPECT_FALSE(timeouts.client_timeout(start + 13s));
    EXPECT_EQ(timeouts.client_timeout(start + 13001ms)->code, ErrorCode::deadline_exceeded);
    EXPECT_FALSE(timeouts.read_timeout(start + 60s)) << "the transport can write";
    timeouts.on_write_blocked(start + 20s);
    timeouts.on_write_blocked(start + 25s);
    EXPECT_FALSE(timeouts.read_timeout(start + 30s));
    EXPECT_EQ(timeouts.read_timeout(start + 30001ms)->code, ErrorCode::resource_exhausted);
    timeouts.on_writable();
    EXPECT_FALSE(timeouts.read_timeout(start + 60s));
}

// 1 MB takes 16 s at 0.5 Mbit/s. It is on its way for up to 31 s.
TEST_F(SessionTimeoutsTest, a_client_has_time_to_receive_what_was_sent) {
    timeouts.on_received(start);
    timeouts.on_sent(600'000);
    timeouts.on_sent(400'000);
    EXPECT_FALSE(timeouts.client_timeout(start + 33s));
    EXPECT_TRUE(timeouts.client_timeout(start + 34s));
    timeouts.on_received(start + 20s);
    EXPECT_TRUE(timeouts.client_timeout(start + 31s)) << "the rest has arrived";
    timeouts.on_sent(std::size_t{1} << 40);
    EXPECT_TRUE(timeouts.client_timeout(start + 143s));
}

TEST_F(SessionTimeoutsTest, idle_timeout_starts_with_each_new_input) {
    EXPECT_FALSE(timeouts.idle_timeout(start + 24h)) << "0 disables it";
    SessionTimeouts idle(settings, start, 60);
    idle.on_joined(start + 10s);
    EXPECT_FALSE(idle.idle_timeout(start + 70s));
    EXPECT_EQ(idle.idle_timeout(start + 70001ms)->message,
              "the client sent no input for 60 s; join as a spectator to watch");
    idle.on_input_sequence(3, start + 30s);
    idle.on_input_sequence(3, start + 50s);  // no new input
    idle.on_received(start + 80s);
    EXPECT_FALSE(idle.idle_timeout(start + 90s));
    EXPECT_TRUE(idle.idle_timeout(start + 90001ms));
}

TEST_F(SessionTimeoutsTest, datagrams_never_shorten_the_client_timeout) {
    timeouts.on_received(start + 3s);
    timeouts.on_datagram(start + 2s);
    EXPECT_FALSE(timeouts.client_timeout(start + 13s));
    timeouts.on_datagram(start + 4s);
    EXPECT_FALSE(timeouts.client_timeout(start + 14s));
}

TEST_F(SessionTimeoutsTest, a_stall_of_the_process_extends_timeouts_by_its_length) {
    poll_until(start + 4s);
    timeouts.forgive_process_stall(start + 34s);  // 30.1 s after the last check
    EXPECT_FALSE(timeouts.hello_timeout(start + 34s));
    EXPECT_FALSE(timeouts.hello_timeout(start + 35100ms));
    EXPECT_TRUE(timeouts.hello_timeout(start + 35101ms));
    EXPECT_EQ(timeouts.age(start + 35100ms), 5s);
    EXPECT_FALSE(timeouts.client_timeout(start + 40100ms));
    EXPECT_TRUE(timeouts.client_timeout(start + 40101ms));
}

TEST_F(SessionTimeoutsTest, regular_checks_extend_nothing) {
    poll_until(start + 6s);
    EXPECT_EQ(timeouts.age(start + 6s), 6s);
    EXPECT_TRUE(timeouts.hello_timeout(start + 6s));
}

}  // namespace
}  // namespace jostle::server
