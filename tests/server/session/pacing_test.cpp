// SPDX-License-Identifier: MIT
#include "session/pacing.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const Clock::time_point start{};
constexpr auto period = std::chrono::microseconds(16667);

// Plays `ticks` ticks with a client that acknowledges each snapshot `delay` after it was sent
// (zero: never). Returns how many were sent.
int play(Pacing& pacing, std::uint32_t first, int ticks, Clock::duration delay) {
    std::deque<std::pair<std::uint32_t, Clock::time_point>> on_the_way;
    int sent = 0;
    for (std::uint32_t tick = first; tick < first + static_cast<std::uint32_t>(ticks); ++tick) {
        const Clock::time_point now = start + tick * period;
        while (delay > 0s && !on_the_way.empty() && on_the_way.front().second + delay <= now) {
            pacing.acked(on_the_way.front().first, on_the_way.front().second + delay);
            on_the_way.pop_front();
        }
        if (!pacing.may_send(tick, now)) continue;
        pacing.sent(tick, now);
        on_the_way.emplace_back(tick, now);
        sent++;
    }
    return sent;
}

TEST(Pacing, a_good_client_gets_every_tick) {
    Pacing pacing({}, 60, 1);
    EXPECT_EQ(play(pacing, 1, 600, 20ms), 600);
    EXPECT_EQ(pacing.skipped(), 0u);
}

TEST(Pacing, without_acks_no_more_than_the_window_is_in_flight) {
    Pacing pacing({}, 60, 1);
    EXPECT_EQ(play(pacing, 1, 600, 0s), 4);
    EXPECT_EQ(pacing.in_flight(), 4);
    EXPECT_GT(pacing.skipped(), 0u);
}

TEST(Pacing, the_window_follows_the_round_trip) {
    Pacing pacing({}, 60, 1);
    play(pacing, 1, 1200, 150ms);
    // 150 ms of way and 50 of slack are 12 ticks; jitter is none.
    EXPECT_GE(pacing.window(), 9);
    EXPECT_LE(pacing.window(), 14);
}

TEST(Pacing, one_that_cannot_keep_up_is_slowed_and_sped_up_again) {
    Pacing pacing({}, 60, 1);
    // Its program takes 100 ms for each snapshot: six ticks.
    std::deque<std::uint32_t> waiting;
    for (std::uint32_t tick = 1; tick <= 300; ++tick) {
        const Clock::time_point now = start + tick * period;
        if (tick % 6 == 0 && !waiting.empty()) {
            pacing.acked(waiting.front(), now);
            waiting.pop_front();
        }
        if (!pacing.may_send(tick, now)) continue;
        pacing.sent(tick, now);
        waiting.push_back(tick);
    }
    EXPECT_EQ(pacing.divider(), 6) << "ten a second are what it can take";
    EXPECT_LE(pacing.in_flight(), 8) << "what it gets is no older than a second";
    pacing.acked(waiting.back(), start + 301 * period);
    play(pacing, 302, 60 * 30, 20ms);
    EXPECT_EQ(pacing.divider(), 1) << "half a minute without trouble";
}

TEST(Pacing, one_stall_of_a_second_does_not_slow_a_good_client) {
    Pacing pacing({}, 60, 1);
    play(pacing, 1, 60, 20ms);
    const int in_flight = pacing.in_flight(), window = pacing.window();
    EXPECT_EQ(play(pacing, 61, 60, 0s), window - in_flight) << "nothing is acknowledged";
    EXPECT_EQ(pacing.divider(), 1);
    pacing.acked(60 + static_cast<std::uint32_t>(window - in_flight), start + 121 * period);
    EXPECT_EQ(play(pacing, 122, 600, 20ms), 600) << "every tick again, at once";
}

TEST(Pacing, a_wanted_divider_is_kept) {
    Pacing pacing({}, 60, 3);
    EXPECT_EQ(play(pacing, 1, 600, 20ms), 200);
}

TEST(Pacing, an_ack_covers_what_went_before_and_nonsense_covers_nothing) {
    Pacing pacing({}, 60, 1);
    for (std::uint32_t tick = 1; tick <= 3; ++tick) pacing.sent(tick, start);
    pacing.acked(77, start);
    pacing.acked(0, start);
    EXPECT_EQ(pacing.in_flight(), 3);
    pacing.acked(2, start + 10ms);
    EXPECT_EQ(pacing.in_flight(), 1);
    pacing.acked(1, start + 20ms);
    EXPECT_EQ(pacing.in_flight(), 1);
}

}  // namespace
}  // namespace jostle::server
