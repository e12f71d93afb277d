// SPDX-License-Identifier: MIT
#include "server/session/session_end.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

namespace jostle::server {

namespace {

// A client with more unread replies or results than this does not read its stream.
constexpr std::size_t replies_max = 256, results_max = 4096;

SessionEnd refused(Error error, bool resumable = false) {
    return {std::move(error), NoticeKind::refused, resumable};
}

}  // namespace

std::optional<SessionEnd> end_of_world(const WorldHost& host) {
    const WorldLifecycle& lifecycle = host.lifecycle();
    if (lifecycle.failed()) {
        const bool persisted = host.is_persisted();
        const char* why = persisted ? "a server fault ended the world; it restarts from its last "
                                      "checkpoint and journal"
                                    : "a server fault ended the world; it restarts from its scene";
        return SessionEnd{{ErrorCode::unavailable, why}, NoticeKind::world_restarted, persisted};
    }
    if (lifecycle.was_replaced())
        return SessionEnd{{ErrorCode::unavailable, "the world is restored to an earlier tick"},
                          NoticeKind::world_restarted,
                          true};
    if (lifecycle.stopped())
        return SessionEnd{{ErrorCode::aborted, "the world was closed"}, NoticeKind::world_closed};
    return std::nullopt;
}

std::optional<SessionEnd> end_of_session(const SessionTimeouts& timeouts,
                                         const SessionMetrics& metrics, SessionResume& resume,
                                         const Outbox& outbox, const JoinedWorld* joined,
                                         Clock::time_point now) {
    if (!joined) {
        if (std::optional<Error> error = timeouts.hello_timeout(now))
            return refused(*std::move(error));
        return std::nullopt;
    }
    if (const auto why = metrics.kicked())
        return refused({ErrorCode::permission_denied, "an operator removed the client: " + *why});
    if (joined->host().properties().is_room) {
        const RoomView room = joined->host().frame()->room;
        if (const RoomClient* const client = room->find(joined->client());
            client && client->removed)
            return refused({ErrorCode::permission_denied,
                            "the client was removed from the room: " + client->removed_reason});
    }
    // Without valid credentials the client may return with a new token; a banned one may not.
    if (Status s = resume.check_credentials(now); !s.ok())
        return refused(s.error(), s.error().code == ErrorCode::unauthenticated);
    if (resume.is_superseded())
        return SessionEnd{
            {ErrorCode::aborted, "the client resumed the session on another connection"},
            std::nullopt,
            true};
    if (std::optional<Error> error = timeouts.client_timeout(now))
        return refused(*std::move(error), true);
    if (!joined->inputs().is_spectator())
        if (std::optional<Error> error = timeouts.idle_timeout(now))
            return refused(*std::move(error));
    if (std::optional<SessionEnd> end = end_of_world(joined->host())) return end;
    if (outbox.replies() <= replies_max && joined->inputs().results().size() <= results_max)
        return std::nullopt;
    SessionEnd end = refused(
        {ErrorCode::resource_exhausted,
         fmt::format("the client does not read its stream: it has {} unread replies and {} unread "
                     "results; at most {} and {} are allowed",
                     outbox.replies(), joined->inputs().results().size(), replies_max,
                     results_max)});
    end.drops_outgoing = true;
    return end;
}

}  // namespace jostle::server
