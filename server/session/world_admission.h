// SPDX-License-Identifier: MIT
//
// Decides whether a Hello may join a world, by the token of the stream, the token of the Hello, or
// a ticket. Any thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "jostle/base/result.h"
#include "server/messages/client_message.h"
#include "server/session/peer.h"
#include "server/session/play_context.h"

namespace jostle::server {

struct AdmittedClient {
    std::shared_ptr<WorldHost> world;  // never null
    Identity who;
    std::string ticket;  // Tickets::digest() of its ticket; empty: admitted without a ticket
};

// The identity that the token of a Hello, or else its transport, proves.
Result<Identity> identify_by_token(PlayContext& context, const Peer& peer, const Hello& hello);
// Redeems the ticket of a Hello. Errors: the named world does not exist, or the ticket is invalid.
Result<Authorizer::Entry> redeem_ticket(PlayContext& context, const Peer& peer, const Hello& hello);

// Errors: the world does not exist, or the client may not join it. `redeemed`: the ticket of the
// Hello, if it was redeemed already; otherwise it is redeemed now.
Result<AdmittedClient> admit_to_world(PlayContext& context, const Peer& peer, const Hello& hello,
                                      const std::optional<Authorizer::Entry>& redeemed = {});
// The same without the ticket.
Result<AdmittedClient> admit_by_token(PlayContext& context, const Peer& peer, const Hello& hello);

}  // namespace jostle::server
