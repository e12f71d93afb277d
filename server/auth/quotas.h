// SPDX-License-Identifier: MIT
//
// Rate limits per subject and per address: one token bucket for each of them and each kind of work.
// The number of buckets is bounded; the longest idle one is evicted first, and has refilled by
// then. Any thread.
#pragma once

#include <mutex>
#include <string_view>

#include "server/auth/lru_map.h"
#include "server/config/config.h"
#include "server/util/token_bucket.h"

namespace jostle::server {

enum class QuotaKind { creates, joins, queries, refused_logins, audited_refusals };

class Quotas {
public:
    explicit Quotas(const QuotaSettings& settings);

    struct QuotaDecision {
        bool granted = true;
        Clock::duration retry_after{};  // set if not granted
    };
    // Charges one unit of work to the subject (empty: to the address alone) and to the network
    // (util/address.h). Takes from both buckets or from neither.
    QuotaDecision take(QuotaKind work, std::string_view subject, std::string_view network,
                       Clock::time_point now);
    // The decision take() would make, without taking.
    QuotaDecision peek(QuotaKind work, std::string_view subject, std::string_view network,
                       Clock::time_point now);

    std::size_t buckets() const;

private:
    TokenBucket& bucket_of(QuotaKind work, bool of_subject, std::string_view name,
                           Clock::time_point now);
    QuotaDecision peek_locked(QuotaKind work, std::string_view subject, std::string_view network,
                              Clock::time_point now);

    const QuotaSettings settings_;
    mutable std::mutex mutex_;
    LruMap<TokenBucket> buckets_;
};

}  // namespace jostle::server
