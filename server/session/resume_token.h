// SPDX-License-Identifier: MIT
//
// Tokens with which clients resume after a restart of the server: the identity of the client,
// sealed with a key that only the servers of one database have. Opaque to clients. Pure functions;
// any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "server/util/wall_time.h"
#include "server/world/command.h"

namespace jostle::server {

struct ResumeToken {
    ClientId client = 0;
    std::string world;    // its id
    std::string subject;  // from its own token or ticket, or anonymous_subject
    std::string ticket;   // Tickets::digest() of its ticket; empty: admitted without a ticket
    std::string key;      // Identity::key
    bool spectator = false;
    WallTime expires{};        // of the sealed token, in whole seconds
    WallTime token_expires{};  // Identity::expires, in whole seconds

    bool operator==(const ResumeToken&) const = default;
};

// Seals with HMAC-SHA256. Nothing: the token would be longer than a Hello may contain.
std::optional<std::string> seal_token(const ResumeToken& token, std::string_view secret);
// Nothing: the token was sealed with another secret, was changed, or has expired.
std::optional<ResumeToken> open_token(std::string_view sealed, std::string_view secret,
                                      WallTime now);

}  // namespace jostle::server
