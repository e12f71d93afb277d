// SPDX-License-Identifier: MIT
//
// The connection of a simulated client: the server's session, two pipes and the network conditions.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "server/session/client_session.h"
#include "server/util/clock.h"
#include "tests/support/random.h"

namespace jostle::simulation {

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

// One direction of an in-memory connection. Messages arrive complete, in order and delayed, and the
// buffers are bounded, as in a TCP connection with HTTP/2.
using server::Clock;

class Pipe {
public:
    static constexpr std::size_t capacity = 64 * 1024;  // bytes, plus one message

    bool is_full() const { return bytes_ >= capacity; }
    std::size_t bytes() const { return bytes_; }

    void put(std::string message, Clock::time_point due) {
        // Messages arrive in order.
        if (!messages_.empty()) due = std::max(due, messages_.back().due);
        bytes_ += message.size();
        messages_.push_back({std::move(message), due});
    }
    std::optional<std::string> take(Clock::time_point now) {
        if (messages_.empty() || messages_.front().due > now) return std::nullopt;
        std::string out = std::move(messages_.front().bytes);
        messages_.pop_front();
        bytes_ -= out.size();
        return out;
    }

private:
    struct Message {
        std::string bytes;
        Clock::time_point due;
    };

    std::deque<Message> messages_;
    std::size_t bytes_ = 0;
};

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
