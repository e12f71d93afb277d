// SPDX-License-Identifier: MIT
//
// Decides when a session ends for a reason other than a message of its client: timeouts, operators,
// a newer connection of the same client, the end of its world. Used on the session's thread.
#pragma once

#include <optional>

#include "jostle/base/result.h"
#include "server/messages/server_message.h"
#include "server/session/joined_world.h"
#include "server/session/outbox.h"
#include "server/session/session_metrics.h"
#include "server/session/session_resume.h"
#include "server/session/session_timeouts.h"
#include "server/util/clock.h"
#include "server/world/world_host.h"

namespace jostle::server {

struct SessionEnd {
    Error error;                            // status of the stream, and text of the notice
    std::optional<NoticeKind> notice = {};  // sent before the end; nothing: none
    bool resumable = false;                 // the client may resume the session
    bool drops_outgoing = false;            // messages that are queued are not sent
};

// Nothing: the world runs.
std::optional<SessionEnd> end_of_world(const WorldHost& host);

// Nothing: the session continues. Before a Hello `joined` is null.
std::optional<SessionEnd> end_of_session(const SessionTimeouts& timeouts,
                                         const SessionMetrics& metrics, SessionResume& resume,
                                         const Outbox& outbox, const JoinedWorld* joined,
                                         Clock::time_point now);

}  // namespace jostle::server
