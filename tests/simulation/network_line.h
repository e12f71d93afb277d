// SPDX-License-Identifier: MIT
//
// A connection of a simulated client: the server's end of the conversation, two pipes, and how good
// the line is.
#pragma once

#include <memory>
#include <string>

#include "server/session/client_session.h"
#include "tests/simulation/chance.h"
#include "tests/simulation/pipe.h"

namespace jostle::simulation {

struct NetworkConditions {
    Clock::duration delay = std::chrono::milliseconds(20);  // of one way, and up to as much again
    double cuts_after = 1e9;  // messages, on average: then the connection breaks
};

class NetworkLine {
public:
    NetworkLine(server::PlayContext& context, const std::string& name, const std::string& address,
                NetworkConditions quality, std::uint64_t seed, Clock::time_point now);

    // --- the client's end ---
    void send(std::string bytes, Clock::time_point now);
    std::optional<std::string> receive(Clock::time_point now);
    void close_by_client(Clock::time_point now);
    // The server has ended it and all it said was heard, or it broke.
    bool is_over() const { return over_; }
    const Status& end_status() const { return end_; }

    // --- the server's end, once a tick and when a frame came: as a transport would ---
    void serve(Clock::time_point now);
    bool is_closed() const { return closed_; }  // may be forgotten by the server

private:
    void deliver(Clock::time_point now);
    void write(Clock::time_point now);
    void cut(Clock::time_point now, const std::string& why);
    Clock::time_point arrival(Clock::time_point now);

    Chance chance_;
    const NetworkConditions quality_;
    server::ClientSession session_;
    Pipe up_, down_;
    bool hung_up_ = false, closed_ = false, over_ = false;
    Status end_;
};

}  // namespace jostle::simulation
