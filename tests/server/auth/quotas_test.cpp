// SPDX-License-Identifier: MIT
#include "server/auth/quotas.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

const Clock::time_point start{};

int grants(Quotas& quotas, QuotaKind work, const std::string& subject, const std::string& network,
           int tries, Clock::time_point now = start) {
    int granted = 0;
    for (int i = 0; i < tries; ++i)
        if (quotas.take(work, subject, network, now).granted) ++granted;
    return granted;
}

TEST(Quotas, allows_a_one_minute_burst_then_the_refill_rate) {
    Quotas quotas({.creates_per_minute = 20});
    EXPECT_EQ(grants(quotas, QuotaKind::creates, "anna", "192.0.2.1", 100), 20);
    const Quotas::QuotaDecision no = quotas.take(QuotaKind::creates, "anna", "192.0.2.1", start);
    EXPECT_FALSE(no.granted);
    EXPECT_NEAR(to_ms(no.retry_after), 3000, 2) << "one per 3 s";
    EXPECT_FALSE(quotas.take(QuotaKind::creates, "anna", "192.0.2.1", start + 2990ms).granted);
    EXPECT_TRUE(
        quotas.take(QuotaKind::creates, "anna", "192.0.2.1", start + no.retry_after).granted)
        << "a client that waits for retry_after is admitted";
    EXPECT_EQ(grants(quotas, QuotaKind::creates, "anna", "192.0.2.1", 100, start + 10min), 20);
}

TEST(Quotas, allows_a_one_second_burst_of_queries) {
    Quotas quotas({.queries_per_second = 50});
    EXPECT_EQ(grants(quotas, QuotaKind::queries, "anna", "192.0.2.1", 1000), 50);
    EXPECT_NEAR(to_ms(quotas.peek(QuotaKind::queries, "anna", "192.0.2.1", start).retry_after), 20,
                2);
}

TEST(Quotas, limits_subjects_individually_and_their_address_by_factor_ten) {
    Quotas quotas({.joins_per_minute = 5, .address_factor = 10});
    int granted = 0;
    for (int i = 0; i < 30; ++i)
        granted += grants(quotas, QuotaKind::joins, "s" + std::to_string(i), "192.0.2.1", 100);
    EXPECT_EQ(granted, 50);
    EXPECT_EQ(grants(quotas, QuotaKind::joins, "s0", "192.0.2.2", 1), 0)
        << "the quota of the subject is used up";
    EXPECT_EQ(grants(quotas, QuotaKind::joins, "new", "192.0.2.2", 100), 5);
    EXPECT_EQ(grants(quotas, QuotaKind::joins, "", "192.0.2.3", 100), 50)
        << "anonymous clients count by address";
}

TEST(Quotas, rejected_requests_consume_no_tokens) {
    Quotas quotas({.joins_per_minute = 1, .address_factor = 2});
    EXPECT_EQ(grants(quotas, QuotaKind::joins, "anna", "192.0.2.1", 100), 1);
    EXPECT_EQ(grants(quotas, QuotaKind::joins, "berta", "192.0.2.1", 100), 1)
        << "a rejected call does not consume the quota of the address";
}

TEST(Quotas, quota_kinds_are_independent) {
    Quotas quotas({.creates_per_minute = 1, .refused_logins_per_minute = 3});
    EXPECT_EQ(grants(quotas, QuotaKind::creates, "anna", "192.0.2.1", 9), 1);
    EXPECT_EQ(grants(quotas, QuotaKind::joins, "anna", "192.0.2.1", 9), 9);
    EXPECT_EQ(grants(quotas, QuotaKind::refused_logins, "", "192.0.2.1", 9), 3)
        << "the address factor does not apply to failures";
}

TEST(Quotas, evicts_the_least_recently_used_bucket) {
    Quotas quotas({.creates_per_minute = 1, .address_factor = 1, .buckets_max = 100});
    for (int i = 0; i < 100000; ++i) {
        quotas.take(QuotaKind::creates, "",
                    "10.0." + std::to_string(i / 256) + "." + std::to_string(i % 256), start);
        if (i % 50 == 0) quotas.take(QuotaKind::creates, "", "192.0.2.1", start);
    }
    EXPECT_EQ(quotas.buckets(), 100u);
    EXPECT_FALSE(quotas.take(QuotaKind::creates, "", "192.0.2.1", start).granted)
        << "an active bucket is not evicted";
}

}  // namespace
}  // namespace jostle::server
