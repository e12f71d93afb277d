// SPDX-License-Identifier: MIT
//
// JSON Web Tokens (RFC 7519), signed by a login service and presented by clients. Tokens are
// verified as RFC 8725 advises: one algorithm, which the token cannot choose; keys only from the
// server's own set; iss, aud, sub and exp required; a lifetime of at most one day. Pure functions;
// any thread.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "server/auth/identity.h"
#include "server/auth/verify_key.h"
#include "server/util/wall_time.h"

namespace jostle::server {

using VerifyKeys = std::map<std::string, VerifyKey, std::less<>>;  // by "kid"

inline constexpr std::size_t token_bytes_max = 8192;
inline constexpr std::size_t subject_bytes_max = 128;
inline constexpr std::chrono::hours token_life_max{24};

struct TokenRules {
    std::string issuer, audience;
    std::chrono::seconds leeway{30};  // tolerated clock difference
};

// The identity in the token, if its signature, times and parties are valid. Each fault has its own
// unauthenticated message, which quotes nothing from the token. The identity expires with the
// token, including the leeway.
Result<Identity> verify_token(std::string_view token, const VerifyKeys& keys,
                              const TokenRules& rules, WallTime now);

}  // namespace jostle::server
