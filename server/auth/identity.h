// SPDX-License-Identifier: MIT
//
// The identity of a caller: authorizer.h derives it from a token, a client certificate or neither,
// and rights, quotas and audit lines depend on it. A value; any thread.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
    std::string key;  // VerifyKey::id() of the key that signed the token; empty: no token
    std::vector<std::string> worlds;  // ids or names of the accessible worlds; empty: any world
    std::string token_id;             // "jti" for the audit log; empty: absent

    // Whether the token is limited to certain worlds. Its holder has no rights on the server as a
    // whole, whatever its role.
    bool is_limited_to_worlds() const { return !worlds.empty(); }
    // Whether the token opens this world, whatever its role.
    bool opens(std::string_view world_id, std::string_view world_name) const {
        return worlds.empty() || std::ranges::any_of(worlds, [&](const std::string& world) {
                   return world == world_id || world == world_name;
               });
    }
};

}  // namespace jostle::server
