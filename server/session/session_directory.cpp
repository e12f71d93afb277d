// SPDX-License-Identifier: MIT
#include "session/session_directory.h"

namespace jostle::server {

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
