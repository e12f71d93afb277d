// SPDX-License-Identifier: MIT
//
// What a client comes back with to a server that was started anew: who it was, with a seal that
// only the servers of one store can make. Of no meaning to clients. Pure functions; any thread.
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
    std::string world;       // its id
    std::string subject;     // whom its own token named
    bool by_ticket = false;  // how it came in
    bool spectator = false;
    WallTime expires{};  // in whole seconds

    bool operator==(const ResumeToken&) const = default;
};

// HMAC-SHA256 over all of it. Nothing: it would be longer than clients may send back.
std::optional<std::string> seal_token(const ResumeToken& token, std::string_view secret);
// Nothing: it was not made with that secret, was changed, or has expired.
std::optional<ResumeToken> open_token(std::string_view sealed, std::string_view secret,
                                      WallTime now);

}  // namespace jostle::server
