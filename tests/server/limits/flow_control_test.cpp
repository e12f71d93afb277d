// SPDX-License-Identifier: MIT
#include "server/limits/flow_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "jostle/base/network_simulator.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

constexpr double rate_hz = 60;

// A client behind unlimited buffers. A message takes `delay_s` to arrive, waits until the client
// has read the previous messages, and is acknowledged according to play.proto. Times are in
// seconds.
class Reader {
public:
    // `read_s`: time to read a message whose reading starts at the given time.
    Reader(double delay, std::function<double(double)> read_s, int divider = 1)
        : delay_s(delay), flow_({}, rate_hz, divider), read_s_(std::move(read_s)) {}

    void play_until(double end_s) {
        for (; now_s() < end_s; tick_++) {
            deliver_acks(now_s());
            if (flow_.may_send(tick_, at(now_s()))) send();
            for (int k = 0; k < others_a_tick; k++) send_other();
        }
        deliver_acks(end_s);
    }
    void send_others(int count) {
        for (int k = 0; k < count; k++) send_other();
    }
    // Ages in ms, at the time of reading, of the snapshots read between two times; sorted.
    std::vector<double> ages_ms(double from_s, double until_s) const {
        std::vector<double> ages;
        for (const ReadSnapshot& snapshot : snapshots_)
            if (snapshot.read_s >= from_s && snapshot.read_s < until_s)
                ages.push_back((snapshot.read_s - snapshot.sent_s) * 1000);
        std::ranges::sort(ages);
        return ages;
    }
    double age_p99_ms(double from_s, double until_s) const {
        const auto ages = ages_ms(from_s, until_s);
        return ages.empty() ? 0 : ages[ages.size() * 99 / 100];
    }
    int read_between(double from_s, double until_s) const {
        return static_cast<int>(ages_ms(from_s, until_s).size());
    }
    const FlowControl& flow() const { return flow_; }
    double now_s() const { return tick_ / rate_hz; }

    double delay_s;  // per direction
    int others_a_tick = 0;

private:
    struct ReadSnapshot {
        double sent_s, read_s;
    };
    struct Ack {
        std::uint32_t frame;
        double at_s;
        double held_s = 0;
    };
    static Clock::time_point at(double seconds) {
        return Clock::time_point{} + 1h + from_seconds(seconds);
    }
    double read_next() {
        const double begun = std::max(now_s() + delay_s, free_s_);
        free_s_ = begun + read_s_(begun);
        return free_s_;
    }
    void send() {
        flow_.on_sent(tick_, at(now_s()));
        snapshots_.push_back({now_s(), read_next()});
        to_acknowledge_.push_back({.frame = tick_, .at_s = snapshots_.back().read_s});
    }
    void send_other() {
        flow_.on_other_sent();
        read_next();
    }
    // The client acknowledges the messages that it read as soon as its last acknowledgement is 100
    // ms old.
    void deliver_acks(double now) {
        while (!to_acknowledge_.empty()) {
            const double due = std::max(to_acknowledge_.front().at_s, last_ack_s_ + 0.1);
            if (due > now) break;
            Ack ack{};
            while (!to_acknowledge_.empty() && to_acknowledge_.front().at_s <= due) {
                ack = {to_acknowledge_.front().frame, due + delay_s,
                       due - to_acknowledge_.front().at_s};
                to_acknowledge_.pop_front();
            }
            last_ack_s_ = due;
            acks_.push_back(ack);
        }
        while (!acks_.empty() && acks_.front().at_s <= now) {
            flow_.on_ack(acks_.front().frame, from_seconds(acks_.front().held_s),
                         at(acks_.front().at_s));
            acks_.pop_front();
        }
    }

    FlowControl flow_;
    std::function<double(double)> read_s_;
    std::uint32_t tick_ = 1;
    double free_s_ = 0, last_ack_s_ = -1;
    std::deque<Ack> to_acknowledge_, acks_;
    std::vector<ReadSnapshot> snapshots_;
};

std::function<double(double)> messages_a_second(double rate) {
    return [rate](double) { return 1 / rate; };
}

std::function<double(double)> at_once() {
    return [](double) { return 0.0; };
}

TEST(FlowControl, sends_every_tick_at_any_latency) {
    for (const double delay_s : {0.0, 0.005, 0.05, 0.15}) {
        Reader reader(delay_s, at_once());
        reader.play_until(20);
        EXPECT_EQ(reader.read_between(2, 18), 16 * 60) << delay_s << " s delay";
        EXPECT_EQ(reader.flow().rate_skipped(), 0u);
    }
}

// A tenth of a second is the interval of acknowledgements, and 0.05 s the slack.
TEST(FlowControl, limits_unacknowledged_messages_to_the_window) {
    FlowControl flow({}, rate_hz, 1);
    std::vector<double> sent_s;
    for (std::uint32_t tick = 1; tick <= 600; tick++) {
        const double now_s = tick / rate_hz;
        const Clock::time_point now = Clock::time_point{} + 1h + from_seconds(now_s);
        if (!flow.may_send(tick, now)) continue;
        flow.on_sent(tick, now);
        sent_s.push_back(now_s);
    }
    EXPECT_EQ(flow.skipped(), 600 - sent_s.size());
    EXPECT_EQ(flow.round_trip_s(), 0) << "there is no estimate before the first acknowledgement";
    ASSERT_GE(sent_s.size(), 10u);
    EXPECT_LE(sent_s.size(), 12u);
    EXPECT_NEAR(sent_s[3], 4 / rate_hz, 1e-9) << "the window is full";
    const double pauses_s[] = {0.15, 0.3, 0.6, 1.2, 2, 2};
    for (std::size_t k = 0; k < 6; k++)
        EXPECT_NEAR(sent_s[4 + k] - sent_s[3 + k], pauses_s[k], 1.01 / rate_hz) << k;
}

// The guaranteed bound: in every 10 s after the first 5 s, 99 of 100 snapshots are read within 250
// ms plus the time of one read.
TEST(FlowControl, bounds_snapshot_age_for_all_read_rates) {
    for (const double pace : {60.0, 55.0, 45.0, 30.0, 20.0, 12.0, 8.0, 5.0})
        for (const double delay_s : {0.0005, 0.04}) {
            Reader reader(delay_s, messages_a_second(pace));
            reader.play_until(120);
            double worst_ms = 0;
            for (double from = 5; from < 110; from += 10)
                worst_ms = std::max(worst_ms, reader.age_p99_ms(from, from + 10));
            const int read = reader.read_between(5, 115);
            RecordProperty("worst_p99_ms_" + std::to_string(static_cast<int>(pace)),
                           std::to_string(worst_ms));
            EXPECT_LE(worst_ms, 250 + 1000 / pace + 1000 * delay_s)
                << pace << " per second, " << delay_s;
            const Cadence cadence(rate_hz, 1);
            const double rate = cadence.rate(cadence.class_within(0.95 * pace));
            EXPECT_GE(read, 0.95 * rate * 110) << pace << " per second, delay " << delay_s;
        }
}

// The Welcome and the entities precede the first snapshot, and a slow reader reads them first.
TEST(FlowControl, earlier_messages_do_not_affect_the_round_trip_estimate) {
    for (const double pace : {20.0, 12.0, 8.0}) {
        Reader reader(0.0005, messages_a_second(pace));
        reader.send_others(4);
        reader.play_until(60);
        for (double from = 5; from < 50; from += 10)
            EXPECT_LE(reader.age_p99_ms(from, from + 10), 250 + 1000 / pace)
                << pace << ", " << from;
    }
}

TEST(FlowControl, bounds_snapshot_age_and_loss_with_jitter) {
    std::mt19937 random(7);
    std::exponential_distribution<double> jitter(1 / 0.002);
    Reader reader(0.02, [&](double) { return jitter(random); });
    reader.play_until(60);
    EXPECT_LE(reader.age_p99_ms(5, 60), 60);
    EXPECT_GE(reader.read_between(5, 60), 0.98 * 55 * rate_hz);
}

TEST(FlowControl, counts_other_messages_in_the_window) {
    // 20 per second: each snapshot is accompanied by another message.
    Reader reader(0.0005, messages_a_second(100));
    reader.others_a_tick = 1;
    reader.play_until(60);
    EXPECT_LE(reader.age_p99_ms(5, 60), 260);
    EXPECT_LE(reader.read_between(5, 60), 40 * 55) << "60 of 100 messages are not snapshots";
    EXPECT_GE(reader.read_between(5, 60), 28 * 55);
}

TEST(FlowControl, recovers_within_three_seconds_when_a_reader_slows_down) {
    Reader reader(0.001, [](double t) { return t > 20 && t < 40 ? 1 / 10.0 : 0.001; });
    reader.play_until(60);
    EXPECT_EQ(reader.read_between(10, 20), 600);
    EXPECT_LE(reader.age_p99_ms(23, 40), 250 + 100);
    EXPECT_GE(reader.read_between(44, 54), 590)
        << "the reader must receive every tick once it is fast enough";
}

TEST(FlowControl, one_second_stall_does_not_lower_the_rate) {
    // At 10 s the client reads nothing for 1 s.
    Reader reader(0.005, [](double t) { return t > 10 && t < 11 ? 11 - t : 0.0001; });
    reader.play_until(20);
    EXPECT_EQ(reader.flow().rate_skipped(), 0u);
    EXPECT_EQ(reader.read_between(11.5, 19), 450);
}

TEST(FlowControl, recovers_within_three_seconds_after_other_clients_join) {
    // For 1 s every read takes 60 ms.
    Reader reader(0.001, [](double t) { return t > 5 && t < 6 ? 0.06 : 0.0005; });
    reader.play_until(20);
    EXPECT_GE(reader.read_between(9, 19), 597) << "the reader must receive all snapshots after 3 s";
}

TEST(FlowControl, adapts_to_an_increased_round_trip_time) {
    Reader reader(0.01, at_once());
    reader.play_until(10);
    reader.delay_s = 0.13;
    reader.play_until(40);
    EXPECT_EQ(reader.read_between(25, 39), 14 * 60) << "the reader must receive every tick again";
}

TEST(FlowControl, respects_the_requested_divider) {
    Reader reader(0.01, at_once(), 3);
    reader.play_until(10);
    EXPECT_EQ(reader.read_between(2, 8), 120);
    EXPECT_EQ(reader.flow().rate_skipped() + reader.flow().skipped(), 0u)
        << "the requested snapshot rate must not count as skipping";
}

TEST(FlowControl, ack_is_cumulative_and_invalid_acks_are_ignored) {
    FlowControl flow({}, rate_hz, 1);
    const Clock::time_point sent = Clock::time_point{} + 1h;
    for (std::uint32_t tick = 1; tick <= 3; ++tick) flow.on_sent(tick, sent);
    flow.on_ack(77, {}, sent);
    flow.on_ack(0, {}, sent);
    EXPECT_EQ(flow.in_flight(), 3);
    flow.on_ack(2, {}, sent + 10ms);
    EXPECT_EQ(flow.in_flight(), 1);
    flow.on_ack(1, {}, sent + 20ms);
    EXPECT_EQ(flow.in_flight(), 1);
    EXPECT_NEAR(flow.round_trip_s(), 0.010, 1e-6);
}

TEST(FlowControl, lost_snapshots_leave_the_window) {
    FlowControl flow({}, rate_hz, 1);
    const Clock::time_point begin = Clock::time_point{} + 1h;
    std::uint32_t tick = 1;
    for (; flow.may_send(tick, begin + tick * 16ms); ++tick)
        flow.on_sent(tick, begin + tick * 16ms);
    EXPECT_EQ(flow.in_flight(), 4) << "all sent snapshots must be in flight";
    flow.drop_sent_before(begin + 3 * 16ms);
    EXPECT_EQ(flow.in_flight(), 2);
    EXPECT_TRUE(flow.may_send(tick, begin + tick * 16ms));
    flow.drop_sent_before(begin + 1s);
    EXPECT_EQ(flow.in_flight(), 0);
    flow.on_ack(2, {}, begin + 1s);
    EXPECT_EQ(flow.in_flight(), 0) << "a late acknowledgement must have no effect";
}

// A client that looks at its clock only when a snapshot arrives, and acknowledges if 100 ms have
// passed: four snapshots arrive within 67 ms.
TEST(FlowControl, a_client_that_acknowledges_only_on_arrival_is_not_forgotten) {
    for (const double delay_s : {0.0, 0.05, 0.2}) {
        FlowControl flow({}, rate_hz, 1);
        struct Arrival {
            double at_s;
            std::uint32_t frame;
        };
        std::deque<Arrival> arrivals, acks;
        const auto at = [](double seconds) {
            return Clock::time_point{} + 1h + from_seconds(seconds);
        };
        double acked_s = 0, longest_gap_s = 0, last_s = 0;
        int received = 0;
        for (std::uint32_t tick = 1; tick < 20 * 60; tick++) {
            const double now_s = tick / rate_hz;
            for (; !arrivals.empty() && arrivals.front().at_s <= now_s; arrivals.pop_front()) {
                longest_gap_s = std::max(longest_gap_s, now_s - last_s);
                last_s = now_s;
                received++;
                if (now_s - acked_s < 0.1) continue;
                acked_s = now_s;
                acks.push_back({now_s + delay_s, arrivals.front().frame});
            }
            for (; !acks.empty() && acks.front().at_s <= now_s; acks.pop_front())
                flow.on_ack(acks.front().frame, 0ms, at(now_s));
            if (!flow.may_send(tick, at(now_s))) continue;
            flow.on_sent(tick, at(now_s));
            arrivals.push_back({now_s + delay_s, tick});
        }
        EXPECT_GT(received, 20 * 55) << delay_s;
        EXPECT_LT(longest_gap_s, 0.3 + 3 * delay_s) << delay_s;
    }
}

// A client that reads at once, behind links that deliver in order in each direction.
struct LinkResult {
    double snapshots_per_second = 0;  // sent, from 5 s on
    double longest_gap_s = 0;         // between two of them
    std::uint32_t slowed = 0;         // snapshots skipped by class
};
LinkResult stream_over(const NetworkConditions& conditions, double seconds) {
    FlowControl flow({}, rate_hz, 1);
    NetworkSimulator down(conditions, 1), up(conditions, 2);
    struct Message {
        std::int64_t at_us;
        std::uint32_t frame;
        std::int64_t held_us = 0;
    };
    std::deque<Message> arriving, acks;
    std::optional<Message> unacknowledged;
    std::int64_t last_ack_us = -1'000'000;
    double last_sent_s = 0;
    int sent = 0;
    LinkResult result;
    const auto at = [](std::int64_t us) {
        return Clock::time_point{} + 1h + std::chrono::microseconds(us);
    };
    // Steps of 1 ms; a tick is due every 16.7 ms.
    std::uint32_t tick = 0;
    for (std::int64_t us = 0; static_cast<double>(us) < seconds * 1e6; us += 1000) {
        while (!arriving.empty() && arriving.front().at_us <= us) {
            unacknowledged = arriving.front();
            arriving.pop_front();
        }
        if (unacknowledged && us - last_ack_us >= 100'000) {
            last_ack_us = us;
            acks.push_back(
                {up.send(us).arrival_us, unacknowledged->frame, us - unacknowledged->at_us});
            unacknowledged.reset();
        }
        for (; !acks.empty() && acks.front().at_us <= us; acks.pop_front())
            flow.on_ack(acks.front().frame, std::chrono::microseconds(acks.front().held_us),
                        at(us));
        if (static_cast<double>(us) * rate_hz < (tick + 1) * 1e6) continue;
        tick++;
        if (!flow.may_send(tick, at(us))) continue;
        flow.on_sent(tick, at(us));
        arriving.push_back({down.send(us, 1000).arrival_us, tick});
        const double now_s = static_cast<double>(us) / 1e6;
        if (now_s > 5) {
            sent++;
            result.longest_gap_s = std::max(result.longest_gap_s, now_s - last_sent_s);
        }
        last_sent_s = now_s;
    }
    result.snapshots_per_second = sent / (seconds - 5);
    result.slowed = flow.rate_skipped();
    return result;
}

TEST(FlowControl, long_links_with_jitter_get_every_tick) {
    for (const double round_trip_ms : {100.0, 250.0, 400.0, 500.0})
        for (const double jitter_ms : {0.0, 20.0, 80.0})
            for (std::uint32_t seed = 1; seed <= 10; seed++) {
                const LinkResult result = stream_over(
                    {.latency_ms = round_trip_ms / 2, .jitter_ms = jitter_ms, .seed = seed}, 60);
                EXPECT_GE(result.snapshots_per_second, 59.5)
                    << round_trip_ms << " ms, jitter " << jitter_ms << " ms, seed " << seed;
                EXPECT_LE(result.longest_gap_s, 0.1)
                    << round_trip_ms << " ms, jitter " << jitter_ms << " ms, seed " << seed;
            }
}

// TCP sends a lost segment again after about a round trip, and everything behind it waits.
TEST(FlowControl, a_retransmission_does_not_look_like_a_queue) {
    for (std::uint32_t seed = 1; seed <= 20; seed++) {
        const LinkResult result =
            stream_over({.latency_ms = 90, .loss = 0.02, .retransmit_ms = 190, .seed = seed}, 60);
        EXPECT_GE(result.snapshots_per_second, 56) << "seed " << seed;
        EXPECT_LE(result.slowed, 0.03 * 60 * rate_hz) << "seed " << seed;
    }
}

}  // namespace
}  // namespace jostle::server
