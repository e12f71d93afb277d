// SPDX-License-Identifier: MIT
#include "rpc/connection_table.h"

#include <netinet/in.h>
// Not netinet/tcp.h, whose tcp_info is older than tcpi_bytes_received.
#include <linux/tcp.h>

#include <algorithm>

#include "base/address.h"
#include "base/log.h"

namespace jostle::server {

namespace {

// What a connection may send beside its messages, in the long run: headers, window updates, pings
// and the frames around acks take a few kB/s of each call.
constexpr double slack_bytes_per_second = 16 * 1024, slack_of_call = 4 * 1024;
constexpr auto look_period = std::chrono::milliseconds(200);  // at those that send little
constexpr double busy_bytes = 64 * 1024;                      // between two looks

std::optional<std::uint64_t> cookie_of(int descriptor) {
    std::uint64_t cookie = 0;
    socklen_t size = sizeof cookie;
    if (getsockopt(descriptor, SOL_SOCKET, SO_COOKIE, &cookie, &size) != 0) return std::nullopt;
    return cookie;
}

std::optional<std::uint64_t> bytes_received(int descriptor) {
    tcp_info info{};
    socklen_t size = sizeof info;
    if (getsockopt(descriptor, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return std::nullopt;
    return info.tcpi_bytes_received;
}

}  // namespace

std::optional<ConnectionTable::Refusal> ConnectionTable::admit(int descriptor,
                                                               const sockaddr_storage& peer) {
    const std::lock_guard lock(mutex_);
    const std::string address = network_of(peer);
    const auto full = [&]() -> std::optional<Refusal> {
        if (connections_.size() >= limits_.total_max) return Refusal::full;
        const auto known = of_address_.find(address);
        const bool many = known != of_address_.end() && known->second >= limits_.per_address_max;
        return many ? std::optional(Refusal::address_full) : std::nullopt;
    };
    if (full()) forget_gone();
    if (const auto refusal = full()) return refusal;
    Connection connection{.descriptor = descriptor,
                          .cookie = cookie_of(descriptor).value_or(0),
                          .peer = grpc_peer_name(peer),
                          .address = address,
                          .meter = std::make_shared<ConnectionMeter>(),
                          .looked = Clock::now()};
    const std::string name = connection.peer;
    // A port that is used again before we saw that its connection is gone.
    if (const auto old = connections_.find(name); old != connections_.end()) {
        of_address_[old->second.address]--;
        connections_.erase(old);
    }
    connections_.emplace(name, std::move(connection));
    of_address_[address]++;
    return std::nullopt;
}

void ConnectionTable::forget_gone() {
    std::erase_if(connections_, [&](const auto& entry) {
        const Connection& c = entry.second;
        if (cookie_of(c.descriptor) == c.cookie) return false;
        const auto count = of_address_.find(c.address);
        if (--count->second == 0) of_address_.erase(count);
        return true;
    });
}

// False: it is gone.
bool ConnectionTable::measure(Connection& c, Clock::time_point now) const {
    if (cookie_of(c.descriptor) != c.cookie) return false;
    const auto received = bytes_received(c.descriptor);
    if (!received) return false;
    const std::uint64_t consumed = c.meter->consumed.load(std::memory_order_relaxed);
    const double seconds = std::chrono::duration<double>(now - c.looked).count();
    const auto calls = static_cast<double>(c.meter->calls.load(std::memory_order_relaxed));
    const auto sent = static_cast<double>(*received - c.received);
    c.unread += sent - static_cast<double>(consumed - c.consumed) -
                seconds * (slack_bytes_per_second + slack_of_call * calls);
    c.unread = std::max(0.0, c.unread);
    c.received = *received;
    c.consumed = consumed;
    c.looked = now;
    c.busy = sent > busy_bytes;
    return true;
}

void ConnectionTable::cut(Connection& connection, const char* why) {
    log_warn("{} was cut: {:.0f} bytes of no message{}", connection.peer, connection.unread, why);
    shutdown(connection.descriptor, SHUT_RDWR);
    connection.unread = 0;
    cut_++;
}

void ConnectionTable::sweep(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    bool gone = false;
    double total = 0;
    for (auto& [peer, c] : connections_) {
        if (c.busy || now - c.looked >= look_period) gone = !measure(c, now) || gone;
        if (c.unread > limits_.unread_bytes_max) cut(c, "");
        total += c.unread;
    }
    while (total > limits_.unread_total_max) {
        auto& largest = std::ranges::max_element(connections_, {}, [](const auto& entry) {
                            return entry.second.unread;
                        })->second;
        total -= largest.unread;
        cut(largest, ", the most of all when there was no more room");
    }
    if (gone) forget_gone();
}

std::shared_ptr<ConnectionMeter> ConnectionTable::find(const std::string& peer) const {
    const std::lock_guard lock(mutex_);
    const auto at = connections_.find(peer);
    return at == connections_.end() ? nullptr : at->second.meter;
}

std::size_t ConnectionTable::size() const {
    const std::lock_guard lock(mutex_);
    return connections_.size();
}

}  // namespace jostle::server
