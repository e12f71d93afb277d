// SPDX-License-Identifier: MIT
//
// The protocol of one client, independent of the transport. The client sends a Hello, then inputs
// and acknowledgements; the server sends entity updates, results and snapshots, until one side ends
// the session. A transport passes arriving messages in, calls take_message() when it can write and
// something may have changed, and closes its stream when end() is set.
//
// Threads: one thread per session. Worlds, directories and caches behind the context are used from
// any thread.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/messages/out_message.h"
#include "server/session/joined_world.h"
#include "server/session/outbox.h"
#include "server/session/peer.h"
#include "server/session/play_context.h"
#include "server/session/session_metrics.h"
#include "server/session/session_network_simulator.h"
#include "server/session/session_resume.h"
#include "server/session/session_timeouts.h"
#include "server/util/clock.h"

namespace jostle::server {

class ClientSession {
public:
    ClientSession(PlayContext& context, Peer peer, Clock::time_point now);
    ClientSession(const ClientSession&) = delete;
    ClientSession& operator=(const ClientSession&) = delete;

    // Handles the bytes of one ClientMessage.
    void receive(std::string_view bytes, Clock::time_point now);
    // The client closed its side, or the connection broke.
    void on_peer_closed(Clock::time_point now);
    // Handles received datagrams and sends the snapshot that is due by datagram. Call it before
    // each write to the stream, even while the stream is blocked.
    void take_datagrams(Clock::time_point now);
    bool has_datagrams() const {
        return joined_ && joined_->datagrams() && joined_->datagrams()->has_messages();
    }
    // The client violated the protocol: sends a notice, then ends the session. `resumable`: the
    // client may resume it.
    void refuse(Error error, Clock::time_point now, bool resumable = false);
    // The server failed to read or make a message: ends the session without sending anything.
    void on_fault(Clock::time_point now);
    // The next message to write. Nothing: call again after a message arrived, a world published a
    // frame, or 50 ms passed. If calls stop for process_stall_min, timeouts are extended.
    std::optional<OutMessage> take_message(Clock::time_point now);
    // The transport cannot write yet: frames that pass meanwhile count as skipped. Checks timeouts.
    void wait_for_write(Clock::time_point now);

    // How the session ended; set once. The transport finishes when take_message() returns nothing.
    const std::optional<Status>& end() const { return end_; }
    Clock::time_point end_time() const { return end_time_; }
    bool hello_received() const { return joined_ != nullptr; }

private:
    void handle_bytes(std::string_view bytes, Clock::time_point now);
    void handle_delayed_bytes(Clock::time_point now, bool at_once = false);
    void drop_excess_message(Clock::time_point now);
    void on_message(const Hello& hello, Clock::time_point now);
    void on_message(const InputBatch& batch, Clock::time_point now);
    void on_message(const Ack& ack, Clock::time_point now);
    void on_message(const Ping& ping, Clock::time_point now);
    void on_message(const Leave& leave, Clock::time_point now);
    void on_message(const Interest& interest, Clock::time_point now);

    std::optional<OutMessage> next_message(Clock::time_point now);
    void check_end(Clock::time_point now);
    void finish(Status status, Clock::time_point now, bool resumable = false);

    PlayContext& context_;
    SessionMetrics metrics_{context_};
    const Peer peer_;
    SessionTimeouts timeouts_;
    Outbox outbox_;
    SessionResume resume_{context_, peer_};
    std::unique_ptr<SessionNetworkSimulator> network_simulator_;  // null: not simulated
    std::unique_ptr<JoinedWorld> joined_;  // null: no Hello was accepted; remains after the end
    bool drain_notified_ = false;
    std::optional<Status> end_;
    Clock::time_point end_time_{};
};

}  // namespace jostle::server
