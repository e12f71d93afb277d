// SPDX-License-Identifier: MIT
#include "server/limits/connected_clients.h"

#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Averaging window of the rate. Without traffic for longer than this, the rate decreases.
constexpr double window_s = 1;

double seconds_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

}  // namespace

void ConnectedClient::count_sent(std::size_t bytes, Clock::time_point now) {
    const Clock::time_point window_start{
        Clock::duration(window_start_.load(std::memory_order_relaxed))};
    const double seconds = seconds_between(window_start, now);
    if (seconds >= window_s) {
        const auto sent = static_cast<double>(window_bytes_.load(std::memory_order_relaxed));
        last_rate_.store(sent / seconds, std::memory_order_relaxed);
        window_bytes_.store(0, std::memory_order_relaxed);
        window_start_.store(now.time_since_epoch().count(), std::memory_order_relaxed);
    }
    window_bytes_.fetch_add(bytes, std::memory_order_relaxed);
}

void ConnectedClient::set_flow(std::uint32_t skipped, double round_trip_s) {
    skipped_.store(skipped, std::memory_order_relaxed);
    round_trip_s_.store(round_trip_s, std::memory_order_relaxed);
}

std::optional<std::string> ConnectedClient::kicked() const {
    if (!is_kicked_.load(std::memory_order_acquire)) return std::nullopt;
    const std::lock_guard lock(kick_mutex_);
    return kick_reason_;
}

void ConnectedClient::kick(std::string reason) {
    const std::lock_guard lock(kick_mutex_);
    kick_reason_ = std::move(reason);
    is_kicked_.store(true, std::memory_order_release);
}

// The values may be from different points in time if the session writes concurrently; that is
// accurate enough for display.
ClientStatus ConnectedClient::status(Clock::time_point now) const {
    const Clock::time_point window_start{
        Clock::duration(window_start_.load(std::memory_order_relaxed))};
    const double seconds = seconds_between(window_start, now);
    const auto bytes = static_cast<double>(window_bytes_.load(std::memory_order_relaxed));
    double rate = last_rate_.load(std::memory_order_relaxed);
    if (seconds >= window_s || rate == 0) rate = seconds > 0 ? bytes / seconds : 0;
    return {.who = who_,
            .connected_seconds = seconds_between(who_.since, now),
            .kbit_per_second = rate * 8 / 1000,
            .skipped = skipped_.load(std::memory_order_relaxed),
            .round_trip_ms = 1000 * round_trip_s_.load(std::memory_order_relaxed)};
}

std::shared_ptr<ConnectedClient> ConnectedClients::add(ClientIdentity who) {
    const ClientId client = who.id;
    auto entry = std::make_shared<ConnectedClient>(std::move(who));
    const std::lock_guard lock(mutex_);
    ASSERT(client != 0);
    clients_[client] = entry;
    return entry;
}

void ConnectedClients::remove(ClientId client) {
    const std::lock_guard lock(mutex_);
    clients_.erase(client);
}

std::vector<ClientStatus> ConnectedClients::status(Clock::time_point now) const {
    const std::lock_guard lock(mutex_);
    std::vector<ClientStatus> statuses;
    statuses.reserve(clients_.size());
    for (const auto& [client, entry] : clients_) statuses.push_back(entry->status(now));
    ASSERT(statuses.size() == clients_.size());
    return statuses;
}

std::vector<std::pair<ClientId, double>> ConnectedClients::round_trips(
    const std::string& world_id) const {
    const std::lock_guard lock(mutex_);
    std::vector<std::pair<ClientId, double>> round_trips;
    for (const auto& [client, entry] : clients_)
        if (entry->who().world_id == world_id)
            round_trips.emplace_back(client, entry->round_trip_s());
    return round_trips;
}

Status ConnectedClients::kick(ClientId client, std::string reason, const Identity& by) {
    const std::lock_guard lock(mutex_);
    const auto at = clients_.find(client);
    const bool is_in_reach =
        at != clients_.end() && by.opens(at->second->who().world_id, at->second->who().world_name);
    if (by.is_limited_to_worlds() && !is_in_reach)
        return Error{ErrorCode::permission_denied,
                     "there is no client " + std::to_string(client) +
                         " in the worlds of the token; ListClients lists them"};
    if (at == clients_.end())
        return Error{ErrorCode::not_found,
                     "there is no client " + std::to_string(client) + "; it may have left"};
    at->second->kick(std::move(reason));
    return {};
}

}  // namespace jostle::server
