// SPDX-License-Identifier: MIT
#include "server/limits/query_budget.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// A full balance is the share of this time.
constexpr double burst_seconds = 1;
// Shortest time to retry, so that refused clients do not keep the server busy with refusals.
constexpr double retry_seconds_min = 0.1;

}  // namespace

QueryBudget::QueryBudget(double share) : share_(share) {
    ASSERT(share >= 0);
}

void QueryBudget::refill(Clock::time_point now) {
    if (now <= refilled_) return;  // threads may pass times out of order
    const double passed = std::chrono::duration<double>(now - refilled_).count();
    refilled_ = now;
    if (balances_.empty()) return;
    const double each = share_ * passed / static_cast<double>(balances_.size());
    for (auto& [account, balance] : balances_) balance += each;
    std::erase_if(balances_,
                  [&](const auto& entry) { return entry.second >= share_ * burst_seconds; });
}

Status QueryBudget::admit(AccountId account, Clock::time_point now) {
    if (share_ == 0) return {};
    const std::lock_guard lock(mutex_);
    refill(now);
    const auto known = balances_.find(account);
    if (known == balances_.end() || known->second > 0) return {};
    const double each = share_ / static_cast<double>(balances_.size());
    const double wait = std::max(retry_seconds_min, -known->second / each);
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("the queries of this player take more than its share of the "
                             "processor time for queries; retry after {:.1f} s",
                             wait),
                 static_cast<int>(std::ceil(1000 * wait))};
}

// Many new accounts together have little more than one full balance.
void QueryBudget::charge(AccountId account, double cpu_seconds, Clock::time_point now) {
    ASSERT(!(cpu_seconds < 0));
    if (share_ == 0) return;
    const std::lock_guard lock(mutex_);
    refill(now);
    const double first = share_ * burst_seconds / static_cast<double>(balances_.size() + 1);
    balances_.try_emplace(account, first).first->second -= cpu_seconds;
}

std::size_t QueryBudget::accounts() const {
    const std::lock_guard lock(mutex_);
    return balances_.size();
}

QueryBudget::Spending::Spending(QueryBudget& budget, AccountId account)
    : budget_(budget), account_(account) {
    cpu_time_.use_this_thread();
    begin_ = cpu_time_.now().value_or(begin_);
    status_ = budget.admit(account, Clock::now());
}

// A refused query costs nothing, so that the account can pay its debt.
QueryBudget::Spending::~Spending() {
    if (!status_.ok()) return;
    const std::chrono::nanoseconds cost = cpu_time_.now().value_or(begin_) - begin_;
    budget_.charge(account_, std::chrono::duration<double>(cost).count(), Clock::now());
}

}  // namespace jostle::server
