// SPDX-License-Identifier: MIT
//
// Timeouts of one session: no Hello, no messages, no inputs, no reads. Time in which this process
// or its machine was stalled does not count against the client. Used on the session's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "jostle/base/result.h"
#include "server/config/config.h"
#include "server/util/clock.h"

namespace jostle::server {

class SessionTimeouts {
public:
    // `idle_kick_seconds`: 0 disables the idle timeout.
    SessionTimeouts(const StreamSettings& settings, Clock::time_point now,
                    double idle_kick_seconds = 0)
        : settings_(settings),
          idle_kick_seconds_(idle_kick_seconds),
          begun_(now),
          last_received_(now),
          last_input_(now),
          checked_(now) {}

    void on_received(Clock::time_point now) {
        last_received_ = now;
        sent_bytes_ = 0;
    }
    // A client answers after it has received what is on its way: a large world over a slow link
    // takes longer than the timeout.
    void on_sent(std::size_t bytes) { sent_bytes_ += bytes; }
    // Datagrams are taken some time after they arrived, possibly after a newer stream message.
    void on_datagram(Clock::time_point arrived);
    void on_joined(Clock::time_point now) { last_input_ = now; }
    // `sequence`: of the newest input. The client is active if it changed.
    void on_input_sequence(std::uint32_t sequence, Clock::time_point now);
    void on_write_blocked(Clock::time_point now);
    void on_writable() { blocked_since_.reset(); }

    // Call before each check. If the previous call is more than process_stall_min ago, every
    // timeout is extended by that time.
    void forgive_process_stall(Clock::time_point now);

    // Why the session ends now; nothing: it does not.
    std::optional<Error> hello_timeout(Clock::time_point now) const;
    std::optional<Error> client_timeout(Clock::time_point now) const;
    // The time that `bytes` take over the slowest link that is waited for, at most 2 minutes.
    static double transfer_seconds(std::size_t bytes);
    // Only for players.
    std::optional<Error> idle_timeout(Clock::time_point now) const;
    std::optional<Error> read_timeout(Clock::time_point now) const;

    Clock::duration age(Clock::time_point now) const { return now - begun_; }

private:
    const StreamSettings& settings_;
    const double idle_kick_seconds_;
    Clock::time_point begun_, last_received_, last_input_, checked_;
    std::uint32_t input_sequence_ = 0;
    std::size_t sent_bytes_ = 0;                      // since the last message arrived
    std::optional<Clock::time_point> blocked_since_;  // nothing: the transport can write
};

}  // namespace jostle::server
