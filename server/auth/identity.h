// SPDX-License-Identifier: MIT
//
// Who is asking: what authorizer.h makes of a token, a client's certificate or nothing, and what
// every right, quota and audit line goes by. A value; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/util/wall_time.h"

namespace jostle::server {

// Each may do what those before it may. `none`: only what is open to all (access_table.h).
enum class Role { none, viewer, player, director, admin };

std::string_view name_of(Role role);
std::optional<Role> parse_role(std::string_view name);

// Subjects that no token may name: whoever shows nothing, and holders of client certificates.
inline constexpr std::string_view anonymous_subject = "anonymous";
inline constexpr std::string_view certificate_prefix = "certificate:";

struct Identity {
    std::string subject{anonymous_subject};  // the owner of the worlds that it creates
    Role role = Role::none;
    bool anonymous = true;
    WallTime expires = WallTime::max();
    std::string world;     // id or name of the only world that it may touch; empty: any
    std::string token_id;  // "jti", for the audit log; empty: the token has none
};

}  // namespace jostle::server
