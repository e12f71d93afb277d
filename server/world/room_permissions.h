// SPDX-License-Identifier: MIT
//
// The actions that each role may take in a room, and on which entities: the finer table behind the
// access table of the server (auth/access_table.h), which decides who may connect and send inputs.
// A room can replace single entries. Constant after the creation of the room; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "server/world/player_role.h"

namespace jostle::server {

enum class RoomAction : std::uint8_t {
    spawn,
    drag,  // grab a body, a rope or a cloth and move it
    push,
    explode,
    remove,  // delete entities
    joints,  // create and delete joints, cut ropes and cloths
    control,
    message,
    vote,
    clean_up,  // delete all bodies of a client
    mute,
    kick,
    ban,
    set_role,
    protect,  // add and remove protected areas
    pause,    // pause, resume and step the world
    reset,
    settings,  // replace the settings of the room
    edit,      // change the properties of bodies
    clone,
    speed,   // slow motion
    rewind,  // continue from an earlier state
};
inline constexpr std::size_t room_actions = 22;

// The entities on which a role may act. Actions without a target need any reach but none.
enum class Reach : std::uint8_t {
    none,
    own,      // entities that the client spawned
    unowned,  // those, and the entities of the scene
    any,      // those, and the entities of other clients
};
inline constexpr std::size_t reaches = 4;

// The owner of the target of an action.
enum class TargetOwner : std::uint8_t { no_target, self, scene, other };

struct PermissionTable {
    std::array<std::array<Reach, room_actions>, player_roles> reach{};

    constexpr Reach of(PlayerRole role, RoomAction action) const {
        return reach[static_cast<std::size_t>(role)][static_cast<std::size_t>(action)];
    }
    constexpr void set(PlayerRole role, RoomAction action, Reach to) {
        reach[static_cast<std::size_t>(role)][static_cast<std::size_t>(action)] = to;
    }
    constexpr bool allows(PlayerRole role, RoomAction action, TargetOwner owner) const {
        switch (of(role, action)) {
            case Reach::none:
                return false;
            case Reach::own:
                return owner == TargetOwner::no_target || owner == TargetOwner::self;
            case Reach::unowned:
                return owner != TargetOwner::other;
            case Reach::any:
                return true;
        }
        return false;
    }

    bool operator==(const PermissionTable&) const = default;
};

// docs/guides/operator/rooms.md has this table.
constexpr PermissionTable default_permissions() {
    using enum Reach;
    struct Row {
        RoomAction action;
        Reach spectator, player, builder, owner;
    };
    constexpr Row rows[] = {
        {RoomAction::spawn, none, any, any, any},
        {RoomAction::drag, none, unowned, any, any},
        {RoomAction::push, none, unowned, any, any},
        {RoomAction::explode, none, any, any, any},
        {RoomAction::remove, none, own, unowned, any},
        {RoomAction::joints, none, unowned, any, any},
        {RoomAction::control, none, any, any, any},
        {RoomAction::message, any, any, any, any},
        {RoomAction::vote, none, any, any, any},
        {RoomAction::clean_up, none, own, own, any},
        {RoomAction::mute, none, none, any, any},
        {RoomAction::kick, none, none, none, any},
        {RoomAction::ban, none, none, none, any},
        {RoomAction::set_role, none, none, none, any},
        {RoomAction::protect, none, none, any, any},
        {RoomAction::pause, none, none, any, any},
        {RoomAction::reset, none, none, none, any},
        {RoomAction::settings, none, none, none, any},
        {RoomAction::edit, none, own, unowned, any},
        {RoomAction::clone, none, unowned, any, any},
        {RoomAction::speed, none, none, any, any},
        {RoomAction::rewind, none, none, none, any},
    };
    static_assert(std::size(rows) == room_actions);
    PermissionTable table;
    for (const Row& row : rows) {
        table.set(PlayerRole::spectator, row.action, row.spectator);
        table.set(PlayerRole::player, row.action, row.player);
        table.set(PlayerRole::builder, row.action, row.builder);
        table.set(PlayerRole::owner, row.action, row.owner);
    }
    return table;
}

std::string_view name_of(RoomAction action);
std::string_view name_of(Reach reach);
std::optional<RoomAction> parse_room_action(std::string_view name);
std::optional<Reach> parse_reach(std::string_view name);
// Only the four roles of clients.
std::optional<PlayerRole> parse_player_role(std::string_view name);

}  // namespace jostle::server
