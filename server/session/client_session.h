// SPDX-License-Identifier: MIT
//
// The conversation with one client, whatever the transport: hello, then inputs and acks one way,
// entity lists, results and snapshots the other, until somebody ends it. A transport hands in the
// messages that arrive, calls take_message() when it can write and something may have changed, and
// ends its stream when end() says so.
//
// Thread rule: one thread per link. Worlds, sessions and feeds behind the context take any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/limits/admission.h"
#include "server/limits/flow_control.h"
#include "server/messages/client_message.h"
#include "server/messages/out_message.h"
#include "server/messages/server_message.h"
#include "server/replication/baseline_tracker.h"
#include "server/replication/interest_view.h"
#include "server/session/datagram_session.h"
#include "server/session/peer.h"
#include "server/session/play_context.h"
#include "server/session/session_metrics.h"
#include "server/session/session_network_simulator.h"
#include "server/util/clock.h"
#include "server/util/fifo.h"
#include "server/world/result_queue.h"

namespace jostle::server {

class ClientSession {
public:
    ClientSession(PlayContext& context, Peer peer, Clock::time_point now);
    ~ClientSession();
    ClientSession(const ClientSession&) = delete;
    ClientSession& operator=(const ClientSession&) = delete;

    // One ClientMessage arrived.
    void receive(std::string_view bytes, Clock::time_point now);
    // The client closed its side, or the connection broke: there is nobody left to talk to.
    void on_peer_closed(Clock::time_point now);
    // What came by datagrams since, and the snapshot that is to go so. Call it before the stream is
    // written, whether the stream can be written or not.
    void take_datagrams(Clock::time_point now);
    bool has_datagrams() const { return datagrams_ && datagrams_->has_messages(); }
    // The transport met what it cannot take: a notice, then the end.
    void refuse(Error error, Clock::time_point now, bool lost = false);
    // A message could not be read or made by a fault of ours: nothing is sent any more.
    void on_fault(Clock::time_point now);
    // The next message to write. Nothing: call again when a message arrived, a world has a new
    // frame or 50 ms passed. When nobody called for half a second, this process or its machine
    // stood still, and that was not the client's silence.
    std::optional<OutMessage> take_message(Clock::time_point now);
    // The transport cannot write yet: a frame that comes and goes meanwhile counts as skipped.
    // Checks timeouts as well.
    void wait_for_write(Clock::time_point now);

    // Set once, when the conversation is over, to how it ended; the transport finishes when
    // take_message() has nothing more.
    const std::optional<Status>& end() const { return end_; }
    Clock::time_point end_time() const { return end_time_; }
    bool hello_received() const { return broadcast_ != nullptr; }

private:
    void handle_bytes(std::string_view bytes, Clock::time_point now);
    void handle_delayed_bytes(Clock::time_point now, bool at_once = false);
    // client_session_datagrams.cpp
    void receive_datagram(std::string_view bytes, Clock::time_point at, Clock::time_point now);
    void offer_datagrams(const Hello& hello, Welcome& welcome);
    bool send_by_datagram(const Frame& frame, Clock::time_point now);
    void send_datagram(Clock::time_point now);
    ClientUpdate datagram_client_update();
    std::optional<OutMessage> take_reply(Clock::time_point now);

    void on_message(const Hello& hello, Clock::time_point now);
    void on_message(const InputBatch& batch, Clock::time_point now);
    void on_message(const Ack& ack, Clock::time_point now);
    void on_message(const Ping& ping, Clock::time_point now);
    void on_message(const Leave& leave, Clock::time_point now);
    void on_message(const Interest& interest, Clock::time_point now);

    // client_session_resume.cpp: how a conversation goes on after its connection broke.
    bool resume(const Hello& hello, Clock::time_point now);
    Status may_resume(const Hello& hello, const DisconnectedClient& lost);
    std::optional<std::vector<EntityId>> resume_stream(DisconnectedClient& lost,
                                                       std::uint32_t frame, const EntityList& now);
    Result<ClientId> acquire_client_id(const WorldHost& world);
    // The client need not say the inputs up to this one again, whatever becomes of us.
    std::uint32_t confirmed() const {
        return broadcast_->host().is_persisted() ? persisted_sequence_ : last_sequence_;
    }
    std::shared_ptr<ResumeSession> open_resume_session(const WorldHost& world);
    void suspend(Clock::time_point now);
    // Whether what it is told of the world counts after a break: acks of datagrams and of cells say
    // nothing of what came by the stream.
    bool can_resume_stream() const { return resume_session_ && !interest_ && !datagrams_; }

    Result<std::shared_ptr<WorldHost>> find_world(const std::string& wanted) const;
    Result<std::shared_ptr<WorldHost>> authorize(const Hello& hello);
    Result<std::shared_ptr<WorldHost>> authorize_by_ticket(const Hello& hello);
    Status check_play_access(const Hello& hello, const Identity& who, const WorldHost& world) const;
    void enter(const std::shared_ptr<WorldHost>& world, const Hello& hello, Clock::time_point now,
               DisconnectedClient* lost = nullptr);
    void push_input(std::uint32_t sequence, const Result<Action>& input, std::uint32_t tick,
                    Clock::time_point now);
    Status try_push_input(std::uint32_t sequence, const Result<Action>& input, std::uint32_t tick,
                          Clock::time_point now);
    void drop_message(Clock::time_point now);

    void forgive_process_stall(Clock::time_point now);
    void check_timeouts(Clock::time_point now);
    void send(std::string message);
    void drop_outgoing();
    // `lost`: it may come back.
    void finish(Status status, Clock::time_point now, bool lost = false);
    void leave_world(std::optional<Clock::time_point> lost = {});
    void collect_results();

    std::optional<OutMessage> next_message(Clock::time_point now);
    std::optional<OutMessage> take_snapshot(Clock::time_point now);
    OutMessage take_cell_snapshot(const FramePtr& frame, Clock::time_point now);
    OutMessage snapshot_of(const FramePtr& frame, Clock::time_point now, std::string more,
                           std::vector<SharedBytes> cells);
    bool send_cell_members(const wire::QuantizedFrame& cell);
    void send_removed(const std::shared_ptr<const EntityList>& entities);
    void push(const EntityUpdateMessages& messages);
    bool has_changes(const Frame& frame, Clock::time_point now);
    std::uint32_t newest_sent() const;
    ClientUpdate client_update();
    std::string take_stats(const FramePtr& frame, Clock::time_point now);
    std::string take_events(const Frame& frame);
    std::string take_controlled_entity(const Frame& frame);
    void send_entities(const std::shared_ptr<const EntityList>& entities);
    void on_frame(const Frame& frame, Clock::time_point now);

    PlayContext& context_;
    SessionMetrics metrics_{context_};
    // Few have these, and links are many.
    std::unique_ptr<SessionNetworkSimulator> network_simulator_;  // null: the real link is enough
    const Peer peer_;
    Clock::time_point begun_;
    Clock::time_point last_received_;
    Clock::time_point timeouts_checked_;  // when timeouts were checked last
    std::optional<Status> end_;
    Clock::time_point end_time_{};
    Fifo<OutMessage> outgoing_;        // to send, not yet taken
    std::size_t replies_pending_ = 0;  // of these, what is not shared; bounded
    bool draining_sent_ = false;
    std::unique_ptr<Hello> waiting_hello_;  // of one whose old link is to give way first

    // From here on: of a client that sent its Hello.
    ClientId client_ = 0;  // 0: not yet, or no longer in a world
    std::shared_ptr<BroadcastCache> broadcast_;
    ClientLimits limits_;
    std::shared_ptr<ResumeSession> resume_session_;  // null: its place is not kept
    SentLog sent_log_;                               // of one with a seat
    bool by_ticket_ = false, spectator_ = false;
    std::optional<Admission> admission_;
    std::optional<FlowControl> flow_;
    std::shared_ptr<ResultQueue> result_queue_;
    std::vector<InputResult> results_;      // to be told
    std::uint32_t last_sequence_ = 0;       // received
    std::uint32_t persisted_sequence_ = 0;  // answered, and so kept where anything is
    std::uint32_t client_time_us_ = 0;      // of the newest batch; 0: was told
    int dropped_ = 0;                       // messages since dropping_since_
    Clock::time_point dropping_since_{}, last_keyframe_{}, last_snapshot_{}, last_stats_{};
    ClientUpdate sent_update_;  // the numbers that were told last

    BaselineTracker baselines_;
    std::unique_ptr<DatagramSession> datagrams_;  // null: all goes by the stream
    std::uint32_t sent_received_ = 0;             // Private.input_received
    // Of results since the last datagram; 0: there was none.
    std::uint32_t unsent_sequence_ = 0;
    std::int32_t unsent_margin_us_ = 0;
    wire::Codec codec_ = wire::Codec::bits;
    std::unique_ptr<InterestView> interest_;  // null: it is told of all of the world
    std::vector<bool> known_entities_;        // by id: what it was told of, when it has a sight
    bool more_to_send_ = false;
    std::shared_ptr<const EntityList> entity_list_;  // what the client knows
    std::set<std::uint64_t> sent_geometry_;          // likewise: large shapes, by id
    std::uint64_t channel_kinds_ = 0;                // that it understands, a bit each
    bool wants_events_ = false, wants_motion_ = false, wants_controlled_entity_ = false;
    struct SentControlledEntity {
        EntityId entity = 0;
        std::uint32_t tick = 0;
        std::vector<std::uint32_t> words;
    };
    std::unique_ptr<SentControlledEntity> sent_controlled_entity_;  // null: nothing yet
    std::uint32_t event_cursor_ = 0;     // as RecentEvents counts; sent or missed
    std::uint32_t events_missed_ = 0;    // since the last that were sent
    std::uint32_t last_frame_tick_ = 0;  // newest frame that was decided on
    bool snapshot_due_ = false;
    bool write_blocked_ = false;
    std::optional<Clock::time_point> writing_since_;  // what the client does not take
    std::uint32_t skipped_pending_ = 0;
};

}  // namespace jostle::server
