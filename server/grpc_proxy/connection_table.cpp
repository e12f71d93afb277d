// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/connection_table.h"

#include <unistd.h>

#include <algorithm>

#include "jostle/base/check.h"
#include "server/util/address.h"

namespace jostle::server {

namespace {

constexpr auto first_penalty = std::chrono::seconds(1), longest_penalty = std::chrono::seconds(60);
constexpr auto penalty_memory = std::chrono::minutes(10);  // after a penalty has ended
constexpr std::size_t penalties_max = 100'000;

}  // namespace

std::optional<ConnectionTable::Refusal> ConnectionTable::refusal_for(const sockaddr_storage& peer,
                                                                     Clock::time_point now) const {
    const std::lock_guard lock(mutex_);
    if (connections_.size() >= limits_.total_max) return Refusal::full;
    const std::string network = network_of(peer);
    if (const auto known = of_network_.find(network);
        known != of_network_.end() && known->second >= limits_.per_address_max)
        return Refusal::address_full;
    if (const auto known = penalties_.find(network);
        known != penalties_.end() && now < known->second.until)
        return Refusal::address_penalized;
    return std::nullopt;
}

std::shared_ptr<Connection> ConnectionTable::admit(const sockaddr_storage& peer) {
    const auto connection = std::make_shared<Connection>();
    connection->peer = peer_name(peer);
    connection->address = address_name(peer);
    connection->network = network_of(peer);
    const std::lock_guard lock(mutex_);
    connection->name =
        "jostle-" + std::to_string(::getpid()) + "-" + std::to_string(++last_number_);
    connections_.emplace(connection->grpc_name(), connection);
    of_network_[connection->network]++;
    return connection;
}

void ConnectionTable::remove(const Connection& connection) {
    const std::lock_guard lock(mutex_);
    const auto count = of_network_.find(connection.network);
    ASSERT(count != of_network_.end() && count->second > 0);
    if (--count->second == 0) of_network_.erase(count);
    connections_.erase(connection.grpc_name());
    ASSERT(of_network_.size() <= connections_.size());
}

void ConnectionTable::penalize(const Connection& connection, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (penalties_.size() >= penalties_max) forget_penalties(now);
    Penalty& penalty = penalties_[connection.network];
    // All its open connections together count as one attack.
    if (now < penalty.until) return;
    if (now > penalty.until + penalty_memory) penalty.count = 0;
    const auto wait = std::min<Clock::duration>(longest_penalty,
                                                first_penalty * (1 << std::min(penalty.count, 6)));
    penalty = {now + wait, penalty.count + 1};
}

void ConnectionTable::forget_penalties(Clock::time_point now) {
    std::erase_if(penalties_,
                  [&](const auto& entry) { return now > entry.second.until + penalty_memory; });
    if (penalties_.size() >= penalties_max) penalties_.clear();
}

std::shared_ptr<Connection> ConnectionTable::of(std::string_view grpc_name) const {
    {
        const std::lock_guard lock(mutex_);
        const auto at = connections_.find(grpc_name);
        if (at != connections_.end()) return at->second;
    }
    auto unknown = std::make_shared<Connection>();
    unknown->peer = grpc_name;
    return unknown;
}

std::size_t ConnectionTable::size() const {
    const std::lock_guard lock(mutex_);
    return connections_.size();
}

}  // namespace jostle::server
