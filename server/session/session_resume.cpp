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
constexpr auto credential_check_interval = std::chrono::milliseconds(250);

}  // namespace

SessionResume::Attempt SessionResume::attempt(const Hello& hello, Clock::duration age) {
    ASSERT(hello.resume.has_value());
    ASSERT(!is_open());
    if (!is_proved_) {
        const std::optional<ResumeHolder> holder =
            context_.resume_registry.find_holder(hello.resume->token);
        if (!holder) return {};
        if (Status s = prove_identity(hello, *holder); !s.ok())
            return {.outcome = Outcome::rejected, .error = s.error()};
        is_proved_ = true;
    }
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

// The token of a session is not a credential: it only names the session. An authenticated client
// must prove its subject again, by a token, by a new ticket, or by the ticket of the session while
// the token behind it is valid.
Status SessionResume::prove_identity(const Hello& hello, const ResumeHolder& holder) {
    holder_ = holder;
    by_own_ticket_ = !holder.ticket.empty() && Tickets::digest(hello.ticket) == holder.ticket;
    const bool is_anonymous_by_ticket = holder.who.anonymous && !holder.ticket.empty();
    if (!by_own_ticket_ && !is_anonymous_by_ticket) {
        Result<Identity> who = Identity{};
        if (hello.ticket.empty()) {
            who = identify_by_token(context_, peer_, hello);
            holder_.ticket.clear();
        } else {
            const Result<Authorizer::Entry> entry = redeem_ticket(context_, peer_, hello);
            if (!entry.ok()) return entry.error();
            redeemed_ = *entry;
            who = entry->who;
            holder_.ticket = Tickets::digest(hello.ticket);
        }
        if (!who.ok()) return who.error();
        if (who->anonymous && !holder.who.anonymous)
            return Error{ErrorCode::unauthenticated,
                         "hello.resume.token: the session belongs to an authenticated client; send "
                         "its token or a ticket as well"};
        if (who->subject != holder.who.subject)
            return Error{ErrorCode::permission_denied,
                         "hello.resume.token: the session belongs to another subject"};
        holder_.who = *std::move(who);
    }
    return context_.authorizer.check_session(holder_.who, peer_.address);
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
    const Status rights = world_runs ? check_rights(hello, lost) : Status{};
    if (!world_runs || (!rights.ok() && rights.error().code == ErrorCode::not_found)) {
        context_.resume_registry.close(*claim.resume_session);
        release_client(context_, lost);
        return {};
    }
    if (!rights.ok()) {
        context_.resume_registry.suspend(*claim.resume_session, std::move(lost), claim.until);
        return {.outcome = Outcome::rejected, .error = rights.error()};
    }
    holder_.spectator = hello.spectator;
    context_.resume_registry.set_holder(*claim.resume_session, holder_);
    take_entry(std::move(claim.resume_session));
    return {.outcome = Outcome::resumed, .client = std::move(lost)};
}

// A client that shows the ticket of its session again has the rights of the session and no more.
Status SessionResume::check_rights(const Hello& hello, const DisconnectedClient& lost) {
    const bool by_ticket = by_own_ticket_ || (holder_.who.anonymous && !holder_.ticket.empty());
    if (by_ticket) {
        if (holder_.spectator && !hello.spectator)
            return Error{ErrorCode::permission_denied,
                         "hello.spectator: the session of a spectator cannot be resumed as a "
                         "player; a player needs its own ticket"};
        return {};
    }
    const Result<AdmittedClient> admitted = redeemed_
                                                ? admit_to_world(context_, peer_, hello, redeemed_)
                                                : admit_by_token(context_, peer_, hello);
    if (!admitted.ok()) return admitted.error();
    if (admitted->world.get() != &lost.broadcast->host())
        return Error{ErrorCode::not_found,
                     "hello.resume.token: the session belongs to another world"};
    return {};
}

Status SessionResume::check_credentials(Clock::time_point now) {
    const std::uint64_t revision = context_.authorizer.revision();
    if (now < next_check_ && revision == checked_revision_) return {};
    next_check_ = now + credential_check_interval;
    checked_revision_ = revision;
    return context_.authorizer.check_session(holder_.who, peer_.address);
}

SessionResume::Attempt SessionResume::wait(const Hello& hello) {
    waiting_hello_ = std::make_unique<Hello>(hello);
    return {.outcome = Outcome::waiting};
}

void SessionResume::take_entry(std::shared_ptr<ResumeSession> entry) {
    entry_ = std::move(entry);
    if (entry_) sent_log_ = std::make_unique<SentLog>();
}

void SessionResume::open(ClientId client, const WorldHost& world) {
    ASSERT(client != 0);
    ASSERT(!is_open());
    const ResumeToken who{.client = client,
                          .world = world.id(),
                          .subject = holder_.who.subject,
                          .ticket = holder_.ticket,
                          .key = holder_.who.key,
                          .spectator = holder_.spectator,
                          .expires = std::chrono::floor<std::chrono::seconds>(
                              std::chrono::system_clock::now() + token_life),
                          .token_expires = holder_.who.expires};
    take_entry(
        context_.resume_registry.open(client, holder_, world.is_persisted() ? &who : nullptr));
}

void SessionResume::suspend(DisconnectedClient client, Clock::time_point now) {
    ASSERT(is_open());
    ASSERT(client.client == entry_->client);
    client.network = network_of(peer_.address);
    client.sent = std::move(*sent_log_);
    context_.resume_registry.suspend(
        *entry_, std::move(client),
        now + from_seconds(context_.config.client.resume_timeout_seconds));
}

void SessionResume::close() {
    if (entry_) context_.resume_registry.close(*entry_);
}

}  // namespace jostle::server
