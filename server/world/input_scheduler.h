// SPDX-License-Identifier: MIT
//
// Distributes the time that a tick spends on inputs fairly among players. Each player has an
// account: the subject of its token or, without authentication, its network. An input costs the
// processor time of its execution. In every tick the accounts that have inputs or debts share a
// part of the tick period equally, and so do the clients of an account. Inputs run in order of
// arrival while the balances of client and account are positive; further inputs wait for later
// ticks. Each client's inputs run, or are refused, in the order in which it sent them. (Deficit
// round robin, Shreedhar and Varghese 1996, with costs that are known afterwards.) Used on the tick
// thread.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "server/world/command.h"

namespace jostle::server {

class InputScheduler {
public:
    struct Settings {
        double tick_share = 0.25;  // of the tick period for inputs; 0: unlimited
        double wait_seconds_max = 0.5;
        std::size_t waiting_max = 256;  // of one client
    };
    InputScheduler(const Settings& settings, double hz);

    // Adds the inputs that are due in this tick, in order of arrival, and refills the accounts.
    // Clients whose leave command is applied in this tick have no inputs afterwards: those that do
    // not run now are refused.
    void begin_tick(std::span<const Command> due, std::span<const Command> leave_commands);
    // The next input that runs in this tick; null: the others wait. Valid until the next call of
    // take_refused(). Call charge() after its execution.
    const Command* next();
    void charge(double seconds);
    // An input that will not run, with the reason.
    struct Refused {
        Command command;
        Status status;
    };
    // Ends the tick: forgets the inputs that ran, and removes those that waited for too long.
    std::vector<Refused> take_refused();

    // The inputs that wait for a later tick.
    std::size_t waiting() const { return waiting_.size(); }

private:
    struct Balance {
        double seconds = 0;  // negative: a debt
        double refill = 0;   // in this tick
        std::size_t waiting = 0;
    };
    struct ClientBalance : Balance {
        AccountId account = 0;
    };
    struct Waiting {
        Command command;
        int ticks = 0;        // since it was due
        bool leaves = false;  // its client leaves in this tick
        bool has_run = false;
    };
    bool may_run(const Waiting& entry) const;
    double retry_seconds(const Command& command) const;
    void refill();

    const Settings settings_;
    const double period_s_;  // of a tick
    const double share_s_;   // of one tick, for all accounts
    const int wait_ticks_max_;
    // Those with inputs, or with less than a full balance.
    std::map<AccountId, Balance> accounts_;
    std::map<ClientId, ClientBalance> clients_;
    std::deque<Waiting> waiting_;  // in order of arrival
    std::size_t next_ = 0;         // index of the next entry to look at
    double spent_s_ = 0;           // in this tick
    std::set<ClientId> blocked_;   // with an input that waits for a later tick
    const Command* running_ = nullptr;
};

}  // namespace jostle::server
