// SPDX-License-Identifier: MIT
#include "server/util/token_bucket.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

TEST(TokenBucket, allows_a_burst_then_the_refill_rate) {
    const Clock::time_point now{};
    TokenBucket bucket(2, 10, now);
    EXPECT_TRUE(bucket.take(10, now));
    EXPECT_FALSE(bucket.take(1, now));
    EXPECT_FALSE(bucket.take(1, now + 499ms));
    EXPECT_TRUE(bucket.take(1, now + 500ms));
    EXPECT_TRUE(bucket.take(10, now + 1h));
    EXPECT_FALSE(bucket.take(1, now + 1h)) << "the bucket must not exceed its capacity";
}

TEST(TokenBucket, take_succeeds_after_the_reported_wait) {
    for (const double rate : {0.01, 1.0 / 3, 0.7, 3.0, 1e6}) {
        const Clock::time_point now{};
        TokenBucket bucket(rate, 5, now);
        EXPECT_EQ(bucket.wait_for(5, now), Clock::duration::zero());
        ASSERT_TRUE(bucket.take(5, now));
        const Clock::duration wait = bucket.wait_for(1, now);
        EXPECT_NEAR(to_ms(wait), 1000 / rate, 2);
        EXPECT_TRUE(bucket.take(1, now + wait)) << rate;
    }
}

TEST(TokenBucket, out_of_order_times_do_not_refill_twice) {
    const Clock::time_point now = Clock::time_point{} + 1h;
    TokenBucket bucket(1, 1, now);
    ASSERT_TRUE(bucket.take(1, now));
    EXPECT_FALSE(bucket.take(1, now - 10s));
    EXPECT_FALSE(bucket.take(1, now));
    EXPECT_TRUE(bucket.take(1, now + 1s));
}

}  // namespace
}  // namespace jostle::server
