// SPDX-License-Identifier: MIT
//
// Decides whether a Hello may join a world, by the token of the stream, the token of the Hello, or
// a ticket. Any thread.
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/session/peer.h"
#include "server/session/play_context.h"

namespace jostle::server {

struct AdmittedClient {
    std::shared_ptr<WorldHost> world;  // never null
    std::string subject;               // from its token or ticket, or anonymous_subject
    bool by_ticket = false;
};

// Errors: the world does not exist, or the client may not join it. Redeems the ticket, if any.
Result<AdmittedClient> admit_to_world(PlayContext& context, const Peer& peer, const Hello& hello);
// The same without the ticket, for clients that resume by the token of their session.
Result<AdmittedClient> admit_by_token(PlayContext& context, const Peer& peer, const Hello& hello);

}  // namespace jostle::server
