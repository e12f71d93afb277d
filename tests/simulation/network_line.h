// SPDX-License-Identifier: MIT
//
// The connection of a simulated client: the server's session, two pipes and the network conditions.
#pragma once

#include <memory>
#include <string>

#include "server/session/client_session.h"
#include "tests/simulation/chance.h"
#include "tests/simulation/pipe.h"

namespace jostle::simulation {

struct NetworkConditions {
    // minimum per direction; the maximum is twice as long
    Clock::duration delay = std::chrono::milliseconds(20);
    double cuts_after = 1e9;  // mean number of messages until the connection breaks
};

class NetworkLine {
public:
    NetworkLine(server::PlayContext& context, const std::string& name, const std::string& address,
                NetworkConditions quality, std::uint64_t seed, Clock::time_point now);

    // --- the client's end ---
    void send(std::string bytes, Clock::time_point now);
    std::optional<std::string> receive(Clock::time_point now);
    void close_by_client(Clock::time_point now);
    // The server ended the connection and all its messages were received, or the connection broke.
    bool is_over() const { return over_; }
    const Status& end_status() const { return end_; }

    // --- the server's end, called once per tick and after each frame, like a transport ---
    void serve(Clock::time_point now);
    bool is_closed() const { return closed_; }  // the server can remove it

private:
    void deliver(Clock::time_point now);
    void write(Clock::time_point now);
    void cut(Clock::time_point now, const std::string& why);
    Clock::time_point arrival(Clock::time_point now);

    Chance chance_;
    const NetworkConditions quality_;
    server::ClientSession session_;
    Pipe up_, down_;
    bool client_closed_ = false, closed_ = false, over_ = false;
    Status end_;
};

}  // namespace jostle::simulation
