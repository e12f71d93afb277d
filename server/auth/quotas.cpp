// SPDX-License-Identifier: MIT
#include "server/auth/quotas.h"

#include <algorithm>
#include <string>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// The rate and burst of a bucket.
struct BucketRate {
    double per_second = 1, burst = 1;
};

BucketRate per_minute(double count) {
    return {count / 60, count};
}

BucketRate of_subject(QuotaKind work, const QuotaSettings& s) {
    switch (work) {
        case QuotaKind::creates:
            return per_minute(s.creates_per_minute);
        case QuotaKind::joins:
            return per_minute(s.joins_per_minute);
        case QuotaKind::queries:
            return {s.queries_per_second, s.queries_per_second};
        case QuotaKind::refused_logins:
            return per_minute(s.refused_logins_per_minute);
        case QuotaKind::audited_refusals:
            return per_minute(s.refusals_audited_per_minute);
    }
    return {};
}

BucketRate of_address(QuotaKind work, const QuotaSettings& s) {
    BucketRate rate = of_subject(work, s);
    if (work == QuotaKind::refused_logins || work == QuotaKind::audited_refusals) return rate;
    rate.per_second *= s.address_factor;
    rate.burst *= s.address_factor;
    return rate;
}

}  // namespace

// take() needs both of its buckets at the same time, hence at least 2.
Quotas::Quotas(const QuotaSettings& settings)
    : settings_(settings), buckets_(static_cast<std::size_t>(std::max(2, settings.buckets_max))) {}

Quotas::QuotaDecision Quotas::take(QuotaKind work, std::string_view subject,
                                   std::string_view network, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    const QuotaDecision decision = peek_locked(work, subject, network, now);
    if (!decision.granted) return decision;
    if (!subject.empty()) bucket_of(work, true, subject, now).take(1, now);
    bucket_of(work, false, network, now).take(1, now);
    return decision;
}

Quotas::QuotaDecision Quotas::peek(QuotaKind work, std::string_view subject,
                                   std::string_view network, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    return peek_locked(work, subject, network, now);
}

std::size_t Quotas::buckets() const {
    const std::lock_guard lock(mutex_);
    return buckets_.size();
}

TokenBucket& Quotas::bucket_of(QuotaKind work, bool subjects, std::string_view name,
                               Clock::time_point now) {
    std::string key{static_cast<char>('0' + static_cast<int>(work)), subjects ? 's' : 'a'};
    key += name;
    return buckets_.find_or_make(key, [&] {
        const BucketRate a = subjects ? of_subject(work, settings_) : of_address(work, settings_);
        return TokenBucket(a.per_second, a.burst, now);
    });
}

Quotas::QuotaDecision Quotas::peek_locked(QuotaKind work, std::string_view subject,
                                          std::string_view network, Clock::time_point now) {
    Clock::duration wait = bucket_of(work, false, network, now).wait_for(1, now);
    if (!subject.empty())
        wait = std::max(wait, bucket_of(work, true, subject, now).wait_for(1, now));
    ASSERT(wait >= Clock::duration::zero());
    return {wait == Clock::duration::zero(), wait};
}

}  // namespace jostle::server
