// SPDX-License-Identifier: MIT
#include "server/session/world_entry.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "jostle/base/check.h"
#include "server/session/world_admission.h"

namespace jostle::server {

namespace {

Status check_hello(const PlayContext& context, const Hello& hello) {
    if (context.draining)
        return Error{ErrorCode::unavailable,
                     "the server is shutting down; connect to another server"};
    if (hello.protocol != protocol_version)
        return Error{ErrorCode::failed_precondition,
                     fmt::format("hello.protocol is {}; this server supports {}", hello.protocol,
                                 protocol_version)};
    return {};
}

// Releases the id of a client if memory runs out while it joins.
struct IdGuard {
    const JoinedWorld::Parts& parts;
    ClientId client;

    ~IdGuard() {
        if (client == 0) return;
        parts.resume.close();
        parts.context.sessions.leave(client);
    }
};

std::unique_ptr<JoinedWorld> join(const JoinedWorld::Parts& parts, ClientId client,
                                  const std::shared_ptr<WorldHost>& world, const Hello& hello,
                                  DisconnectedClient* lost, Clock::time_point now) {
    IdGuard guard{parts, client};
    if (!lost && hello.resumable && parts.context.config.client.resume_timeout_seconds > 0)
        parts.resume.open(client, *world, parts.metrics.subject());
    auto joined = std::make_unique<JoinedWorld>(parts, client, world, hello, lost, now);
    guard.client = 0;  // from here on `joined` releases it
    joined->enter(hello, lost, now);
    return joined;
}

Result<std::unique_ptr<JoinedWorld>> join_as_new(const JoinedWorld::Parts& parts,
                                                 const Hello& hello, Clock::time_point now) {
    const Result<AdmittedClient> admitted = admit_to_world(parts.context, parts.peer, hello);
    if (!admitted.ok()) return admitted.error();
    const Result<ClientId> client =
        acquire_client_id(parts.context, *admitted->world, parts.peer.address);
    if (!client.ok()) return client.error();
    parts.metrics.set_subject(admitted->subject);
    parts.resume.set_admission(admitted->by_ticket, hello.spectator);
    return join(parts, *client, admitted->world, hello, nullptr, now);
}

}  // namespace

Result<std::unique_ptr<JoinedWorld>> enter_world(const JoinedWorld::Parts& parts,
                                                 const Hello& hello, Clock::duration age,
                                                 Clock::time_point now) {
    if (Status s = check_hello(parts.context, hello); !s.ok()) return s.error();
    if (!hello.resume) return join_as_new(parts, hello, now);
    SessionResume::Attempt attempt = parts.resume.attempt(hello, age);
    switch (attempt.outcome) {
        case SessionResume::Outcome::new_client:
            return join_as_new(parts, hello, now);
        case SessionResume::Outcome::waiting:
            return std::unique_ptr<JoinedWorld>();
        case SessionResume::Outcome::rejected:
            return *std::move(attempt.error);
        case SessionResume::Outcome::resumed:
            break;
    }
    ASSERT(attempt.client.has_value());
    parts.metrics.set_subject(attempt.subject);
    DisconnectedClient& lost = *attempt.client;
    return join(parts, lost.client, nullptr, hello, &lost, now);
}

}  // namespace jostle::server
