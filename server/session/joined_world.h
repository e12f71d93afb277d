// SPDX-License-Identifier: MIT
//
// One client in the world that it joined: its inputs, its snapshots and its datagrams. A
// ClientSession creates it for an accepted Hello. Used on the session's thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/messages/server_message.h"
#include "server/session/broadcast_cache.h"
#include "server/session/datagram_transport.h"
#include "server/session/flood_guard.h"
#include "server/session/input_intake.h"
#include "server/session/outbox.h"
#include "server/session/peer.h"
#include "server/session/play_context.h"
#include "server/session/session_metrics.h"
#include "server/session/session_resume.h"
#include "server/session/snapshot_stream.h"
#include "server/util/clock.h"

namespace jostle::server {

class JoinedWorld {
public:
    // The parts of the session that the world uses. They outlive this object.
    struct Parts {
        PlayContext& context;
        SessionMetrics& metrics;
        Outbox& outbox;
        SessionResume& resume;
        const Peer& peer;
    };
    // `lost`: the suspended session that the client resumes; null: the client is new and joins
    // `world`. Takes over the id.
    JoinedWorld(const Parts& parts, ClientId client, const std::shared_ptr<WorldHost>& world,
                const Hello& hello, DisconnectedClient* lost, Clock::time_point now);

    ~JoinedWorld() { leave(std::nullopt); }
    JoinedWorld(const JoinedWorld&) = delete;
    JoinedWorld& operator=(const JoinedWorld&) = delete;

    // Registers with the world and queues the welcome.
    void enter(const Hello& hello, DisconnectedClient* lost, Clock::time_point now);
    // Unregisters from the world; queued messages remain. `suspended`: when the connection broke,
    // if the client may resume; nothing: the client leaves for good. Further calls do nothing.
    void leave(std::optional<Clock::time_point> suspended);

    Status receive(const InputBatch& batch, Clock::time_point now);
    // The verdict on a message that exceeded the message rate. Queues the notice.
    FloodGuard::Verdict on_excess_message(Clock::time_point now);

    ClientId client() const { return client_; }
    bool has_left() const { return has_left_; }
    WorldHost& host() const { return broadcast_->host(); }
    InputIntake& inputs() { return inputs_; }
    const InputIntake& inputs() const { return inputs_; }
    SnapshotStream& snapshots() { return snapshots_; }
    DatagramTransport* datagrams() { return datagrams_.get(); }  // null: the stream alone
    const DatagramTransport* datagrams() const { return datagrams_.get(); }

private:
    std::optional<std::vector<EntityId>> resume(DisconnectedClient& lost, std::uint32_t frame,
                                                const EntityList& now);
    Welcome welcome(const Frame& frame, Clock::time_point now) const;
    DisconnectedClient suspended_state();
    void leave_for_good();

    const Parts parts_;
    const ClientId client_;
    const std::shared_ptr<BroadcastCache> broadcast_;  // never null
    const int divider_;                                // every divider_-th tick is sent
    const ClientLimits limits_;                        // with the acknowledgements of this rate
    InputIntake inputs_;
    SnapshotStream snapshots_;
    FloodGuard flood_guard_;
    std::unique_ptr<DatagramTransport> datagrams_;
    bool has_entered_ = false, has_left_ = false;
};

// Handles the Hello of a session: a client resumes its suspended session or joins a world as a new
// client. `age`: time since the connection began. Null: the attempt to resume waits, and
// SessionResume::take_waiting_hello() returns the Hello for the next call. Errors: the client must
// be refused.
Result<std::unique_ptr<JoinedWorld>> enter_world(const JoinedWorld::Parts& parts,
                                                 const Hello& hello, Clock::duration age,
                                                 Clock::time_point now);

}  // namespace jostle::server
