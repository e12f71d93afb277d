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
    return address_refusal(peer, now);
}

bool ConnectionTable::is_proxy(const sockaddr_storage& peer) const {
    return proxies_ && proxies_->contains(address_name(peer));
}

// Call with the lock.
std::optional<ConnectionTable::Refusal> ConnectionTable::address_refusal(
    const sockaddr_storage& peer, Clock::time_point now) const {
    if (is_proxy(peer)) return std::nullopt;
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
    set_address(*connection, peer);
    const std::lock_guard lock(mutex_);
    connection->name =
        "jostle-" + std::to_string(::getpid()) + "-" + std::to_string(++last_number_);
    connections_.emplace(connection->grpc_name(), connection);
    count_address(*connection, 1);
    return connection;
}

void ConnectionTable::set_address(Connection& connection, const sockaddr_storage& peer) {
    connection.peer = peer_name(peer);
    connection.address = address_name(peer);
    connection.network = network_of(peer);
    connection.is_proxy = is_proxy(peer);
}

// Call with the lock.
void ConnectionTable::count_address(const Connection& connection, int change) {
    if (connection.is_proxy) return;
    std::size_t& count = of_network_[connection.network];
    ASSERT(change > 0 || count > 0);
    count = change > 0 ? count + 1 : count - 1;
    if (count == 0) of_network_.erase(connection.network);
}

std::optional<ConnectionTable::Refusal> ConnectionTable::set_client(Connection& connection,
                                                                    const sockaddr_storage& client,
                                                                    Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (const auto refusal = address_refusal(client, now)) return refusal;
    count_address(connection, -1);
    set_address(connection, client);
    count_address(connection, 1);
    return std::nullopt;
}

std::string ConnectionTable::client_address(const Connection& connection,
                                            std::string_view forwarded) const {
    return connection.is_proxy ? proxies_->client_address(connection.address, forwarded)
                               : connection.address;
}

std::string_view ConnectionTable::forwarded_header() const {
    return proxies_ ? proxies_->header_name() : std::string_view{};
}

void ConnectionTable::remove(const Connection& connection) {
    const std::lock_guard lock(mutex_);
    count_address(connection, -1);
    connections_.erase(connection.grpc_name());
    ASSERT(of_network_.size() <= connections_.size());
}

void ConnectionTable::penalize(const Connection& connection, Clock::time_point now) {
    if (connection.is_proxy) return;  // others would pay for the attack of one client
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
