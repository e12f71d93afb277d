// SPDX-License-Identifier: MIT
#include "jostle/datagram/replay_window.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace jostle::datagram {

TEST(ReplayWindow, accepts_each_number_once_in_any_order) {
    ReplayWindow window;
    for (const std::uint64_t number : {5u, 3u, 9u, 4u}) {
        EXPECT_FALSE(window.seen(number)) << number;
        window.add(number);
        EXPECT_TRUE(window.seen(number)) << number;
    }
    EXPECT_FALSE(window.seen(0));
    EXPECT_FALSE(window.seen(8));
    EXPECT_TRUE(window.is_newest(9));
    EXPECT_FALSE(window.is_newest(8));
}

TEST(ReplayWindow, tracks_1024_numbers_and_rejects_older_ones) {
    ReplayWindow window;
    window.add(2000);
    EXPECT_FALSE(window.seen(2000 - 1023));
    EXPECT_TRUE(window.seen(2000 - 1024));
    window.add(2000 - 1023);
    EXPECT_TRUE(window.seen(2000 - 1023));
    window.add(1'000'000);
    EXPECT_TRUE(window.seen(2000)) << "number below the window";
    EXPECT_FALSE(window.seen(999'999));
    window.add(~std::uint64_t{0});
    EXPECT_TRUE(window.seen(1'000'000));
    EXPECT_FALSE(window.seen(~std::uint64_t{0} - 1));
}

// Reference: a set of all numbers.
TEST(ReplayWindow, matches_a_reference_set_over_20000_numbers) {
    std::mt19937_64 random(7);
    ReplayWindow window;
    std::set<std::uint64_t> came;
    std::uint64_t newest = 0;
    for (int i = 0; i < 20'000; i++) {
        const std::uint64_t about = newest + (i % 100 == 0 ? random() % 3000 : random() % 20);
        const std::uint64_t back = random() % 1500;
        const std::uint64_t number = about > back ? about - back : about;
        const bool old = !came.empty() && number + ReplayWindow::size <= newest;
        ASSERT_EQ(window.seen(number), old || came.contains(number)) << number << " of " << newest;
        window.add(number);
        if (!old) came.insert(number);
        newest = std::max(newest, number);
    }
}

}  // namespace jostle::datagram
