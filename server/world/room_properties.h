// SPDX-License-Identifier: MIT
//
// The settings of a room: a world with a description for lobbies, roles with permissions and
// quotas, and rules of moderation. A value; any thread. Saved with the state of the room.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/vec3.h"
#include "server/world/player_role.h"
#include "server/world/room_permissions.h"

namespace jostle::server {

// Limits of each client of a role. 0: unlimited; the limits of the server apply as well.
struct RoleQuotas {
    std::uint32_t bodies = 0;      // that the client owns
    std::uint32_t joints = 0;      // likewise
    double energy_per_second = 0;  // J/s, given to bodies by spawns, pushes and explosions
    double explosions_per_minute = 0;

    bool operator==(const RoleQuotas&) const = default;
};

// A box in which only clients of a role, or of a higher one, may act.
struct ProtectedArea {
    std::string name = {};
    physics::Vec3 min = {}, max = {};  // world; m
    PlayerRole min_role = PlayerRole::builder;

    bool contains(physics::Vec3 point, double radius = 0) const;
    bool operator==(const ProtectedArea&) const = default;
};

struct RoomProperties {
    static constexpr std::size_t title_bytes_max = 64, description_bytes_max = 512, tags_max = 16,
                                 tag_bytes_max = 32, join_code_bytes_max = 64, areas_max = 64,
                                 area_name_bytes_max = 32;
    static constexpr std::uint32_t capacity_max = 10000, timeline_seconds_max = 60;

    std::string title = {}, description = {};
    std::vector<std::string> tags = {};  // of a-z, 0-9, '_' and '-'
    std::uint32_t capacity = 0;          // clients; 0: as many as the server allows
    std::string join_code = {};          // required to join; empty: the room is public
    bool unlisted = false;               // lists of worlds skip it
    bool close_when_empty = false;       // deleted after its last client left
    PlayerRole initial_role = PlayerRole::player;
    PermissionTable permissions = default_permissions();
    std::array<RoleQuotas, player_roles> quotas = default_quotas();  // by role
    std::vector<ProtectedArea> areas = {};
    std::uint32_t timeline_seconds = 0;  // of the past to which members can rewind the room

    static constexpr std::array<RoleQuotas, player_roles> default_quotas() {
        std::array<RoleQuotas, player_roles> quotas{};
        quotas[static_cast<std::size_t>(PlayerRole::player)] = {
            .bodies = 30, .joints = 30, .energy_per_second = 1e5, .explosions_per_minute = 12};
        quotas[static_cast<std::size_t>(PlayerRole::builder)] = {
            .bodies = 0, .joints = 0, .energy_per_second = 1e6, .explosions_per_minute = 60};
        return quotas;
    }
    const RoleQuotas& quotas_of(PlayerRole role) const {
        return quotas[static_cast<std::size_t>(role)];
    }
    bool operator==(const RoomProperties&) const = default;
};

// invalid_argument: names the field, its value and what is accepted.
Status check_area(const ProtectedArea& area);
Status check_properties(const RoomProperties& properties);
// Sets one entry: "player.explode" to "none", "player.explosions_per_minute" to 6.
Status set_permission(RoomProperties& properties, const std::string& key, const std::string& value);
Status set_quota(RoomProperties& properties, const std::string& key, double value);

}  // namespace jostle::server
