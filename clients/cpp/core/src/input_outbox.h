// SPDX-License-Identifier: MIT
//
// Inputs on their way to the server, under numbers that rise from 1. Over a stream each is said
// once. Where datagrams may carry them too, or the connection may break and be taken up again, each
// is kept until the server is known to have it: a datagram says all that are kept, from the first
// on, and so does a stream that takes over, because the server refuses to go back to a number that
// it has passed. One thread at a time. The browser's (clients/web/src/input_queue.ts) has a stream
// alone.
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

    // A new client, whose numbers begin anew: what was not said yet stays, and what was is
    // forgotten.
    void start_new_session();
    // The same client on a new stream: the server has the inputs up to that one, and those after it
    // are said again.
    void resume_after(std::uint32_t last_sequence, Clock::time_point now);
    // Until confirmed.
    void retain_until_confirmed(bool keeps) { retains_ = keeps; }
    void drop_unsent();
    // Its number; 0: too many wait.
    std::uint32_t push(v1::Input input);
    // The server has all up to that number.
    void confirm(std::uint32_t received, Clock::time_point now);
    // One was answered: it is done with when all before it are. False: it was answered before, on
    // the connection that broke.
    bool on_result(std::uint32_t sequence, Clock::time_point now);

    // Whether the server is not known to have all.
    bool has_unconfirmed() const { return first_ < next_; }
    // Whether all that is open fits into one batch of so many bytes.
    bool fits(std::size_t bytes_max) const;
    // Something that a datagram said was not confirmed for so long.
    bool is_stalled(Clock::duration timeout, Clock::time_point now) const;

    // Whether the stream has something to say that it has not said yet.
    bool has_for_stream() const { return next_for_stream() < next_; }
    // The next ones for the stream; the batch's numbers and inputs are set. The count that were
    // said for the first time.
    std::size_t take_for_stream(v1::InputBatch& batch);
    // All that is open, as far as a batch holds it.
    std::size_t take_for_datagram(v1::InputBatch& batch, Clock::time_point now);

    std::uint32_t last_sent() const { return next_unsent_ - 1; }

private:
    std::uint32_t next_for_stream() const;
    std::size_t put(v1::InputBatch& batch, std::uint32_t from) const;
    std::size_t mark_sent_until(std::uint32_t end);

    std::deque<v1::Input> inputs_;               // numbers first_ to next_ - 1
    std::deque<std::uint32_t> awaiting_result_;  // rising
    std::uint32_t first_ = 1;                    // the first that is kept
    std::uint32_t next_unsent_ = 1;              // by whatever way
    std::uint32_t next_ = 1;                     // of the next input
    std::uint32_t stream_next_ = 0;  // the stream said all before, without a gap; 0: it begins
    bool retains_ = false;
    bool resumed_ = false;                   // answers may come twice
    Clock::time_point unconfirmed_since_{};  // said by datagram and not confirmed
};

}  // namespace jostle::client
