// SPDX-License-Identifier: MIT
//
// The connected clients: assigns client ids and counts clients per world,
// per network and per subject. Any
// thread.
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>

#include "jostle/base/result.h"
#include "server/world/command.h"

namespace jostle::server {

class SessionDirectory {
public:
    // `per_subject_max`: 0 for no limit.
    explicit SessionDirectory(int clients_max, int per_network_max = 1 << 30,
                              int per_subject_max = 0)
        : clients_max_(clients_max),
          per_network_max_(per_network_max),
          per_subject_max_(per_subject_max) {}

    // Call before the first client enters: ids from `first` on were never assigned. `on_id` is
    // called under a lock after each assignment with the next id.
    void use_ids(ClientId first, std::function<void(ClientId next)> on_id);
    // Registers a client of an earlier process with its id.
    void restore_client(ClientId client, const std::string& world_id, const std::string& network);
    // Assigns a new client id. Fails if the server is full, or if the network (util/address.h) or
    // the subject has its maximum of clients. `subject`: empty for anonymous clients, which have
    // none.
    // `world_max`: of the clients of the world; 0: no limit.
    Result<ClientId> enter(const std::string& world_id, const std::string& network,
                           const std::string& subject = {}, std::uint32_t world_max = 0);
    // Whether enter() fails because of the subject.
    bool is_at_limit(const std::string& subject) const;
    // The subject of a restored client is known only when it resumes.
    void set_subject(ClientId client, const std::string& subject);
    void leave(ClientId client);

    bool has(ClientId client) const;
    int clients() const;
    int clients_in(const std::string& world_id) const;

private:
    struct Session {
        std::string world, network, subject;
    };

    bool subject_is_full(const std::string& subject) const;

    const int clients_max_, per_network_max_, per_subject_max_;
    mutable std::mutex mutex_;
    std::map<ClientId, Session> sessions_;
    std::map<std::string, int> of_world_, of_network_, of_subject_;
    ClientId next_ = 1;
    std::function<void(ClientId next)> on_id_;
};

}  // namespace jostle::server
