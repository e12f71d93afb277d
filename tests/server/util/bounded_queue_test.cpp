// SPDX-License-Identifier: MIT
#include "server/util/bounded_queue.h"

#include <gtest/gtest.h>

#include <thread>

namespace jostle::server {
namespace {

TEST(BoundedQueue, rejects_items_when_full) {
    BoundedQueue<int> queue(2);
    EXPECT_TRUE(queue.push(1));
    EXPECT_TRUE(queue.push(2));
    EXPECT_FALSE(queue.push(3));
    std::vector<int> out{9};
    queue.drain_into(out);
    EXPECT_EQ(out, (std::vector<int>{1, 2}));
    EXPECT_TRUE(queue.push(4));
}

TEST(BoundedQueue, preserves_per_writer_order_without_loss) {
    constexpr int writers = 4, each = 1000;
    BoundedQueue<int> queue(64);
    std::vector<std::thread> threads;
    for (int w = 0; w < writers; ++w) {
        threads.emplace_back([&, w] {
            for (int i = 0; i < each; ++i) {
                while (!queue.push(w * each + i)) std::this_thread::yield();
            }
        });
    }
    std::vector<int> next(writers, 0), batch;
    for (int taken = 0; taken < writers * each; taken += static_cast<int>(batch.size())) {
        queue.drain_into(batch);
        for (const int item : batch) {
            EXPECT_EQ(item % each, next[static_cast<std::size_t>(item / each)]++);
        }
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(queue.size(), 0u);
}

}  // namespace
}  // namespace jostle::server
