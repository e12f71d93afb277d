// SPDX-License-Identifier: MIT
//
// The identity of a caller: authorizer.h derives it from a token, a client certificate or neither,
// and rights, quotas and audit lines depend on it. A value; any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/util/wall_time.h"

namespace jostle::server {

// Each role includes the rights of all earlier ones. `none`: only calls open to all
// (access_table.h).
enum class Role { none, viewer, player, director, admin };

std::string_view name_of(Role role);
std::optional<Role> parse_role(std::string_view name);

// Subjects that no token may name: anonymous callers and holders of client certificates.
inline constexpr std::string_view anonymous_subject = "anonymous";
inline constexpr std::string_view certificate_prefix = "certificate:";

struct Identity {
    std::string subject{anonymous_subject};  // owns the worlds that it creates
    Role role = Role::none;
    bool anonymous = true;
    WallTime expires = WallTime::max();
    std::string world;     // id or name of the only accessible world; empty: any world
    std::string token_id;  // "jti" for the audit log; empty: absent
};

}  // namespace jostle::server
