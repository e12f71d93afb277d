// SPDX-License-Identifier: MIT
#include "session/session_directory.h"

#include <algorithm>
#include <random>

namespace jostle::server {
namespace {

constexpr auto ticket_life = std::chrono::seconds(30);
constexpr std::size_t tickets_max = 10000;  // unused ones; the first to expire makes room

std::string random_ticket() {
    static constexpr char digits[] = "0123456789abcdef";
    std::random_device random;
    std::string ticket;
    for (int word = 0; word < 4; word++) {
        const unsigned bits = random();
        for (int k = 0; k < 8; k++) ticket += digits[bits >> (4 * k) & 15];
    }
    return ticket;
}

}  // namespace

std::string SessionDirectory::issue_ticket(const std::string& world_id, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    std::erase_if(tickets_, [&](const auto& entry) { return entry.second.expires <= now; });
    if (tickets_.size() >= tickets_max)
        tickets_.erase(std::min_element(
            tickets_.begin(), tickets_.end(),
            [](const auto& a, const auto& b) { return a.second.expires < b.second.expires; }));
    const std::string ticket = random_ticket();
    tickets_[ticket] = {world_id, now + ticket_life};
    return ticket;
}

std::optional<std::string> SessionDirectory::use_ticket(const std::string& ticket,
                                                        Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    const auto at = tickets_.find(ticket);
    if (at == tickets_.end()) return std::nullopt;
    const Ticket found = at->second;
    tickets_.erase(at);
    if (found.expires <= now) return std::nullopt;
    return found.world_id;
}

std::optional<ClientId> SessionDirectory::enter(const std::string& world_id) {
    const std::lock_guard lock(mutex_);
    if (static_cast<int>(worlds_.size()) >= clients_max_) return std::nullopt;
    const ClientId client = next_++;
    worlds_[client] = world_id;
    count_[world_id]++;
    return client;
}

void SessionDirectory::leave(ClientId client) {
    const std::lock_guard lock(mutex_);
    const auto at = worlds_.find(client);
    if (at == worlds_.end()) return;
    if (--count_[at->second] == 0) count_.erase(at->second);
    worlds_.erase(at);
}

int SessionDirectory::clients() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(worlds_.size());
}

int SessionDirectory::clients_in(const std::string& world_id) const {
    const std::lock_guard lock(mutex_);
    const auto at = count_.find(world_id);
    return at == count_.end() ? 0 : at->second;
}

}  // namespace jostle::server
