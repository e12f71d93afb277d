// SPDX-License-Identifier: MIT
#include "server/session/resume_registry.h"

#include <unistd.h>

#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Takes the same time wherever the first difference is.
bool are_equal(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i < a.size(); i++)
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    return difference == 0;
}

}  // namespace

void ResumeRegistry::use_secret(std::string secret) {
    const std::lock_guard lock(mutex_);
    secret_ = std::move(secret);
}

void ResumeRegistry::expect(DisconnectedClient client, Clock::time_point until) {
    ASSERT(client.client != 0);
    ASSERT(client.broadcast != nullptr);
    auto resume_session = std::make_shared<ResumeSession>();
    resume_session->client = client.client;
    const std::lock_guard lock(mutex_);
    entries_[resume_session->client] = {
        .resume_session = resume_session,
        .client = std::make_unique<DisconnectedClient>(std::move(client)),
        .until = until};
}

std::shared_ptr<ResumeSession> ResumeRegistry::open(ClientId client, ResumeHolder holder,
                                                    const ResumeToken* who) {
    auto resume_session = std::make_shared<ResumeSession>();
    resume_session->client = client;
    resume_session->holder = std::move(holder);
    const std::lock_guard lock(mutex_);
    std::optional<std::string> sealed;
    if (who && !secret_.empty()) sealed = seal_token(*who, secret_);
    if (sealed) {
        resume_session->token = *std::move(sealed);
    } else {
        resume_session->token.resize(token_bytes);
        if (::getentropy(resume_session->token.data(), resume_session->token.size()) != 0)
            return nullptr;
    }
    entries_[client] = {.resume_session = resume_session, .client = nullptr};
    return resume_session;
}

void ResumeRegistry::close(const ResumeSession& resume_session) {
    const std::lock_guard lock(mutex_);
    entries_.erase(resume_session.client);
}

void ResumeRegistry::suspend(const ResumeSession& resume_session, DisconnectedClient client,
                             Clock::time_point until) {
    const std::lock_guard lock(mutex_);
    const auto at = entries_.find(resume_session.client);
    if (at == entries_.end()) return;
    ASSERT(!at->second.client);
    at->second.client = std::make_unique<DisconnectedClient>(std::move(client));
    at->second.until = until;
}

void ResumeRegistry::set_holder(ResumeSession& resume_session, ResumeHolder holder) {
    const std::lock_guard lock(mutex_);
    resume_session.holder = std::move(holder);
}

// Compares all entries, so that the time reveals nothing about their tokens.
const ResumeRegistry::Entry* ResumeRegistry::find_entry(std::string_view token) const {
    const Entry* found = nullptr;
    if (token.empty()) return found;
    for (const auto& [client, entry] : entries_)
        if (are_equal(entry.resume_session->token, token)) found = &entry;
    return found;
}

// A client of an earlier process that has not resumed yet.
std::optional<ResumeRegistry::Expected> ResumeRegistry::find_expected(std::string_view token,
                                                                      WallTime now) const {
    if (secret_.empty()) return std::nullopt;
    std::optional<ResumeToken> who = open_token(token, secret_, now);
    if (!who) return std::nullopt;
    const auto at = entries_.find(who->client);
    if (at == entries_.end()) return std::nullopt;
    const Entry& entry = at->second;
    if (!entry.resume_session->token.empty() || !entry.client) return std::nullopt;
    if (entry.client->broadcast->host().id() != who->world) return std::nullopt;
    Expected expected{.client = who->client};
    Identity& identity = expected.holder.who;
    identity.anonymous = who->subject == anonymous_subject;
    identity.subject = std::move(who->subject);
    identity.expires = who->token_expires;
    identity.key = std::move(who->key);
    expected.holder.ticket = std::move(who->ticket);
    expected.holder.spectator = who->spectator;
    return expected;
}

std::optional<ResumeHolder> ResumeRegistry::find_holder(std::string_view token,
                                                        WallTime now) const {
    const std::lock_guard lock(mutex_);
    if (const Entry* found = find_entry(token)) return found->resume_session->holder;
    std::optional<Expected> expected = find_expected(token, now);
    if (!expected) return std::nullopt;
    return std::move(expected->holder);
}

ResumeRegistry::Claim ResumeRegistry::claim(std::string_view token, WallTime now) {
    const std::lock_guard lock(mutex_);
    const Entry* known = find_entry(token);
    Entry* found = known ? &entries_.at(known->resume_session->client) : nullptr;
    if (!found) {
        std::optional<Expected> expected = find_expected(token, now);
        if (!expected) return {};
        found = &entries_.at(expected->client);
        found->resume_session->token = token;  // an ordinary entry from now on
        found->resume_session->holder = std::move(expected->holder);
    }
    found->resume_session->is_superseded = !found->client;
    if (!found->client)
        return {.status = ClaimStatus::pending, .resume_session = nullptr, .client = {}};
    const std::unique_ptr<DisconnectedClient> client = std::exchange(found->client, nullptr);
    return {.status = ClaimStatus::claimed,
            .resume_session = found->resume_session,
            .client = std::move(*client),
            .until = found->until};
}

std::vector<DisconnectedClient> ResumeRegistry::take_expired(Clock::time_point now) {
    std::vector<DisconnectedClient> expired;
    const std::lock_guard lock(mutex_);
    for (auto at = entries_.begin(); at != entries_.end();) {
        Entry& entry = at->second;
        if (!entry.client || now < entry.until) {
            ++at;
            continue;
        }
        expired.push_back(*std::move(entry.client));
        at = entries_.erase(at);
    }
    return expired;
}

// Call with the mutex locked.
template <class Filter>
std::optional<DisconnectedClient> ResumeRegistry::take_oldest_if(Filter&& filter) {
    auto oldest = entries_.end();
    for (auto at = entries_.begin(); at != entries_.end(); ++at) {
        const Entry& entry = at->second;
        if (!entry.client || !filter(entry)) continue;
        if (oldest == entries_.end() || entry.until < oldest->second.until) oldest = at;
    }
    if (oldest == entries_.end()) return std::nullopt;
    std::optional<DisconnectedClient> client = std::move(*oldest->second.client);
    entries_.erase(oldest);
    return client;
}

std::optional<DisconnectedClient> ResumeRegistry::take_oldest(const std::string& network) {
    const std::lock_guard lock(mutex_);
    return take_oldest_if(
        [&](const Entry& entry) { return network.empty() || entry.client->network == network; });
}

std::optional<DisconnectedClient> ResumeRegistry::take_oldest_of(const std::string& subject) {
    const std::lock_guard lock(mutex_);
    return take_oldest_if([&](const Entry& entry) {
        const Identity& who = entry.resume_session->holder.who;
        return !who.anonymous && who.subject == subject;
    });
}

std::size_t ResumeRegistry::disconnected() const {
    const std::lock_guard lock(mutex_);
    std::size_t count = 0;
    for (const auto& [client, entry] : entries_) count += entry.client ? 1 : 0;
    return count;
}

}  // namespace jostle::server
