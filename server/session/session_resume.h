// SPDX-License-Identifier: MIT
//
// The resumption of one session: opens the entry of the session in the ResumeRegistry, claims the
// entry of an earlier session by its token, and suspends the session when its connection breaks.
// Used on the session's thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/session/peer.h"
#include "server/session/play_context.h"
#include "server/session/resume_registry.h"
#include "server/session/sent_log.h"
#include "server/util/clock.h"

namespace jostle::server {

class SessionResume {
public:
    SessionResume(PlayContext& context, const Peer& peer) : context_(context), peer_(peer) {}

    enum class Outcome {
        new_client,  // the client joins as a new one
        waiting,     // take_waiting_hello() returns the Hello for the next attempt
        rejected,    // with an error
        resumed,     // with the client
    };
    struct Attempt {
        Outcome outcome = Outcome::new_client;
        std::optional<Error> error = {};
        std::optional<DisconnectedClient> client = {};
    };
    // Claims the session of hello.resume. `age`: time since the connection began; it bounds the
    // wait for an older connection to end or for the world to restart. The older connection ends
    // only after the Hello has proved the identity of its client.
    Attempt attempt(const Hello& hello, Clock::duration age);
    // The ticket that attempt() redeemed before it decided that the client is new.
    const std::optional<Authorizer::Entry>& redeemed_ticket() const { return redeemed_; }
    std::unique_ptr<Hello> take_waiting_hello() { return std::move(waiting_hello_); }

    // The admitted identity and its credentials; sealed into the token.
    void set_holder(ResumeHolder holder) { holder_ = std::move(holder); }
    const Identity& who() const { return holder_.who; }
    // Whether the credentials of the session are still valid. Looks at most four times per second,
    // or after a change of the keys.
    Status check_credentials(Clock::time_point now);
    // Opens the entry of a new session. The session cannot be resumed if the operating system
    // returns no random bytes.
    void open(ClientId client, const WorldHost& world);
    // Suspends an open session.
    void suspend(DisconnectedClient client, Clock::time_point now);
    // The client left for good.
    void close();

    bool is_open() const { return entry_ != nullptr; }
    // The client resumed on another connection, so this one must end.
    bool is_superseded() const { return entry_ && entry_->is_superseded; }
    std::string token() const { return entry_ ? entry_->token : std::string(); }
    // Null: the session is not open.
    SentLog* sent_log() { return sent_log_.get(); }

private:
    Attempt claimed(ResumeRegistry::Claim claim, const Hello& hello, Clock::duration age);
    Status prove_identity(const Hello& hello, const ResumeHolder& holder);
    Status check_rights(const Hello& hello, const DisconnectedClient& lost);
    Attempt wait(const Hello& hello);
    void take_entry(std::shared_ptr<ResumeSession> entry);

    PlayContext& context_;
    const Peer& peer_;
    std::unique_ptr<Hello> waiting_hello_;  // null: no attempt is waiting
    std::shared_ptr<ResumeSession> entry_;
    std::unique_ptr<SentLog> sent_log_;
    ResumeHolder holder_;         // of this session, or of the session that it resumes
    bool is_proved_ = false;      // prove_identity() succeeded
    bool by_own_ticket_ = false;  // the Hello shows the ticket of the suspended session again
    std::optional<Authorizer::Entry> redeemed_;
    Clock::time_point next_check_{};
    std::uint64_t checked_revision_ = 0;
};

}  // namespace jostle::server
