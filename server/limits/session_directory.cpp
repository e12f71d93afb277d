// SPDX-License-Identifier: MIT
#include "server/limits/session_directory.h"

#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

void decrement(std::map<std::string, int>& counts, const std::string& key) {
    const auto at = counts.find(key);
    ASSERT(at != counts.end() && at->second > 0);
    if (--at->second == 0) counts.erase(at);
}

}  // namespace

void SessionDirectory::use_ids(ClientId first, std::function<void(ClientId next)> on_id) {
    const std::lock_guard lock(mutex_);
    next_ = first;
    on_id_ = std::move(on_id);
}

void SessionDirectory::restore_client(ClientId client, const std::string& world_id,
                                      const std::string& network) {
    const std::lock_guard lock(mutex_);
    ASSERT(client != 0);
    if (!sessions_.try_emplace(client, Session{world_id, network, {}}).second) return;
    of_world_[world_id]++;
    of_network_[network]++;
}

bool SessionDirectory::subject_is_full(const std::string& subject) const {
    if (per_subject_max_ == 0 || subject.empty()) return false;
    const auto same = of_subject_.find(subject);
    return same != of_subject_.end() && same->second >= per_subject_max_;
}

bool SessionDirectory::is_at_limit(const std::string& subject) const {
    const std::lock_guard lock(mutex_);
    return subject_is_full(subject);
}

void SessionDirectory::set_subject(ClientId client, const std::string& subject) {
    const std::lock_guard lock(mutex_);
    const auto at = sessions_.find(client);
    if (at == sessions_.end() || !at->second.subject.empty() || subject.empty()) return;
    at->second.subject = subject;
    of_subject_[subject]++;
}

Result<ClientId> SessionDirectory::enter(const std::string& world_id, const std::string& network,
                                         const std::string& subject, std::uint32_t world_max) {
    const std::lock_guard lock(mutex_);
    const auto here = of_world_.find(world_id);
    if (world_max > 0 && here != of_world_.end() && here->second >= static_cast<int>(world_max))
        return Error{ErrorCode::resource_exhausted,
                     "the room is full: " + std::to_string(world_max) + " clients"};
    if (static_cast<int>(sessions_.size()) >= clients_max_)
        return Error{ErrorCode::resource_exhausted,
                     "the server is full: " + std::to_string(clients_max_) + " clients"};
    const auto same = of_network_.find(network);
    if (same != of_network_.end() && same->second >= per_network_max_)
        return Error{ErrorCode::resource_exhausted, "this address already has " +
                                                        std::to_string(per_network_max_) +
                                                        " clients, the maximum"};
    if (subject_is_full(subject))
        return Error{ErrorCode::resource_exhausted,
                     "the subject of the token already has " + std::to_string(per_subject_max_) +
                         (per_subject_max_ == 1 ? " session" : " sessions") +
                         ", the maximum (limits.sessions_per_subject); end another one first"};
    const ClientId client = next_++;
    ASSERT(client != 0);
    sessions_[client] = {world_id, network, subject};
    if (!subject.empty()) of_subject_[subject]++;
    of_world_[world_id]++;
    of_network_[network]++;
    if (on_id_) on_id_(next_);
    return client;
}

void SessionDirectory::leave(ClientId client) {
    const std::lock_guard lock(mutex_);
    const auto at = sessions_.find(client);
    if (at == sessions_.end()) return;
    decrement(of_world_, at->second.world);
    decrement(of_network_, at->second.network);
    if (!at->second.subject.empty()) decrement(of_subject_, at->second.subject);
    sessions_.erase(at);
    ASSERT(of_world_.size() <= sessions_.size() && of_network_.size() <= sessions_.size());
}

bool SessionDirectory::has(ClientId client) const {
    const std::lock_guard lock(mutex_);
    return sessions_.contains(client);
}

int SessionDirectory::clients() const {
    const std::lock_guard lock(mutex_);
    return static_cast<int>(sessions_.size());
}

int SessionDirectory::clients_in(const std::string& world_id) const {
    const std::lock_guard lock(mutex_);
    const auto at = of_world_.find(world_id);
    return at == of_world_.end() ? 0 : at->second;
}

}  // namespace jostle::server
