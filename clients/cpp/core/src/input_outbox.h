// SPDX-License-Identifier: MIT
//
// Inputs on the way to the server, with sequence numbers from 1. A stream sends each input once. If
// datagrams may carry inputs too, or if the session is resumable, each input is stored until the
// server has confirmed it. A datagram contains all stored inputs from the first one on. A stream
// that takes over does the same, because the server rejects sequence numbers that it has passed.
// One thread at a time. The web SDK has the stream variant
// (clients/web/sdk/src/connection/input_queue.ts).
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
    static constexpr std::size_t waiting_max = 4096;  // unsent
    static constexpr std::size_t batch_max = 32;

    // Starts a new session with sequence numbers from 1. Unsent inputs stay queued; sent ones are
    // dropped.
    void start_new_session();
    // Continues the session on a new stream: the server has the inputs up to `last_sequence`; later
    // ones are sent again.
    void resume_after(std::uint32_t last_sequence, Clock::time_point now);
    // Whether to store inputs until they are confirmed.
    void retain_until_confirmed(bool keeps) { retains_ = keeps; }
    void drop_unsent();
    // Returns the sequence number; 0: too many inputs are queued.
    std::uint32_t push(v1::Input input);
    // The server has received all inputs up to this number.
    void confirm(std::uint32_t received, Clock::time_point now);
    // Adds a result. The input is confirmed when all earlier ones have results as well. Returns
    // false if the result was already received on the previous connection.
    bool on_result(std::uint32_t sequence, Clock::time_point now);

    // At least one input is unconfirmed.
    bool has_unconfirmed() const { return first_ < next_; }
    // All unconfirmed inputs fit into one batch of `bytes_max` bytes.
    bool fits(std::size_t bytes_max) const;
    // An input sent by datagram was not confirmed within `timeout`.
    bool is_stalled(Clock::duration timeout, Clock::time_point now) const;

    // The newest input was not sent yet and names its tick: waiting would need a larger margin.
    bool has_unsent_timed() const { return next_unsent_ < next_ && inputs_.back().tick() != 0; }
    // The stream has unsent inputs.
    bool has_for_stream() const { return next_for_stream() < next_; }
    // Fills a batch with the next inputs for the stream. Returns the number of inputs sent for the
    // first time.
    std::size_t take_for_stream(v1::InputBatch& batch);
    // Fills a batch with all unconfirmed inputs that fit. Returns the number of inputs sent for the
    // first time.
    std::size_t take_for_datagram(v1::InputBatch& batch, Clock::time_point now);

    std::uint32_t last_sent() const { return next_unsent_ - 1; }

private:
    std::uint32_t next_for_stream() const;
    std::size_t put(v1::InputBatch& batch, std::uint32_t from) const;
    std::size_t mark_sent_until(std::uint32_t end);

    std::deque<v1::Input> inputs_;               // sequence numbers first_ to next_ - 1
    std::deque<std::uint32_t> awaiting_result_;  // ascending
    std::uint32_t first_ = 1;                    // the first stored input
    std::uint32_t next_unsent_ = 1;              // over either transport
    std::uint32_t next_ = 1;                     // of the next input
    std::uint32_t stream_next_ = 0;  // the stream sent all before it, without a gap; 0: nothing yet
    bool retains_ = false;
    bool resumed_ = false;                   // results may arrive twice
    Clock::time_point unconfirmed_since_{};  // start of waiting for a confirmation
};

}  // namespace jostle::client
