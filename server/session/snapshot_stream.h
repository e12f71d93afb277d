// SPDX-License-Identifier: MIT
//
// Assembles the snapshots of one client from the frames of its world. A change of the entity list
// is sent before the first snapshot that needs it. While snapshots go by datagram, the stream
// carries replies: snapshots without poses and channels, with the data that must not be lost.
// Used on the session's thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/messages/out_message.h"
#include "server/replication/baseline_tracker.h"
#include "server/session/broadcast_cache.h"
#include "server/session/datagram_session.h"
#include "server/session/entity_stream.h"
#include "server/session/input_intake.h"
#include "server/session/outbox.h"
#include "server/session/play_context.h"
#include "server/session/sent_log.h"
#include "server/session/session_metrics.h"
#include "server/session/snapshot_schedule.h"
#include "server/session/snapshot_sections.h"
#include "server/util/clock.h"

namespace jostle::server {

class SnapshotStream {
public:
    // All of these outlive the stream.
    struct Parts {
        PlayContext& context;
        SessionMetrics& metrics;
        BroadcastCache& broadcast;
        std::shared_ptr<PoseCache> poses;
        InputIntake& inputs;
        Outbox& outbox;
        OverloadControl* overload = nullptr;  // of the thread; null: it is never overloaded
        SentLog* sent_log = nullptr;          // null: the session cannot be resumed
        ClientId client = 0;
    };
    // `divider`: the client receives every divider-th tick.
    SnapshotStream(const Parts& parts, const Hello& hello, int divider);

    // Registers with the world. Returns its newest frame; the events begin after it.
    FramePtr on_enter();
    void on_leave() { sections_.on_leave(parts_.broadcast.host().listeners()); }

    // The next message for an empty outbox: an entity update, a snapshot or a reply.
    std::optional<OutMessage> take_message(Clock::time_point now);
    void on_write_blocked() { schedule_.set_write_blocked(true); }
    void on_other_sent() { schedule_.flow().on_other_sent(); }
    void on_ack(const Ack& ack, Clock::time_point now);
    Status set_interest(const Interest& interest);
    bool has_cells() const { return sections_.cells() != nullptr; }
    snapshot::Codec codec() const { return codec_; }
    const PoseCache& poses() const { return *parts_.poses; }

    // --- datagrams ---
    // Snapshots go by datagram where possible. Call it before the first message.
    void use_datagrams(DatagramSession& datagrams);
    void stop_datagrams() { datagrams_ = nullptr; }
    // Takes note of a new frame before a snapshot is sent by datagram. Returns the frame of the
    // snapshot if one is due and newer than the last one, else null.
    FramePtr prepare_datagram(const FramePtr& newest, Clock::time_point now);
    // The shared part of a snapshot for a client that has the frames `known`. Null: the frame has
    // its maximum of encodings, and the snapshot is no longer due.
    SharedBytes encode(const FramePtr& frame, const BaselineTracker& known);
    void on_sent_by_datagram(const OutMessage& snapshot, const Frame& frame, Clock::time_point now);
    // Newest tick considered; 0: none.
    std::uint32_t last_frame() const { return schedule_.last_frame(); }
    double round_trip_s() const { return schedule_.flow().round_trip_s(); }
    void drop_sent_before(Clock::time_point time) { schedule_.flow().drop_sent_before(time); }

    // --- resume ---
    // Moves the state of the stream out, and back in. `known`: what the client has after `frame`.
    void suspend(DisconnectedClient& client);
    bool resume(DisconnectedClient& lost, SentLog::Known& known, std::uint32_t frame);
    // Continues the user messages after the last one that the client received (0: none). `first`:
    // DisconnectedClient::messages_at_entry.
    void resume_messages(std::optional<std::uint32_t> first, std::uint32_t last_received);

private:
    void on_frame(const Frame& frame, Clock::time_point now);
    bool has_changes(const Frame& frame, Clock::time_point now);
    bool send_entity_list(const FramePtr& frame);
    std::uint32_t newest_sent() const;
    FramePtr frame_to_send(const FramePtr& newest) const;
    void measure_send_delay(const Frame& frame, Clock::time_point now);
    std::optional<OutMessage> make_snapshot(const FramePtr& frame, Clock::time_point now);
    std::optional<OutMessage> make_reply(const FramePtr& frame, Clock::time_point now);
    void on_results_sent(std::uint32_t tick);

    const Parts parts_;
    const snapshot::Codec codec_;
    DatagramSession* datagrams_ = nullptr;  // null: the stream carries everything
    BaselineTracker baselines_;             // of the stream
    EntityStream entities_;
    SnapshotSchedule schedule_;
    SnapshotSections sections_;
    std::uint32_t events_at_entry_ = 0;    // number of ticks with events when the client entered
    std::uint32_t messages_at_entry_ = 0;  // number of user messages when the client first entered
    Clock::time_point keyframe_requested_{};
};

}  // namespace jostle::server
