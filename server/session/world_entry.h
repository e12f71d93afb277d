// SPDX-License-Identifier: MIT
//
// Handles the Hello of a session: a client resumes its suspended session or joins a world as a new
// client. Used on the session's thread.
#pragma once

#include <memory>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/session/joined_world.h"
#include "server/util/clock.h"

namespace jostle::server {

// `age`: time since the connection began. Null: the attempt to resume waits, and
// SessionResume::take_waiting_hello() returns the Hello for the next call. Errors: the client must
// be refused.
Result<std::unique_ptr<JoinedWorld>> enter_world(const JoinedWorld::Parts& parts,
                                                 const Hello& hello, Clock::duration age,
                                                 Clock::time_point now);

}  // namespace jostle::server
