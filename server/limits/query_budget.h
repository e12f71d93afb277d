// SPDX-License-Identifier: MIT
//
// Distributes the processor time that the server spends on queries fairly among players. Each
// player has an account (limits/account.h), as for its inputs (world/input_scheduler.h). A query
// costs the processor time from its decoding to its encoded response. The accounts that have less
// than a full balance share a part of one processor equally. The cost is known afterwards, so an
// account may go into debt; its queries are refused until the debt is paid. Any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>

#include "jostle/base/result.h"
#include "server/util/clock.h"
#include "server/util/thread_cpu_time.h"
#include "server/world/command.h"

namespace jostle::server {

class QueryBudget {
public:
    // `share`: of one processor, for the queries of all accounts; 0: unlimited.
    explicit QueryBudget(double share);

    // resource_exhausted with a time to retry: the account is in debt.
    Status admit(AccountId account, Clock::time_point now);
    // After an admitted query.
    void charge(AccountId account, double cpu_seconds, Clock::time_point now);

    // The accounts with less than a full balance.
    std::size_t accounts() const;

    // Admits a query of this thread, and charges its cost when it ends.
    class Spending {
    public:
        Spending(QueryBudget& budget, AccountId account);
        ~Spending();
        Spending(const Spending&) = delete;
        Spending& operator=(const Spending&) = delete;

        const Status& status() const { return status_; }

    private:
        QueryBudget& budget_;
        const AccountId account_;
        ThreadCpuTime cpu_time_;
        std::chrono::nanoseconds begin_{0};
        Status status_;
    };

private:
    void refill(Clock::time_point now);

    const double share_;
    mutable std::mutex mutex_;
    // In seconds of processor time; negative: a debt. An account that is missing has a full
    // balance.
    std::map<AccountId, double> balances_;
    Clock::time_point refilled_{};
};

}  // namespace jostle::server
