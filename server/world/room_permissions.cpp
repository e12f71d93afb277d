// SPDX-License-Identifier: MIT
#include "server/world/room_permissions.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

constexpr std::array<std::string_view, room_actions> action_names = {
    "spawn", "drag",     "push", "explode", "delete", "joints",   "control", "message",
    "vote",  "clean_up", "mute", "kick",    "ban",    "set_role", "protect", "pause",
    "reset", "settings", "edit", "clone",   "speed",  "rewind"};
constexpr std::array<std::string_view, reaches> reach_names = {"none", "own", "unowned", "any"};

template <class Value, std::size_t count>
std::optional<Value> parse(const std::array<std::string_view, count>& names,
                           std::string_view name) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end()) return std::nullopt;
    return static_cast<Value>(at - names.begin());
}

}  // namespace

std::string_view name_of(RoomAction action) {
    ASSERT(static_cast<std::size_t>(action) < room_actions);
    return action_names[static_cast<std::size_t>(action)];
}

std::string_view name_of(Reach reach) {
    ASSERT(static_cast<std::size_t>(reach) < reaches);
    return reach_names[static_cast<std::size_t>(reach)];
}

std::optional<RoomAction> parse_room_action(std::string_view name) {
    return parse<RoomAction>(action_names, name);
}

std::optional<Reach> parse_reach(std::string_view name) {
    return parse<Reach>(reach_names, name);
}

std::optional<PlayerRole> parse_player_role(std::string_view name) {
    for (const PlayerRole role :
         {PlayerRole::spectator, PlayerRole::player, PlayerRole::builder, PlayerRole::owner})
        if (name_of(role) == name) return role;
    return std::nullopt;
}

}  // namespace jostle::server
