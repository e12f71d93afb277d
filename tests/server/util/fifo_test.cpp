// SPDX-License-Identifier: MIT
#include "server/util/fifo.h"

#include <gtest/gtest.h>

#include <deque>
#include <memory>

#include "tests/support/random.h"

namespace jostle::server {
namespace {

// 20,000 calls in random order, compared with a deque.
TEST(Fifo, behaves_like_a_deque) {
    test::Random random(3);
    Fifo<int> fifo;
    std::deque<int> deque;
    for (int k = 0; k < 20'000; k++) {
        const auto what = random.below(12);
        if (what < 6 || deque.empty()) {
            fifo.push_back(k);
            deque.push_back(k);
        } else if (what < 9) {
            fifo.pop_front();
            deque.pop_front();
        } else if (what == 9) {
            fifo.pop_back();
            deque.pop_back();
        } else if (what == 10) {
            const std::size_t count = random.below(deque.size() + 1);
            fifo.pop_front(count);
            deque.erase(deque.begin(), deque.begin() + static_cast<std::ptrdiff_t>(count));
        } else if (random.below(50) == 0) {
            fifo.clear();
            deque.clear();
        }
        ASSERT_EQ(fifo.size(), deque.size());
        ASSERT_EQ(fifo.empty(), deque.empty());
        ASSERT_TRUE(std::equal(fifo.begin(), fifo.end(), deque.begin(), deque.end()));
        ASSERT_TRUE(std::equal(fifo.rbegin(), fifo.rend(), deque.rbegin(), deque.rend()));
        if (deque.empty()) continue;
        ASSERT_EQ(fifo.front(), deque.front());
        ASSERT_EQ(fifo.back(), deque.back());
        ASSERT_EQ(fifo[deque.size() / 2], deque[deque.size() / 2]);
    }
}

TEST(Fifo, releases_popped_items) {
    Fifo<std::shared_ptr<int>> fifo;
    const auto first = std::make_shared<int>(1), second = std::make_shared<int>(2);
    for (const auto& item : {first, second, second, second}) fifo.push_back(item);
    fifo.pop_front();
    EXPECT_EQ(first.use_count(), 1);
    fifo.pop_front(2);
    EXPECT_EQ(second.use_count(), 2);
    fifo.clear();
    EXPECT_EQ(second.use_count(), 1);
}

}  // namespace
}  // namespace jostle::server
