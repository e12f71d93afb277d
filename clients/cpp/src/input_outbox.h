// SPDX-License-Identifier: MIT
//
// Inputs on their way to the server, by number. Over a stream each is said once. Where datagrams
// may carry them too, each is kept until the server says that it has come: a datagram says all that
// have not, from the first on, and so does the stream when it takes over, because the server
// refuses to go back to a number that it has passed. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

class InputOutbox {
public:
    static constexpr std::size_t waiting_max = 4096;  // not said yet
    static constexpr std::size_t batch_max = 32;

    // A new stream, whose numbers begin anew: what was not said yet stays. `keeps`: until
    // confirmed.
    void begin();
    void keep(bool keeps) { keeps_ = keeps; }
    // Its number; 0: too many wait.
    std::uint32_t push(v1::Input input);
    // The server has all up to that number.
    void confirm(std::uint32_t received, Clock::time_point now);

    // Whether the server is not known to have all.
    bool has_open() const { return first_ < next_; }
    // Whether all that is open fits into one batch of so many bytes.
    bool fits(std::size_t bytes_max) const;
    // Something that a datagram said was not confirmed for so long.
    bool is_stuck(Clock::duration patience, Clock::time_point now) const;

    // Whether the stream has something to say that it has not said yet.
    bool has_for_stream() const { return next_for_stream() < next_; }
    // The next ones for the stream; the batch's numbers and inputs are set. The count that were
    // said for the first time.
    std::size_t take_for_stream(v1::InputBatch& batch);
    // All that is open, as far as a batch holds it.
    std::size_t take_for_datagram(v1::InputBatch& batch, Clock::time_point now);

    std::uint32_t last_said() const { return next_unsaid_ - 1; }

private:
    std::uint32_t next_for_stream() const;
    std::size_t put(v1::InputBatch& batch, std::uint32_t from) const;
    std::size_t said_until(std::uint32_t end);

    std::deque<v1::Input> inputs_;   // numbers first_ to next_ - 1
    std::uint32_t first_ = 1;        // the first that is kept
    std::uint32_t next_unsaid_ = 1;  // by whatever way
    std::uint32_t next_ = 1;         // of the next input
    std::uint32_t stream_next_ = 0;  // the stream said all before, without a gap; 0: it begins
    bool keeps_ = false;
    Clock::time_point open_since_{};  // said by datagram and not confirmed
};

}  // namespace jostle::client
