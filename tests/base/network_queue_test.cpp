// SPDX-License-Identifier: MIT
#include "jostle/base/network_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace jostle {
namespace {

using namespace std::chrono_literals;

const std::chrono::steady_clock::time_point start(1000s);

}  // namespace

TEST(NetworkQueue, releases_messages_in_order_at_their_arrival_times) {
    NetworkQueue<std::string> queue({.latency_ms = 80});
    queue.push("first", start);
    queue.push("second", start + 10ms);
    EXPECT_EQ(queue.bytes(), 11u);
    EXPECT_EQ(queue.next_arrival(), start + 80ms);
    EXPECT_EQ(queue.front(start + 79ms), nullptr);
    EXPECT_EQ(*queue.front(start + 80ms), "first");
    EXPECT_EQ(queue.take(start + 80ms), "first");
    EXPECT_EQ(queue.take(start + 80ms), std::nullopt);
    EXPECT_EQ(queue.take_next(), "second") << "before its arrival";
    EXPECT_EQ(queue.take_next(), std::nullopt);
    EXPECT_TRUE(queue.empty());
    EXPECT_EQ(queue.bytes(), 0u);
}

TEST(NetworkQueue, a_full_stream_accepts_messages_and_reports_that_it_is_full) {
    NetworkQueue<std::string> queue({.latency_ms = 80, .queue_bytes = 100});
    EXPECT_TRUE(queue.push(std::string(99, 'a'), start));
    EXPECT_FALSE(queue.full());
    EXPECT_TRUE(queue.push(std::string(99, 'b'), start));
    EXPECT_TRUE(queue.full());
    EXPECT_TRUE(queue.push("c", start));
    queue.take_next();
    EXPECT_TRUE(queue.full());
    queue.take_next();
    EXPECT_FALSE(queue.full());
}

TEST(NetworkQueue, drops_datagrams_beyond_its_size) {
    NetworkQueue<std::string> queue({.latency_ms = 80, .queue_bytes = 100}, 0, Delivery::datagrams);
    EXPECT_TRUE(queue.push(std::string(100, 'a'), start));
    EXPECT_FALSE(queue.push("b", start));
    queue.take(start + 80ms);
    EXPECT_TRUE(queue.push("c", start + 80ms));
}

TEST(NetworkQueue, delivers_duplicated_and_reordered_datagrams_by_arrival_time) {
    NetworkQueue<int> queue(
        {.latency_ms = 10, .loss = 0.1, .duplicate = 0.2, .reorder = 0.3, .reorder_ms = 5}, 0,
        Delivery::datagrams);
    int lost = 0, copies = 0, overtaken = 0, greatest = -1;
    for (int k = 0; k < 1000; k++) lost += queue.push(k, 1, start + k * 1ms) ? 0 : 1;
    auto last = start;
    for (; !queue.empty(); copies++) {
        EXPECT_GE(queue.next_arrival(), last);
        last = queue.next_arrival();
        const int k = *queue.take(last);
        overtaken += k < greatest ? 1 : 0;
        greatest = std::max(greatest, k);
    }
    EXPECT_NEAR(lost, 100, 30);
    EXPECT_NEAR(copies, 900 * 1.2, 60);
    EXPECT_NEAR(overtaken, 900 * 1.2 * 0.3, 60);
}

}  // namespace jostle
