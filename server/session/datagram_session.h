// SPDX-License-Identifier: MIT
//
// What a ClientSession has beside its stream when its client takes datagrams: the way there, which
// frames the client has, and whether snapshots should go by it now. They do while the client is
// heard and acknowledges what it is sent. What no datagram can hold, and what there is no base for,
// goes by the stream, which has its own bases: the frames that the client acknowledged, then those
// sent by it without a datagram in between.
//
// Thread rule: the link's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "server/messages/out_message.h"
#include "server/replication/acked_frames.h"
#include "server/udp/datagram_server.h"

namespace jostle::server {

class DatagramSession {
public:
    // Of a snapshot; with 2 % loss a fifth of those would not arrive whole.
    static constexpr std::size_t fragments_max = 12;

    DatagramSession(DatagramServer& port, std::shared_ptr<DatagramConnection> path)
        : port_(port), connection_(std::move(path)) {}
    ~DatagramSession() { port_.close(*connection_); }
    DatagramSession(const DatagramSession&) = delete;
    DatagramSession& operator=(const DatagramSession&) = delete;

    bool has_messages() const { return connection_->has_messages(); }
    std::vector<DatagramConnection::ReceivedMessage> take_messages() {
        return connection_->take_messages();
    }

    // Whether the snapshot of that tick goes by datagrams, if it fits.
    bool carries(std::uint32_t tick, Clock::time_point now);
    AckedFrames& frames() { return frames_; }
    const AckedFrames& frames() const { return frames_; }
    void on_ack(std::uint32_t frame, std::uint32_t before, Clock::time_point now);

    // Whether a message fits; if not, snapshots go by the stream for a while.
    bool fits(std::size_t bytes, Clock::time_point now);
    void send(const OutMessage& snapshot, std::uint32_t frame, Clock::time_point now);
    // Whether the last snapshot went by a datagram: others may be lost.
    bool sent_last() const { return after_datagram_; }
    void on_sent_by_stream(std::uint32_t frame);
    // The bases of a stream that has not been used since the last datagram; nothing: it has been.
    std::optional<BaselineTracker> take_stream_baselines();

private:
    DatagramServer& port_;
    const std::shared_ptr<DatagramConnection> connection_;
    AckedFrames frames_;
    std::uint32_t last_sent_ = 0;                     // by datagram
    std::optional<Clock::time_point> unacked_since_;  // of these; nothing: all are acknowledged
    Clock::time_point by_stream_until_{};
    bool after_datagram_ = false;
};

}  // namespace jostle::server
