// SPDX-License-Identifier: MIT
//
// JSON Web Tokens (RFC 7519): what a login service signs and a client shows. A token is read as
// RFC 8725 advises: one algorithm, which the token cannot choose; keys from our own set alone; all
// of iss, aud, sub and exp; a day at most. Pure functions; any thread.
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
    std::chrono::seconds leeway{30};  // by which clocks may differ
};

// Who the token says it is for, once its signature, times and parties hold. Each fault has a
// message of its own, unauthenticated, which quotes nothing of the token. The identity expires with
// the token, leeway included.
Result<Identity> verify_token(std::string_view token, const VerifyKeys& keys,
                              const TokenRules& rules, WallTime now);

}  // namespace jostle::server
