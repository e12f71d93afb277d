// SPDX-License-Identifier: MIT
//
// The sessions that can be resumed after their connection breaks. Each has an entry with a token
// that no other client can guess. When the connection breaks, the registry retains the state of the
// session until the resume timeout: the client is disconnected, but has not left. If a client
// resumes before the server noticed that its old connection broke, the old session is marked as
// superseded and ends. Any thread.
//
// Tokens are opaque to clients. They are random, or sealed (resume_token.h) if the world is
// persisted, so that clients can resume after a restart of the server.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "server/auth/identity.h"
#include "server/replication/baseline_tracker.h"
#include "server/session/broadcast_cache.h"
#include "server/session/resume_token.h"
#include "server/session/sent_log.h"
#include "server/util/clock.h"
#include "server/world/command_mailbox.h"

namespace jostle::server {

// The state of a session that outlives its connection.
struct DisconnectedClient {
    ClientId client = 0;
    std::shared_ptr<BroadcastCache> broadcast;
    std::string network;  // util/address.h
    std::shared_ptr<ResultQueue> result_queue;
    std::vector<InputResult> results;      // not sent yet
    std::uint32_t last_sequence = 0;       // newest input received
    std::uint32_t persisted_sequence = 0;  // newest input with a result
    // The stream can continue after a snapshot that the client has; otherwise it starts again with
    // a keyframe.
    bool stream_resumable = false;
    BaselineTracker baselines;
    SentLog sent;
    std::set<std::uint64_t> sent_geometry;
    std::uint64_t channel_kinds = 0;
    StreamPrecision precision = {};
    // Number of user messages when the client first entered; nothing: it entered in an earlier
    // process.
    std::optional<std::uint32_t> messages_at_entry = {};

    // Another host continues the world: the snapshots that the client has are no longer baselines.
    void move_to(std::shared_ptr<BroadcastCache> replacement) {
        broadcast = std::move(replacement);
        stream_resumable = false;
        sent = {};
    }
};

// The identity that a client must prove to resume a session.
struct ResumeHolder {
    Identity who;        // after a restart of the server only subject, expiry and key
    std::string ticket;  // Tickets::digest() of its ticket; empty: admitted without a ticket
    bool spectator = false;
};

// The entry of one client, shared with its session.
struct ResumeSession {
    std::string token;
    ClientId client = 0;
    ResumeHolder holder;                     // guarded by the registry
    std::atomic<bool> is_superseded{false};  // the client resumed elsewhere: the session ends
};

class ResumeRegistry {
public:
    static constexpr std::size_t token_bytes = 16;

    // The key for sealed tokens. Call it before the first client connects.
    void use_secret(std::string secret);
    // Adds a client of an earlier process, which may resume until `until`.
    void expect(DisconnectedClient client, Clock::time_point until);
    // Null: the operating system returned no random bytes. `who`: content of a sealed token; the
    // token is random if `who` is null or too long.
    std::shared_ptr<ResumeSession> open(ClientId client, ResumeHolder holder = {},
                                        const ResumeToken* who = nullptr);
    // The client resumed with other credentials of the same subject.
    void set_holder(ResumeSession& resume_session, ResumeHolder holder);
    // The client left for good.
    void close(const ResumeSession& resume_session);
    // The connection broke. The client may resume until `until`.
    void suspend(const ResumeSession& resume_session, DisconnectedClient client,
                 Clock::time_point until);

    // The identity required for the session of a token; nothing: unknown token. Changes nothing:
    // the caller must verify the holder before it calls claim(), which ends the old session.
    std::optional<ResumeHolder> find_holder(std::string_view token,
                                            WallTime now = std::chrono::system_clock::now()) const;

    enum class ClaimStatus { unknown, pending, claimed };
    struct Claim {
        ClaimStatus status = ClaimStatus::unknown;
        // Set if claimed:
        std::shared_ptr<ResumeSession> resume_session;
        std::optional<DisconnectedClient> client;
        Clock::time_point until{};  // end of the resume timeout
    };
    // Takes the suspended client of a token. pending: its old session was marked as superseded; try
    // again when it has ended.
    Claim claim(std::string_view token, WallTime now = std::chrono::system_clock::now());

    // Takes the clients whose resume timeout is over.
    std::vector<DisconnectedClient> take_expired(Clock::time_point now);
    // Takes the client that was suspended first, to make room. `network`: only clients of this
    // network; empty: all.
    std::optional<DisconnectedClient> take_oldest(const std::string& network);
    // The same among the clients of an authenticated subject.
    std::optional<DisconnectedClient> take_oldest_of(const std::string& subject);
    std::size_t disconnected() const;

private:
    struct Entry {
        std::shared_ptr<ResumeSession> resume_session;
        std::unique_ptr<DisconnectedClient> client;  // null: it is connected
        Clock::time_point until{};
    };

    struct Expected {
        ClientId client = 0;
        ResumeHolder holder;
    };
    template <class Filter>
    std::optional<DisconnectedClient> take_oldest_if(Filter&& filter);
    const Entry* find_entry(std::string_view token) const;
    std::optional<Expected> find_expected(std::string_view token, WallTime now) const;

    mutable std::mutex mutex_;
    std::string secret_;  // empty: tokens are random
    std::map<ClientId, Entry> entries_;
};

}  // namespace jostle::server
