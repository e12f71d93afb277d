// SPDX-License-Identifier: MIT
#include "server/session/flood_guard.h"

#include <gtest/gtest.h>

#include "tests/server/session/session_start.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using Verdict = FloodGuard::Verdict;

TEST(FloodGuard, notifies_at_most_once_per_second) {
    FloodGuard guard(10);
    EXPECT_EQ(guard.on_excess(start), Verdict::notify);
    EXPECT_EQ(guard.on_excess(start + 10ms), Verdict::drop);
    EXPECT_EQ(guard.on_excess(start + 999ms), Verdict::drop);
    EXPECT_EQ(guard.on_excess(start + 1000ms), Verdict::notify);
}

TEST(FloodGuard, disconnects_beyond_five_times_the_rate) {
    FloodGuard guard(10);
    ASSERT_EQ(guard.on_excess(start), Verdict::notify);
    for (int message = 2; message <= 50; message++)
        ASSERT_EQ(guard.on_excess(start + 1ms), Verdict::drop) << message;
    EXPECT_EQ(guard.on_excess(start + 1ms), Verdict::disconnect);
}

}  // namespace
}  // namespace jostle::server
