// SPDX-License-Identifier: MIT
#include "server/world/input_scheduler.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "server/world/resolve_target.h"

namespace jostle::server {

namespace {

// Multiple of the share of a tick after which inputs that may be expensive wait, although their
// accounts could pay. Many accounts with full balances would otherwise hold the tick.
constexpr double tick_overdraft = 2;

// Other inputs take a few microseconds, whatever the world contains.
bool may_be_expensive(const Action& action) {
    return std::holds_alternative<ExplodeCommand>(action) ||
           std::holds_alternative<SpawnCommand>(action) || has_target(action);
}

}  // namespace

InputScheduler::InputScheduler(const Settings& settings, double hz)
    : settings_(settings),
      period_s_(1 / hz),
      share_s_(settings.tick_share / hz),
      wait_ticks_max_(static_cast<int>(std::ceil(settings.wait_seconds_max * hz))) {
    ASSERT(settings.tick_share >= 0 && hz > 0);
}

void InputScheduler::begin_tick(std::span<const Command> due,
                                std::span<const Command> leave_commands) {
    const auto leaves = [&](ClientId client) {
        return std::ranges::any_of(leave_commands,
                                   [&](const Command& c) { return c.client == client; });
    };
    next_ = 0;
    spent_s_ = 0;
    blocked_.clear();
    for (Waiting& entry : waiting_) {
        entry.ticks++;
        entry.leaves = leaves(entry.command.client);
    }
    for (const Command& command : due) {
        accounts_.try_emplace(command.account, Balance{.seconds = share_s_})
            .first->second.waiting++;
        clients_.try_emplace(command.client, ClientBalance{{.seconds = share_s_}, command.account})
            .first->second.waiting++;
        waiting_.push_back({.command = command, .leaves = leaves(command.client)});
    }
    refill();
}

void InputScheduler::refill() {
    std::map<AccountId, std::size_t> clients_of;
    for (const auto& [id, client] : clients_) clients_of[client.account]++;
    const auto add = [&](Balance& balance, double refill) {
        balance.refill = refill;
        balance.seconds = std::min(balance.seconds + refill, share_s_);
    };
    const double share = share_s_ / static_cast<double>(std::max<std::size_t>(1, accounts_.size()));
    for (auto& [id, account] : accounts_) add(account, share);
    for (auto& [id, client] : clients_)
        add(client, share / static_cast<double>(clients_of.at(client.account)));
    const auto is_idle = [&](const auto& entry) {
        return entry.second.waiting == 0 && entry.second.seconds >= share_s_;
    };
    std::erase_if(clients_, is_idle);
    // An account stays as long as one of its clients.
    std::set<AccountId> used;
    for (const auto& [id, client] : clients_) used.insert(client.account);
    std::erase_if(accounts_,
                  [&](const auto& entry) { return is_idle(entry) && !used.contains(entry.first); });
}

bool InputScheduler::may_run(const Waiting& entry) const {
    if (settings_.tick_share == 0) return true;
    const Command& command = entry.command;
    if (clients_.at(command.client).seconds <= 0) return false;
    if (!may_be_expensive(command.action)) return true;
    return accounts_.at(command.account).seconds > 0 && spent_s_ < tick_overdraft * share_s_;
}

// The inputs of a client keep their order: behind one that waits, all others wait.
const Command* InputScheduler::next() {
    for (; next_ < waiting_.size(); next_++) {
        const ClientId client = waiting_[next_].command.client;
        if (blocked_.contains(client)) continue;
        if (may_run(waiting_[next_])) break;
        blocked_.insert(client);
    }
    if (next_ == waiting_.size()) return nullptr;
    Waiting& entry = waiting_[next_++];
    entry.has_run = true;
    running_ = &entry.command;
    return running_;
}

void InputScheduler::charge(double seconds) {
    ASSERT(!(seconds < 0));
    if (settings_.tick_share == 0) return;
    spent_s_ += seconds;
    accounts_.at(running_->account).seconds -= seconds;
    clients_.at(running_->client).seconds -= seconds;
}

double InputScheduler::retry_seconds(const Command& command) const {
    const auto time_of = [&](const Balance& balance) {
        return -balance.seconds / std::max(balance.refill, 1e-9) * period_s_;
    };
    return std::max(
        {0.1, time_of(accounts_.at(command.account)), time_of(clients_.at(command.client))});
}

// The oldest inputs are refused first: clients take the result of an input for the end of all
// earlier ones.
std::vector<InputScheduler::Refused> InputScheduler::take_refused() {
    std::map<ClientId, std::size_t> excess;
    for (const Waiting& entry : waiting_)
        if (!entry.has_run) excess[entry.command.client]++;
    for (auto& [client, count] : excess) count -= std::min(count, settings_.waiting_max);
    std::vector<Refused> refused;
    std::deque<Waiting> still_waiting;
    for (Waiting& entry : waiting_) {
        const Command& command = entry.command;
        if (!entry.has_run) {
            std::size_t& left = excess.at(command.client);
            const bool is_excess = left > 0;
            if (is_excess) left--;
            if (!is_excess && !entry.leaves && entry.ticks < wait_ticks_max_) {
                still_waiting.push_back(std::move(entry));
                continue;
            }
        }
        accounts_.at(command.account).waiting--;
        clients_.at(command.client).waiting--;
        if (entry.has_run) continue;
        const double wait = retry_seconds(command);
        Error error{ErrorCode::resource_exhausted,
                    fmt::format("the inputs of this player take more than its share of the tick; "
                                "retry after {:.1f} s",
                                wait),
                    static_cast<int>(std::ceil(1000 * wait))};
        refused.push_back({std::move(entry.command), std::move(error)});
    }
    waiting_ = std::move(still_waiting);
    return refused;
}

}  // namespace jostle::server
