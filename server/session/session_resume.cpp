// SPDX-License-Identifier: MIT
#include "server/session/session_resume.h"

#include <chrono>
#include <utility>

#include "jostle/base/check.h"
#include "server/session/world_admission.h"
#include "server/util/address.h"

namespace jostle::server {

namespace {

// An older connection checks about twenty times per second whether it was superseded.
constexpr auto supersede_timeout = std::chrono::seconds(2);
// A world that is restored to an earlier tick runs again within this time, or its clients retry.
constexpr auto world_replacement_timeout = std::chrono::seconds(10);
// Validity of a token that outlives the process; no session is retained for that long.
constexpr auto token_life = std::chrono::hours(24);

}  // namespace

SessionResume::Attempt SessionResume::attempt(const Hello& hello, Clock::duration age) {
    ASSERT(hello.resume.has_value());
    ASSERT(!is_open());
    ResumeRegistry::Claim claim = context_.resume_registry.claim(hello.resume->token);
    switch (claim.status) {
        case ResumeRegistry::ClaimStatus::unknown:
            return {};
        case ResumeRegistry::ClaimStatus::pending:
            return age > supersede_timeout ? Attempt{} : wait(hello);
        case ResumeRegistry::ClaimStatus::claimed:
            break;
    }
    return claimed(std::move(claim), hello, age);
}

SessionResume::Attempt SessionResume::claimed(ResumeRegistry::Claim claim, const Hello& hello,
                                              Clock::duration age) {
    ASSERT(claim.client.has_value() && claim.resume_session != nullptr);
    DisconnectedClient& lost = *claim.client;
    const auto current = context_.worlds.find(lost.broadcast->host().id());
    if (current && current.get() != &lost.broadcast->host())
        lost.move_to(
            context_.broadcast_caches.cache_for(current, context_.config.stream.interest_cell_m));
    const WorldHost& host = lost.broadcast->host();
    const bool world_runs = !host.lifecycle().stopped();
    const auto timeout =
        host.lifecycle().was_replaced() ? world_replacement_timeout : supersede_timeout;
    if (!world_runs && host.is_persisted() && age <= timeout) {
        context_.resume_registry.suspend(*claim.resume_session, std::move(lost), claim.until);
        return wait(hello);
    }
    Result<std::string> subject = world_runs ? check(hello, lost) : std::string();
    if (!world_runs || (!subject.ok() && subject.error().code == ErrorCode::not_found)) {
        context_.resume_registry.close(*claim.resume_session);
        release_client(context_, lost);
        return {};
    }
    if (!subject.ok()) {
        context_.resume_registry.suspend(*claim.resume_session, std::move(lost), claim.until);
        return {.outcome = Outcome::rejected, .error = subject.error()};
    }
    take_entry(std::move(claim.resume_session));
    set_admission(lost.by_ticket, hello.spectator);
    return {.outcome = Outcome::resumed, .client = std::move(lost), .subject = *std::move(subject)};
}

// A ticket is redeemed once, so the token of the session replaces it, with the same rights. Returns
// the subject of the client.
Result<std::string> SessionResume::check(const Hello& hello, const DisconnectedClient& lost) {
    if (lost.by_ticket) {
        if (lost.spectator && !hello.spectator)
            return Error{ErrorCode::permission_denied,
                         "hello.spectator: the session of a spectator cannot be resumed as a "
                         "player; a player needs its own ticket"};
        return lost.subject;
    }
    Result<AdmittedClient> admitted = admit_by_token(context_, peer_, hello);
    if (!admitted.ok()) return admitted.error();
    if (admitted->subject != lost.subject)
        return Error{ErrorCode::permission_denied,
                     "hello.resume.token: the session belongs to another subject"};
    if (admitted->world.get() != &lost.broadcast->host())
        return Error{ErrorCode::not_found,
                     "hello.resume.token: the session belongs to another world"};
    return std::move(admitted->subject);
}

SessionResume::Attempt SessionResume::wait(const Hello& hello) {
    waiting_hello_ = std::make_unique<Hello>(hello);
    return {.outcome = Outcome::waiting};
}

void SessionResume::take_entry(std::shared_ptr<ResumeSession> entry) {
    entry_ = std::move(entry);
    if (entry_) sent_log_ = std::make_unique<SentLog>();
}

void SessionResume::open(ClientId client, const WorldHost& world, const std::string& subject) {
    ASSERT(client != 0);
    ASSERT(!is_open());
    const ResumeToken who{.client = client,
                          .world = world.id(),
                          .subject = subject,
                          .by_ticket = by_ticket_,
                          .spectator = spectator_,
                          .expires = std::chrono::floor<std::chrono::seconds>(
                              std::chrono::system_clock::now() + token_life)};
    take_entry(context_.resume_registry.open(client, world.is_persisted() ? &who : nullptr));
}

void SessionResume::suspend(DisconnectedClient client, Clock::time_point now) {
    ASSERT(is_open());
    ASSERT(client.client == entry_->client);
    client.network = network_of(peer_.address);
    client.by_ticket = by_ticket_;
    client.spectator = spectator_;
    client.sent = std::move(*sent_log_);
    context_.resume_registry.suspend(
        *entry_, std::move(client),
        now + from_seconds(context_.config.client.resume_timeout_seconds));
}

void SessionResume::close() {
    if (entry_) context_.resume_registry.close(*entry_);
}

}  // namespace jostle::server
