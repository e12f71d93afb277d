// SPDX-License-Identifier: MIT
//
// The datagram connection of one session: which frames the client acknowledged, and whether
// snapshots should go by datagram now. They do while the client acknowledges them. Snapshots that
// are too large, or have no acknowledged baseline, go by the stream. The stream has its own
// baselines: the frames that the client acknowledged, then those that the stream carried without a
// datagram in between.
//
// Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "jostle/base/check.h"
#include "server/messages/out_message.h"
#include "server/replication/acked_frames.h"
#include "server/udp/datagram_server.h"

namespace jostle::server {

class DatagramSession {
public:
    // Maximum number of fragments of a snapshot. At 2 % packet loss, a fifth of the snapshots of
    // this size arrive incomplete.
    static constexpr std::size_t fragments_max = 12;

    DatagramSession(DatagramServer& server, std::shared_ptr<DatagramConnection> connection)
        : server_(server), connection_(std::move(connection)) {
        ASSERT(connection_ != nullptr);
    }
    ~DatagramSession() { server_.close(*connection_); }
    DatagramSession(const DatagramSession&) = delete;
    DatagramSession& operator=(const DatagramSession&) = delete;

    bool has_messages() const { return connection_->has_messages(); }
    std::vector<DatagramConnection::ReceivedMessage> take_messages() {
        return connection_->take_messages();
    }

    // Whether the snapshot of this tick goes by datagram if it fits. Restarts the path validation
    // if the client has acknowledged nothing for too long.
    bool carries(std::uint32_t tick, Clock::time_point now);
    AckedFrames& frames() { return frames_; }
    const AckedFrames& frames() const { return frames_; }
    // `ack_bits`: see AckedFrames.
    void on_ack(std::uint32_t frame, std::uint32_t ack_bits, Clock::time_point now);

    // Whether a message fits into a datagram; if not, snapshots go by the stream for a second.
    bool fits(std::size_t bytes, Clock::time_point now);
    void send(const OutMessage& snapshot, std::uint32_t frame, Clock::time_point now);
    // Whether the last snapshot went by datagram, so that earlier ones may be lost.
    bool sent_last() const { return after_datagram_; }
    void on_sent_by_stream(std::uint32_t frame);
    // The new baselines of the stream after a datagram; nothing: the stream carried the last
    // snapshot, and its baselines are valid.
    std::optional<BaselineTracker> take_stream_baselines();

private:
    DatagramServer& server_;
    const std::shared_ptr<DatagramConnection> connection_;
    AckedFrames frames_;
    std::uint32_t last_sent_ = 0;                     // newest frame sent by datagram
    std::optional<Clock::time_point> unacked_since_;  // nothing: every datagram is acknowledged
    Clock::time_point by_stream_until_{};
    bool after_datagram_ = false;
};

}  // namespace jostle::server
