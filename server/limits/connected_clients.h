// SPDX-License-Identifier: MIT
//
// Who is connected, as operators see it, and how they send somebody away. A client's link writes
// its record on its own thread; anyone may read all of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "server/util/clock.h"
#include "server/world/command.h"

namespace jostle::server {

struct ClientIdentity {
    ClientId id = 0;
    std::string name;     // as it calls itself
    std::string subject;  // whom its token names; empty: nobody asked
    std::string world_id, world_name;
    std::string address;
    bool spectator = false;
    Clock::time_point since;
};

// A client at one moment.
struct ClientStatus {
    ClientIdentity who;
    double connected_seconds = 0;  // since it came
    double kbit_per_second = 0;    // sent to it, over the last second or so
    std::uint32_t skipped = 0;     // snapshots it was not sent because it did not keep up
    double round_trip_ms = 0;      // of its last acknowledgement; 0: none yet
};

class ConnectedClient {
public:
    explicit ConnectedClient(ClientIdentity who)
        : who_(std::move(who)), window_began_(who_.since.time_since_epoch().count()) {}

    // The link's thread.
    void count_sent(std::size_t bytes, Clock::time_point now);
    void set_flow(std::uint32_t skipped, double round_trip_s);
    // Why the client must go; nothing: it may stay.
    std::optional<std::string> kicked() const;

    // Any thread.
    ClientStatus status(Clock::time_point now) const;
    void kick(std::string reason);

private:
    const ClientIdentity who_;
    // Of the second that runs, and of the last one that was full.
    std::atomic<Clock::rep> window_began_;
    std::atomic<std::uint64_t> window_bytes_{0};
    std::atomic<double> last_rate_{0};  // bytes a second
    std::atomic<std::uint32_t> skipped_{0};
    std::atomic<double> round_trip_s_{0};
    std::atomic<bool> is_kicked_{false};
    mutable std::mutex kick_mutex_;
    std::string kick_reason_;
};

// Any thread.
class ConnectedClients {
public:
    std::shared_ptr<ConnectedClient> add(ClientIdentity who);
    void remove(ClientId client);

    std::vector<ClientStatus> status(Clock::time_point now) const;  // in order of their ids
    // The client is told, and its stream ends within a moment. Not found: there is none of that id.
    Status kick(ClientId client, std::string reason);

private:
    mutable std::mutex mutex_;
    std::map<ClientId, std::shared_ptr<ConnectedClient>> records_;
};

}  // namespace jostle::server
