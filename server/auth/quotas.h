// SPDX-License-Identifier: MIT
//
// How much one subject, and one address, may ask for: a token bucket for each and each kind of
// work. Their number is bounded; the one that was idle longest goes first, and it is as good as
// full by then. Any thread.
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
        Clock::duration retry_after{};  // when it is not
    };
    // One piece of work of that subject (empty: of the address alone) from that network
    // (base/address.h). Takes from both buckets or from none.
    QuotaDecision take(QuotaKind work, std::string_view subject, std::string_view network,
                       Clock::time_point now);
    // What take() would answer.
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
