// SPDX-License-Identifier: MIT
#include "server/auth/identity.h"

#include <algorithm>
#include <array>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

constexpr std::array<std::string_view, 5> role_names = {"none", "viewer", "player", "director",
                                                        "admin"};

}  // namespace

std::string_view name_of(Role role) {
    ASSERT(static_cast<std::size_t>(role) < role_names.size());
    return role_names[static_cast<std::size_t>(role)];
}

std::optional<Role> parse_role(std::string_view name) {
    const auto at = std::ranges::find(role_names, name);
    if (at == role_names.end()) return std::nullopt;
    return static_cast<Role>(at - role_names.begin());
}

}  // namespace jostle::server
