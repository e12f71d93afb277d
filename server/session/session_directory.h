// SPDX-License-Identifier: MIT
//
// Who is connected: client ids, tickets from JoinWorld, and how many clients each world has. Any
// thread.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/clock.h"
#include "host/command.h"

namespace jostle::server {

class SessionDirectory {
public:
    explicit SessionDirectory(int clients_max) : clients_max_(clients_max) {}

    // A ticket that lets one client into a world, once, within 30 s.
    std::string issue_ticket(const std::string& world_id, Clock::time_point now);
    // The world's id; nothing when the ticket is unknown, used or too old.
    std::optional<std::string> use_ticket(const std::string& ticket, Clock::time_point now);

    // A new client id; nothing when the server is full.
    std::optional<ClientId> enter(const std::string& world_id);
    void leave(ClientId client);

    int clients() const;
    int clients_in(const std::string& world_id) const;

private:
    struct Ticket {
        std::string world_id;
        Clock::time_point expires;
    };

    const int clients_max_;
    mutable std::mutex mutex_;
    std::map<std::string, Ticket> tickets_;
    std::map<ClientId, std::string> worlds_;  // of each client
    std::map<std::string, int> count_;        // by world
    ClientId next_ = 1;
};

}  // namespace jostle::server
