// SPDX-License-Identifier: MIT
//
// How a request or a conversation ended, whatever the transport: gRPC makes a status of it, HTTP a
// status line, a WebSocket a close code. The meanings are those of gRPC's codes of the same names.
#pragma once

#include <string>

namespace jostle::server {

enum class AnswerCode {
    ok,
    invalid_argument,  // the request is wrong whatever the state: do not repeat it
    not_found,
    already_exists,
    failed_precondition,  // right request, wrong state (protocol version, spectator)
    unauthenticated,      // no ticket, or one that is not good (any more)
    resource_exhausted,   // full, or too much: later, and slower
    deadline_exceeded,    // the client was silent too long
    aborted,              // the server ended it: the world was closed
    unavailable,          // going down: try another server, or later
    internal,
};

struct Answer {
    AnswerCode code = AnswerCode::ok;
    std::string message;

    bool ok() const { return code == AnswerCode::ok; }
};

}  // namespace jostle::server
