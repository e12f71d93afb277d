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
// All clients together may spawn this many bodies a second in an idle world, and fewer the closer
// the load is to its limit: bodies that still fall cost little, those on a heap much.
constexpr double spawns_per_second = 240;
// An account keeps at least this many bodies.
constexpr std::size_t always_kept = 10;

}  // namespace

std::optional<Error> BodyLimits::refusal(const Command& command, const Ownership& ownership) {
    if (!std::holds_alternative<SpawnCommand>(command.action) &&
        !std::holds_alternative<CloneCommand>(command.action))
        return std::nullopt;
    if (command.account == 0) return std::nullopt;
    accounts_[command.client] = command.account;
    if (settings_.spawn_load_max > 0 && load_ > settings_.spawn_load_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the world is busy: its ticks take {:.0f} % of their period, and "
                                 "world.spawn_load_max allows new bodies up to {:.0f} %; retry "
                                 "later",
                                 100 * load_, 100 * settings_.spawn_load_max),
                     1000};
    int bodies = 0;
    for (const auto& [client, account] : accounts_)
        if (account == command.account) bodies += ownership.count(client);
    if (settings_.account_bodies_max > 0 && bodies >= settings_.account_bodies_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the clients of this player or network own {} bodies; "
                                 "client.account_bodies_max allows {}; delete a body first",
                                 bodies, settings_.account_bodies_max)};
    if (settings_.spawn_load_max > 0 && spawns_left_ < 1)
        return Error{ErrorCode::resource_exhausted,
                     "too many bodies are being added to the world; retry later", 100};
    spawns_left_--;
    return std::nullopt;
}

void BodyLimits::on_retained(std::vector<EntityId> bodies, Clock::time_point now) {
    if (settings_.retained_seconds == 0 || bodies.empty()) return;
    retained_.push_back({std::move(bodies), now + from_seconds(settings_.retained_seconds)});
}

void BodyLimits::end_tick(double cpu_seconds, bool steps) {
    ASSERT(!(cpu_seconds < 0));
    const double weight = 1 / std::max(1.0, average_seconds * hz_);
    load_ += weight * (cpu_seconds * hz_ - load_);
    const double unused = settings_.spawn_load_max > 0 ? 1 - load_ / settings_.spawn_load_max : 1;
    spawns_left_ = std::min(spawns_left_ + std::max(0.0, unused) * spawns_per_second / hz_,
                            spawns_per_second / 2);
    overloaded_ticks_ = steps && load_ > overload ? overloaded_ticks_ + 1 : 0;
}

// The oldest bodies of the clients with most bodies, in the account with most bodies.
std::vector<EntityId> BodyLimits::find_excess(const Ownership& ownership) const {
    std::map<AccountId, std::size_t> counts;
    for (const auto& [client, account] : accounts_)
        counts[account] += static_cast<std::size_t>(ownership.count(client));
    const auto most =
        std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
    if (most == counts.end() || most->second <= always_kept) return {};
    std::vector<std::vector<EntityId>> owned;  // by client, descending: the oldest is the last
    for (const auto& [client, account] : accounts_) {
        if (account != most->first) continue;
        owned.push_back(ownership.owned_by(client));
        std::ranges::reverse(owned.back());
    }
    const auto fraction =
        static_cast<std::size_t>(removed_fraction * static_cast<double>(most->second));
    std::vector<EntityId> excess(
        std::min(std::max(fraction, removed_min), most->second - always_kept));
    for (EntityId& entity : excess) {
        std::vector<EntityId>& largest =
            *std::ranges::max_element(owned, {}, &std::vector<EntityId>::size);
        entity = largest.back();
        largest.pop_back();
    }
    return excess;
}

BodyLimits::Removal BodyLimits::take_removals(const Ownership& ownership, Clock::time_point now) {
    Removal removal;
    for (; !retained_.empty() && retained_.front().until <= now; retained_.pop_front()) {
        const std::vector<EntityId>& bodies = retained_.front().bodies;
        removal.expired.insert(removal.expired.end(), bodies.begin(), bodies.end());
    }
    std::erase_if(accounts_, [&](const auto& entry) { return ownership.count(entry.first) == 0; });
    if (overloaded_ticks_ < overload_seconds_max * hz_) return removal;
    removal.excess = find_excess(ownership);
    overloaded_ticks_ -= static_cast<int>(removal_interval_seconds * hz_);
    return removal;
}

}  // namespace jostle::server
