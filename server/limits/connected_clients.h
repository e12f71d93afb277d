// SPDX-License-Identifier: MIT
//
// The connected clients as operators see them, and how operators disconnect one. A client's session
// writes its entry on its own thread; any thread may read all entries.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "server/auth/identity.h"
#include "server/util/clock.h"
#include "server/world/command.h"

namespace jostle::server {

struct ClientIdentity {
    ClientId id = 0;
    std::string name;     // chosen by the client
    std::string subject;  // from its token; empty: authentication is off
    std::string world_id, world_name;
    std::string address;
    bool spectator = false;
    Clock::time_point since;
};

// Status of a client at one point in time.
struct ClientStatus {
    ClientIdentity who;
    double connected_seconds = 0;  // since it connected
    double kbit_per_second = 0;    // sent to it, averaged over about the last second
    std::uint32_t skipped = 0;     // snapshots not sent because it did not keep up
    double round_trip_ms = 0;      // of its last acknowledgement; 0: none yet
};

class ConnectedClient {
public:
    explicit ConnectedClient(ClientIdentity who)
        : who_(std::move(who)), window_start_(who_.since.time_since_epoch().count()) {}

    // The session's thread.
    void count_sent(std::size_t bytes, Clock::time_point now);
    void set_flow(std::uint32_t skipped, double round_trip_s);
    // The reason if the client was kicked; empty: it was not.
    std::optional<std::string> kicked() const;

    // Any thread.
    const ClientIdentity& who() const { return who_; }
    ClientStatus status(Clock::time_point now) const;
    double round_trip_s() const { return round_trip_s_.load(std::memory_order_relaxed); }
    void kick(std::string reason);

private:
    const ClientIdentity who_;
    // Of the current window, and the rate of the last complete one.
    std::atomic<Clock::rep> window_start_;
    std::atomic<std::uint64_t> window_bytes_{0};
    std::atomic<double> last_rate_{0};  // bytes per second
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

    std::vector<ClientStatus> status(Clock::time_point now) const;  // in ascending order of id
    // The clients of a world with their round-trip times in s (0: unknown), in ascending order of
    // id.
    std::vector<std::pair<ClientId, double>> round_trips(const std::string& world_id) const;
    // Notifies the client and ends its stream shortly after. not_found: no client has this id.
    // permission_denied: the token of `by` is limited to certain worlds, and the client is in none
    // of them; whether a client has this id is not revealed.
    Status kick(ClientId client, std::string reason, const Identity& by);

private:
    mutable std::mutex mutex_;
    std::map<ClientId, std::shared_ptr<ConnectedClient>> clients_;
};

}  // namespace jostle::server
