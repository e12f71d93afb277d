// SPDX-License-Identifier: MIT
//
// The connection of a simulated client: the server's session and the messages in transit, complete
// and in order, with bounded buffers as in a TCP connection with HTTP/2.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "jostle/base/network_queue.h"
#include "server/session/client_session.h"
#include "server/util/clock.h"
#include "tests/support/random.h"

namespace jostle::simulation {

using server::Clock;

// Random events: the generator of the tests with a few more functions.
class Chance : public test::Random {
public:
    using Random::Random;

    bool one_in(double n) { return in(0, n) < 1; }
    std::string bytes(std::size_t count) {
        std::string out(count, '\0');
        for (char& c : out) c = static_cast<char>(bits());
        return out;
    }
};

struct LineSettings {
    NetworkConditions conditions;    // of each direction
    double messages_to_break = 1e9;  // mean number of sent messages until the connection breaks
};

class NetworkLine {
public:
    NetworkLine(server::PlayContext& context, const std::string& name, const std::string& address,
                const LineSettings& settings, std::uint64_t seed, Clock::time_point now);

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

    Chance chance_;
    const double messages_to_break_;
    server::ClientSession session_;
    NetworkQueue<std::string> up_, down_;
    bool client_closed_ = false, closed_ = false, over_ = false;
    Status end_;
};

}  // namespace jostle::simulation
