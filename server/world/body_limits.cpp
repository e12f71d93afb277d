// SPDX-License-Identifier: MIT
#include "server/world/body_limits.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr double average_seconds = 0.5;
// A world whose tick thread is busier than this cannot keep its rate for long ...
constexpr double overload = 0.95;
// ... and after this time loses bodies, some at a time, until it can.
constexpr double overload_seconds_max = 1;
constexpr double removal_interval_seconds = 0.25;
constexpr double removed_fraction = 0.1;
constexpr std::size_t removed_min = 5;
// Whoever owns fewer bodies keeps them.
constexpr std::size_t always_kept = 10;

}  // namespace

std::optional<Error> BodyLimits::refusal(const Command& command, const Ownership& ownership) {
    if (!std::holds_alternative<SpawnCommand>(command.action)) return std::nullopt;
    if (command.account == 0) return std::nullopt;
    accounts_[command.client] = command.account;
    if (settings_.spawn_load_max > 0 && load_ > settings_.spawn_load_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the world is busy: its ticks take {:.0f} % of their period, and "
                                 "world.spawn_load_max allows new bodies up to {:.0f} %; retry "
                                 "later",
                                 100 * load_, 100 * settings_.spawn_load_max),
                     1000};
    if (settings_.account_bodies_max == 0) return std::nullopt;
    int bodies = 0;
    for (const auto& [client, account] : accounts_)
        if (account == command.account) bodies += ownership.count(client);
    if (bodies < settings_.account_bodies_max) return std::nullopt;
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("the clients of this player or network own {} bodies; "
                             "client.account_bodies_max allows {}; delete a body first",
                             bodies, settings_.account_bodies_max)};
}

void BodyLimits::on_retained(std::vector<EntityId> bodies, Clock::time_point now) {
    if (settings_.retained_seconds == 0 || bodies.empty()) return;
    retained_.push_back({std::move(bodies), now + from_seconds(settings_.retained_seconds)});
}

void BodyLimits::end_tick(double cpu_seconds, bool steps) {
    ASSERT(!(cpu_seconds < 0));
    const double weight = 1 / std::max(1.0, average_seconds * hz_);
    load_ += weight * (cpu_seconds * hz_ - load_);
    overloaded_ticks_ = steps && load_ > overload ? overloaded_ticks_ + 1 : 0;
}

std::map<AccountId, std::vector<EntityId>> BodyLimits::bodies_by_account(
    const Ownership& ownership) const {
    std::map<AccountId, std::vector<EntityId>> bodies;
    for (const auto& [client, account] : accounts_) {
        const std::vector<EntityId> owned = ownership.owned_by(client);
        bodies[account].insert(bodies[account].end(), owned.begin(), owned.end());
    }
    return bodies;
}

BodyLimits::Removal BodyLimits::take_removals(const Ownership& ownership, Clock::time_point now) {
    Removal removal;
    for (; !retained_.empty() && retained_.front().until <= now; retained_.pop_front()) {
        const std::vector<EntityId>& bodies = retained_.front().bodies;
        removal.expired.insert(removal.expired.end(), bodies.begin(), bodies.end());
    }
    std::erase_if(accounts_, [&](const auto& entry) { return ownership.count(entry.first) == 0; });
    if (overloaded_ticks_ < overload_seconds_max * hz_) return removal;
    const auto bodies = bodies_by_account(ownership);
    const auto most =
        std::ranges::max_element(bodies, {}, [](const auto& entry) { return entry.second.size(); });
    if (most == bodies.end() || most->second.size() <= always_kept) return removal;
    removal.account = most->first;
    removal.excess = most->second;
    std::ranges::sort(removal.excess);  // the oldest first
    const auto fraction =
        static_cast<std::size_t>(removed_fraction * static_cast<double>(removal.excess.size()));
    removal.excess.resize(
        std::min(std::max(fraction, removed_min), removal.excess.size() - always_kept));
    overloaded_ticks_ -= static_cast<int>(removal_interval_seconds * hz_);
    return removal;
}

}  // namespace jostle::server
