// SPDX-License-Identifier: MIT
#include "jostle/base/network_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

namespace jostle {
namespace {

// Transit time of each of `count` messages of a stream, 60 per second, ms.
std::vector<double> transit_times(const NetworkConditions& conditions, int count = 36'000,
                                  std::size_t bytes = 0) {
    NetworkSimulator network(conditions);
    std::vector<double> times;
    std::int64_t last = 0;
    for (int k = 0; k < count; k++) {
        const std::int64_t sent = k * 16'667LL, arrival = network.send(sent, bytes).arrival_us;
        EXPECT_GE(arrival, last) << "messages must not be reordered";
        last = arrival;
        times.push_back(static_cast<double>(arrival - sent) / 1000);
    }
    return times;
}

std::vector<Transit> datagrams(const NetworkConditions& conditions, int count = 100'000,
                               std::uint32_t path = 0) {
    NetworkSimulator network(conditions, path, Delivery::datagrams);
    std::vector<Transit> transits;
    for (int k = 0; k < count; k++) transits.push_back(network.send(k * 1000LL, 1000));
    return transits;
}

double mean_ms(const std::vector<double>& values) {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

double fraction(std::ptrdiff_t count, std::ptrdiff_t of) {
    return static_cast<double>(count) / static_cast<double>(of);
}

}  // namespace

TEST(NetworkSimulator, applies_exactly_the_configured_latency) {
    const auto times = transit_times({.latency_ms = 80});
    EXPECT_EQ(*std::min_element(times.begin(), times.end()), 80);
    EXPECT_EQ(*std::max_element(times.begin(), times.end()), 80);
}

TEST(NetworkSimulator, draws_uniform_jitter_with_an_exponential_tail) {
    const auto uniform = transit_times({.latency_ms = 10, .jitter_ms = 16});
    EXPECT_NEAR(mean_ms(uniform), 18, 0.1);
    EXPECT_GE(*std::min_element(uniform.begin(), uniform.end()), 10);
    EXPECT_LE(*std::max_element(uniform.begin(), uniform.end()), 26);
    const auto tail = transit_times({.latency_ms = 10, .jitter_tail_ms = 4});
    EXPECT_NEAR(mean_ms(tail), 14, 0.2);
    // exp(-20 / 4) = 0.67 % of the messages wait longer than 20 ms, and a few more behind them.
    const auto late = std::count_if(tail.begin(), tail.end(), [](double ms) { return ms > 30; });
    EXPECT_NEAR(fraction(late, 36'000), 0.0067, 0.002);
}

TEST(NetworkSimulator, stalls_at_the_configured_interval_and_delays_later_messages) {
    const auto times = transit_times({.stall_ms = 250, .stall_interval_ms = 5000});
    int stalls = 0;
    for (std::size_t k = 1; k < times.size(); k++)
        stalls += times[k] > 200 && times[k - 1] < 100 ? 1 : 0;
    EXPECT_NEAR(stalls, 120, 8);  // in 600 s
    EXPECT_LT(*std::max_element(times.begin(), times.end()), 250.1);
    const auto late = std::count_if(times.begin(), times.end(), [](double ms) { return ms > 0; });
    EXPECT_NEAR(fraction(late, 36'000), 0.05, 0.005) << "250 ms of 5 s";
}

TEST(NetworkSimulator, limits_throughput_to_the_configured_rate) {
    // A message of 1 kB every 16.667 ms takes 20 ms: the delay grows by 3.333 ms per message.
    const auto times = transit_times({.rate_kbps = 400}, 100, 1000);
    for (std::size_t k = 0; k < times.size(); k++)
        EXPECT_NEAR(times[k], 20 + 3.333 * static_cast<double>(k), 1e-3) << k;
    const auto idle = transit_times({.rate_kbps = 4000}, 100, 1000);
    EXPECT_NEAR(*std::max_element(idle.begin(), idle.end()), 2, 1e-3);
}

TEST(NetworkSimulator, delivers_lost_messages_of_a_stream_one_retransmission_later) {
    const auto times = transit_times({.latency_ms = 10, .loss = 0.01, .retransmit_ms = 200});
    // A lost message delays all messages of the next 200 ms; one message in a hundred is lost.
    const auto late = std::count_if(times.begin(), times.end(), [](double ms) { return ms > 10; });
    EXPECT_NEAR(fraction(late, 36'000), 0.105, 0.02);
    EXPECT_NEAR(*std::max_element(times.begin(), times.end()), 210, 1);
}

TEST(NetworkSimulator, drops_the_configured_fraction_of_datagrams_in_bursts) {
    const auto losses = [](double burst) {
        int lost = 0, bursts = 0;
        bool previous = false;
        for (const Transit& transit : datagrams({.loss = 0.1, .loss_burst = burst})) {
            const bool now = transit.copies == 0;
            lost += now ? 1 : 0;
            bursts += now && !previous ? 1 : 0;
            previous = now;
        }
        return std::pair(fraction(lost, 100'000), fraction(lost, bursts));
    };
    const auto [single, single_length] = losses(1);
    EXPECT_NEAR(single, 0.1, 0.005);
    EXPECT_NEAR(single_length, 1 / 0.9, 0.03) << "losses are independent";
    const auto [burst, burst_length] = losses(8);
    EXPECT_NEAR(burst, 0.1, 0.01);
    EXPECT_NEAR(burst_length, 8, 0.5);
    for (const Transit& transit : datagrams({.loss = 1, .loss_burst = 8}, 100))
        EXPECT_EQ(transit.copies, 0);
}

TEST(NetworkSimulator, duplicates_and_reorders_datagrams_only) {
    const NetworkConditions conditions{
        .latency_ms = 5, .duplicate = 0.02, .reorder = 0.05, .reorder_ms = 3};
    int duplicated = 0, overtaken = 0;
    std::int64_t k = 0;
    for (const Transit& transit : datagrams(conditions)) {
        const std::int64_t transit_us = transit.arrival_us - 1000 * k++;
        duplicated += transit.copies == 2 ? 1 : 0;
        overtaken += transit_us == 8000 ? 1 : 0;
        EXPECT_TRUE(transit_us == 5000 || transit_us == 8000);
    }
    EXPECT_NEAR(fraction(duplicated, 100'000), 0.02, 0.002);
    EXPECT_NEAR(fraction(overtaken, 100'000), 0.05, 0.003);
    for (const double ms : transit_times(conditions, 100)) EXPECT_EQ(ms, 5);
}

TEST(NetworkSimulator, is_deterministic_per_seed_and_path) {
    const auto arrivals = [](std::uint32_t seed, std::uint32_t path) {
        std::vector<std::int64_t> all;
        for (const Transit& transit :
             datagrams({.jitter_ms = 20, .stall_ms = 10, .stall_interval_ms = 100, .seed = seed},
                       1000, path))
            all.push_back(transit.arrival_us);
        return all;
    };
    EXPECT_EQ(arrivals(1, 4), arrivals(1, 4));
    EXPECT_NE(arrivals(1, 4), arrivals(1, 5));
    EXPECT_NE(arrivals(1, 4), arrivals(2, 4));
}

// network_simulator.test.ts of the web SDK reads the same file.
TEST(NetworkSimulator, produces_the_arrival_times_of_the_shared_vectors) {
    std::ifstream file(VECTORS);
    for (const auto& vector : nlohmann::json::parse(file)) {
        std::string text;
        for (const auto& [name, value] : vector["conditions"].items())
            text += (text.empty() ? "" : ",") + name + "=" + value.dump();
        const auto conditions = parse_network_conditions(text);
        ASSERT_TRUE(conditions.ok()) << conditions.error().message;
        NetworkSimulator network(
            *conditions, vector["path"].get<std::uint32_t>(),
            vector["delivery"] == "stream" ? Delivery::stream : Delivery::datagrams);
        std::int64_t sent_us = 0;
        for (const auto& expected : vector["transits"]) {
            const Transit transit = network.send(sent_us, vector["bytes"].get<std::size_t>());
            EXPECT_EQ(transit.copies, expected[0].get<int>()) << text << " at " << sent_us;
            EXPECT_EQ(transit.arrival_us, expected[1].get<std::int64_t>()) << text;
            sent_us += vector["interval_us"].get<std::int64_t>();
        }
    }
}

// Unchanged since the first version, so that recorded measurements stay comparable.
TEST(NetworkSimulator, reproduces_a_long_stream_from_its_seed) {
    NetworkSimulator network({.latency_ms = 40,
                              .jitter_ms = 20,
                              .jitter_tail_ms = 5,
                              .stall_ms = 100,
                              .stall_interval_ms = 500,
                              .loss = 0.05,
                              .seed = 7});
    std::int64_t sum = 0;
    for (int k = 0; k < 1000; k++) sum += network.send(k * 16'667LL).arrival_us - k * 16'667LL;
    EXPECT_EQ(sum, 109'097'580);
}

}  // namespace jostle
