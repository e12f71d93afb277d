// SPDX-License-Identifier: MIT
#include "jostle/client/network_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace jostle::client {
namespace {

// Transit time of each of `count` messages, 60 per second, ms.
std::vector<double> ways_of(const NetworkConditions& settings, int count = 36'000) {
    NetworkSimulator network(settings);
    std::vector<double> ways;
    std::int64_t last = 0;
    for (int k = 0; k < count; k++) {
        const std::int64_t sent = k * 16'667LL, arrives = network.arrival_us(sent);
        EXPECT_GE(arrives, last) << "messages must not be reordered";
        last = arrives;
        ways.push_back(static_cast<double>(arrives - sent) / 1000);
    }
    return ways;
}

double mean_ms(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

}  // namespace

TEST(NetworkSimulator, applies_exactly_the_configured_delay) {
    const auto ways = ways_of({.delay_ms = 80});
    EXPECT_EQ(*std::min_element(ways.begin(), ways.end()), 80);
    EXPECT_EQ(*std::max_element(ways.begin(), ways.end()), 80);
}

TEST(NetworkSimulator, draws_uniform_jitter_with_an_exponential_tail) {
    const auto even = ways_of({.delay_ms = 10, .jitter_ms = 16});
    EXPECT_NEAR(mean_ms(even), 18, 0.1);
    EXPECT_LE(*std::max_element(even.begin(), even.end()), 26);
    const auto tail = ways_of({.delay_ms = 10, .tail_ms = 4});
    EXPECT_NEAR(mean_ms(tail), 14, 0.2);
    // exp(-20 / 4) = 0.67 % of the messages wait longer than 20 ms, and a few more behind them.
    const auto late = std::count_if(tail.begin(), tail.end(), [](double ms) { return ms > 30; });
    EXPECT_NEAR(static_cast<double>(late) / 36'000, 0.0067, 0.002);
}

TEST(NetworkSimulator, stalls_at_the_configured_interval_and_delays_later_messages) {
    const auto ways = ways_of({.stalls_ms = 250, .stall_every_ms = 5000});
    int stalls = 0;
    for (std::size_t k = 1; k < ways.size(); k++)
        stalls += ways[k] > 200 && ways[k - 1] < 100 ? 1 : 0;
    EXPECT_NEAR(stalls, 120, 8);  // in 600 s
    EXPECT_LT(*std::max_element(ways.begin(), ways.end()), 250.1);
}

TEST(NetworkSimulator, delivers_lost_messages_one_retransmission_later) {
    const auto ways = ways_of({.delay_ms = 10, .loss = 0.01, .retransmit_ms = 200});
    // A lost frame delays all frames of the next 200 ms; one frame in a hundred is lost.
    const auto late = std::count_if(ways.begin(), ways.end(), [](double ms) { return ms > 10; });
    EXPECT_NEAR(static_cast<double>(late) / 36'000, 0.105, 0.02);
    EXPECT_NEAR(*std::max_element(ways.begin(), ways.end()), 210, 1);
}

TEST(NetworkSimulator, is_deterministic_per_seed_in_every_language) {
    NetworkSimulator network({.delay_ms = 40,
                              .jitter_ms = 20,
                              .tail_ms = 5,
                              .stalls_ms = 100,
                              .stall_every_ms = 500,
                              .loss = 0.05,
                              .seed = 7});
    std::int64_t sum = 0;
    for (int k = 0; k < 1000; k++) sum += network.arrival_us(k * 16'667LL) - k * 16'667LL;
    EXPECT_EQ(sum, 109'097'580);  // the web SDK's network_simulator.test.ts expects the same number
}

TEST(NetworkSimulator, parses_a_settings_string_and_reports_errors) {
    const auto network =
        parse_network_conditions("delay=80,jitter=20.5,stalls=250,loss=0.02,seed=9");
    ASSERT_TRUE(network.ok());
    EXPECT_EQ(network->delay_ms, 80);
    EXPECT_EQ(network->jitter_ms, 20.5);
    EXPECT_EQ(network->stalls_ms, 250);
    EXPECT_EQ(network->loss, 0.02);
    EXPECT_EQ(network->seed, 9u);
    EXPECT_TRUE(network->impaired());
    EXPECT_FALSE(parse_network_conditions("")->impaired());
    for (const char* wrong : {"delay", "delay=", "delay=-1", "delay=nan", "delay=99999", "loss=2",
                              "speed=3", "delay=5ms", "seed=5000000000"}) {
        const auto read = parse_network_conditions(wrong);
        ASSERT_FALSE(read.ok()) << wrong;
        EXPECT_NE(read.error().message.find(wrong), std::string::npos);
    }
}

}  // namespace jostle::client
