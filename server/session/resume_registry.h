// SPDX-License-Identifier: MIT
//
// Where clients come back whose connection broke. Each that said that it would has a seat here,
// with a token that nobody else can guess. When its link breaks, what the link knew is left here
// for a while: the client is lost, but has not left. A client that comes back before its old link
// has noticed asks that link to give way. Any thread.
//
// Tokens are bytes of no meaning to clients: random ones, or, where worlds outlive the process,
// sealed ones (resume_token.h), by which those come back who played when it ended.
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

#include "server/replication/baseline_tracker.h"
#include "server/session/broadcast_cache.h"
#include "server/session/resume_token.h"
#include "server/session/sent_log.h"
#include "server/util/clock.h"
#include "server/world/result_queue.h"

namespace jostle::server {

// What of a conversation outlives its connection.
struct DisconnectedClient {
    ClientId client = 0;
    std::shared_ptr<BroadcastCache> broadcast;
    std::string network, subject;  // whence it came, and whom its token named
    bool by_ticket = false;        // how it came in
    bool spectator = false;
    std::shared_ptr<ResultQueue> result_queue;
    std::vector<InputResult> results;      // not told yet
    std::uint32_t last_sequence = 0;       // of the inputs that came
    std::uint32_t persisted_sequence = 0;  // ... and were answered
    // Of a stream that tells of all of the world; else it begins anew.
    bool stream_resumable = false;
    BaselineTracker baselines;
    SentLog sent;
    std::set<std::uint64_t> sent_geometry;
    std::uint64_t channel_kinds = 0;

    // Its world was begun again: what it was told is of no use any longer.
    void move_to(std::shared_ptr<BroadcastCache> again) {
        broadcast = std::move(again);
        stream_resumable = false;
        sent = {};
    }
};

// One client's; held by its link.
struct ResumeSession {
    std::string token;
    ClientId client = 0;
    std::atomic<bool> is_superseded{false};  // the client came back: the link gives way
};

class ResumeRegistry {
public:
    static constexpr std::size_t token_bytes = 16;

    // Before anybody comes: tokens are sealed with it.
    void use_secret(std::string secret);
    // One who played before this process began, at most until then.
    void expect(DisconnectedClient client, Clock::time_point until);
    // Null: the operating system gave no random bytes. `who`: for a token that outlives the process
    // if it fits into one.
    std::shared_ptr<ResumeSession> open(ClientId client, const ResumeToken* who = nullptr);
    // The client is gone for good.
    void close(const ResumeSession& resume_session);
    void suspend(const ResumeSession& resume_session, DisconnectedClient client,
                 Clock::time_point until);

    enum class ClaimStatus { unknown, pending, claimed };
    struct Claim {
        ClaimStatus status = ClaimStatus::unknown;
        std::shared_ptr<ResumeSession> resume_session;  // claimed
        std::optional<DisconnectedClient> client;       // claimed
        Clock::time_point until{};                      // claimed: when it would have left
    };
    // pending: its old link was told to give way; ask again in a moment.
    Claim claim(std::string_view token, WallTime now = std::chrono::system_clock::now());

    // Those whose time is over: they have left.
    std::vector<DisconnectedClient> take_expired(Clock::time_point now);
    // The one that was lost first, of that network if it is not empty: there is no room for it.
    std::optional<DisconnectedClient> take_oldest(const std::string& network);
    std::size_t disconnected() const;

private:
    struct Entry {
        std::shared_ptr<ResumeSession> resume_session;
        std::unique_ptr<DisconnectedClient> client;  // null: its link is there
        Clock::time_point until{};
    };

    Entry* find_expected(std::string_view token, WallTime now);

    mutable std::mutex mutex_;
    std::string secret_;  // empty: none
    std::map<ClientId, Entry> entries_;
};

}  // namespace jostle::server
