// SPDX-License-Identifier: MIT
//
// One direction of an in-memory connection. Messages arrive complete, in order and delayed, and the
// buffers are bounded, as in a TCP connection with HTTP/2.
#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "server/util/clock.h"

namespace jostle::simulation {

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

}  // namespace jostle::simulation
