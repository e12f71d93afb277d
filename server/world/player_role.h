// SPDX-License-Identifier: MIT
//
// The role of a client in one world, PlayerRole of play.proto. It is part of the state of the world
// and independent of the server-wide roles of tokens (server/auth). Any thread.
#pragma once

#include <cstdint>
#include <string_view>

namespace jostle::server {

// The numbers are those of jostle.v1.PlayerRole; journals and saved worlds contain them.
enum class PlayerRole : std::uint8_t { unspecified, spectator, player, builder, owner };

inline constexpr std::uint32_t player_roles = 5;

// The role of a client that joins, unless the world assigns another one. `spectator`:
// Hello.spectator.
constexpr PlayerRole initial_role(bool spectator) {
    return spectator ? PlayerRole::spectator : PlayerRole::player;
}

constexpr std::string_view name_of(PlayerRole role) {
    constexpr std::string_view names[player_roles] = {"unspecified", "spectator", "player",
                                                      "builder", "owner"};
    const auto index = static_cast<std::uint32_t>(role);
    return index < player_roles ? names[index] : "unknown";
}

}  // namespace jostle::server
