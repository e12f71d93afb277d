// SPDX-License-Identifier: MIT
//
// Who is connected: client ids, and how many clients each world has. Any thread.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "host/command.h"

namespace jostle::server {

class SessionDirectory {
public:
    explicit SessionDirectory(int clients_max) : clients_max_(clients_max) {}

    // A new client id; nothing when the server is full.
    std::optional<ClientId> enter(const std::string& world_id);
    void leave(ClientId client);

    int clients() const;
    int clients_in(const std::string& world_id) const;

private:
    const int clients_max_;
    mutable std::mutex mutex_;
    std::map<ClientId, std::string> worlds_;  // of each client
    std::map<std::string, int> count_;        // by world
    ClientId next_ = 1;
};

}  // namespace jostle::server
