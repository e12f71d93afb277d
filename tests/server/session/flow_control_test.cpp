// SPDX-License-Identifier: MIT
#include "session/flow_control.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const Clock::time_point first_sent{};
constexpr auto period = std::chrono::microseconds(16667);

// Plays `ticks` ticks with a client that acknowledges each snapshot `delay` after it was sent
// (zero: never). Returns how many were sent.
int play(FlowControl& flow, std::uint32_t first, int ticks, Clock::duration delay) {
    std::deque<std::pair<std::uint32_t, Clock::time_point>> on_the_way;
    int sent = 0;
    for (std::uint32_t tick = first; tick < first + static_cast<std::uint32_t>(ticks); ++tick) {
        const Clock::time_point now = first_sent + tick * period;
        while (delay > 0s && !on_the_way.empty() && on_the_way.front().second + delay <= now) {
            flow.on_ack(on_the_way.front().first, on_the_way.front().second + delay);
            on_the_way.pop_front();
        }
        if (!flow.may_send(tick, now)) continue;
        flow.on_sent(tick, now);
        on_the_way.emplace_back(tick, now);
        sent++;
    }
    return sent;
}

TEST(FlowControl, a_good_client_gets_every_tick) {
    FlowControl flow({}, 60, 1);
    EXPECT_EQ(play(flow, 1, 600, 20ms), 600);
    EXPECT_EQ(flow.skipped(), 0u);
}

TEST(FlowControl, without_acks_no_more_than_the_window_is_in_flight) {
    FlowControl flow({}, 60, 1);
    EXPECT_EQ(play(flow, 1, 600, 0s), 4);
    EXPECT_EQ(flow.in_flight(), 4);
    EXPECT_GT(flow.skipped(), 0u);
}

TEST(FlowControl, says_what_was_not_tried_and_how_long_the_way_is) {
    FlowControl good({}, 60, 2);
    EXPECT_EQ(good.round_trip_s(), 0) << "nothing was acknowledged yet";
    play(good, 1, 600, 20ms);
    EXPECT_NEAR(good.round_trip_s(), 0.020, 1e-6);
    EXPECT_EQ(good.slowed(), 0u) << "every second tick is what it asked for";
    FlowControl slow({}, 60, 1);
    int sent = 0;
    for (std::uint32_t tick = 1; tick <= 300; ++tick) {
        const Clock::time_point now = first_sent + tick * period;
        if (tick % 6 == 0 && slow.in_flight() > 0)
            slow.on_ack(static_cast<std::uint32_t>(sent), now);
        if (slow.may_send(tick, now)) slow.on_sent(static_cast<std::uint32_t>(++sent), now);
    }
    EXPECT_GT(slow.slowed(), 0u);
    EXPECT_EQ(sent + slow.skipped() + slow.slowed(), 300u)
        << "each tick was sent or is accounted for";
}

TEST(FlowControl, the_window_follows_the_round_trip) {
    FlowControl flow({}, 60, 1);
    play(flow, 1, 1200, 150ms);
    // 150 ms of way and 50 of slack are 12 ticks; jitter is none.
    EXPECT_GE(flow.window(), 9);
    EXPECT_LE(flow.window(), 14);
}

TEST(FlowControl, one_that_cannot_keep_up_is_slowed_and_sped_up_again) {
    FlowControl flow({}, 60, 1);
    // Its program takes 100 ms for each snapshot: six ticks.
    std::deque<std::uint32_t> waiting;
    for (std::uint32_t tick = 1; tick <= 300; ++tick) {
        const Clock::time_point now = first_sent + tick * period;
        if (tick % 6 == 0 && !waiting.empty()) {
            flow.on_ack(waiting.front(), now);
            waiting.pop_front();
        }
        if (!flow.may_send(tick, now)) continue;
        flow.on_sent(tick, now);
        waiting.push_back(tick);
    }
    EXPECT_EQ(flow.divider(), 6) << "ten a second are what it can take";
    EXPECT_LE(flow.in_flight(), 8) << "what it gets is no older than a second";
    flow.on_ack(waiting.back(), first_sent + 301 * period);
    play(flow, 302, 60 * 30, 20ms);
    EXPECT_EQ(flow.divider(), 1) << "half a minute without trouble";
}

TEST(FlowControl, one_stall_of_a_second_does_not_slow_a_good_client) {
    FlowControl flow({}, 60, 1);
    play(flow, 1, 60, 20ms);
    const int in_flight = flow.in_flight(), window = flow.window();
    EXPECT_EQ(play(flow, 61, 60, 0s), window - in_flight) << "nothing is acknowledged";
    EXPECT_EQ(flow.divider(), 1);
    flow.on_ack(60 + static_cast<std::uint32_t>(window - in_flight), first_sent + 121 * period);
    EXPECT_EQ(play(flow, 122, 600, 20ms), 600) << "every tick again, at once";
}

TEST(FlowControl, a_wanted_divider_is_kept) {
    FlowControl flow({}, 60, 3);
    EXPECT_EQ(play(flow, 1, 600, 20ms), 200);
}

TEST(FlowControl, an_ack_covers_what_went_before_and_nonsense_covers_nothing) {
    FlowControl flow({}, 60, 1);
    for (std::uint32_t tick = 1; tick <= 3; ++tick) flow.on_sent(tick, first_sent);
    flow.on_ack(77, first_sent);
    flow.on_ack(0, first_sent);
    EXPECT_EQ(flow.in_flight(), 3);
    flow.on_ack(2, first_sent + 10ms);
    EXPECT_EQ(flow.in_flight(), 1);
    flow.on_ack(1, first_sent + 20ms);
    EXPECT_EQ(flow.in_flight(), 1);
}

}  // namespace
}  // namespace jostle::server
