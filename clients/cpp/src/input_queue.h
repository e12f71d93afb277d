// SPDX-License-Identifier: MIT
//
// Inputs on their way to the server, under numbers that rise from 1: those that wait to be sent,
// and those that were sent and are not answered yet, which are sent again when the connection broke
// before they came. One thread at a time. The same in the browser
// (clients/web/src/input_queue.ts).
#pragma once

#include <cstdint>
#include <deque>
#include <utility>

#include "jostle/v1/play.pb.h"

namespace jostle::client {

class InputQueue {
public:
    static constexpr std::size_t waiting_max = 4096;  // two seconds' worth of full batches is 1920

    // Its number; 0: too many wait.
    std::uint32_t push(v1::Input input);
    // The next ones to send, at most so many, into the batch.
    std::size_t take(v1::InputBatch& batch, std::size_t most);
    // One was answered. False: it was so before, on the connection that broke.
    bool answered(std::uint32_t sequence);

    // A new client: numbers begin anew, what waits is sent under new ones, and what was sent is
    // forgotten.
    void begin_anew();
    // The same client, of which the server has the inputs up to that one: those after it are sent
    // again. How many.
    std::size_t go_on_after(std::uint32_t last_sequence);
    void forget_waiting();

    bool none_waits() const { return waiting_.empty(); }
    std::uint32_t last_sent() const { return next_unsent_ - 1; }

private:
    struct Sent {
        std::uint32_t sequence;
        v1::Input input;
    };
    std::deque<v1::Input> waiting_;
    std::deque<Sent> unanswered_;    // rising
    std::uint32_t next_unsent_ = 1;  // of waiting_.front()
    bool went_on_ = false;           // answers may come twice
};

}  // namespace jostle::client
