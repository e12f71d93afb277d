// SPDX-License-Identifier: MIT
#include "server/world/room_properties.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "server/util/text.h"

namespace jostle::server {
namespace {

constexpr double coordinate_max = 1e6;  // m
constexpr double quota_max = 1e12;

// Text that a lobby displays on one line.
Status check_text(std::string_view field, const std::string& text, std::size_t bytes_max) {
    if (text.size() > bytes_max)
        return invalid_argument(
            fmt::format("{} has {} bytes; at most {} are allowed", field, text.size(), bytes_max));
    if (has_control_character(text))
        return invalid_argument(
            fmt::format("{} contains control characters or invalid UTF-8", field));
    return {};
}

Status check_tag(const std::string& tag) {
    const auto is_allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    if (!tag.empty() && tag.size() <= RoomProperties::tag_bytes_max &&
        std::ranges::all_of(tag, is_allowed))
        return {};
    return invalid_argument(
        fmt::format("room.tags: {} is not a tag; a tag has 1 to {} characters of a-z, 0-9, _ and -",
                    quoted(tag, 64), RoomProperties::tag_bytes_max));
}

// "player.explode": a role and the rest.
struct RoleKey {
    PlayerRole role;
    std::string name;
};
Result<RoleKey> parse_key(std::string_view field, const std::string& key) {
    const std::size_t dot = key.find('.');
    const auto role = parse_player_role(std::string_view(key).substr(0, dot));
    if (dot != std::string::npos && role) return RoleKey{*role, key.substr(dot + 1)};
    return invalid_argument(
        fmt::format("{}: {} does not start with a role; use spectator, player, builder or owner "
                    "and a point, as in \"player.{}\"",
                    field, quoted(key, 64), field == "room.quotas" ? "bodies" : "explode"));
}

}  // namespace

bool ProtectedArea::contains(physics::Vec3 point, double radius) const {
    double squared = 0;  // distance to the box
    for (int k = 0; k < 3; k++) {
        const double outside = std::max({min[k] - point[k], 0.0, point[k] - max[k]});
        squared += outside * outside;
    }
    return squared <= radius * radius;
}

Status check_area(const ProtectedArea& area) {
    if (area.name.empty()) return invalid_argument("area.name is empty; name the area");
    if (Status s = check_text("area.name", area.name, RoomProperties::area_name_bytes_max); !s.ok())
        return s;
    for (int k = 0; k < 3; k++)
        // Written so that NaN fails.
        if (!(-coordinate_max <= area.min[k] && area.min[k] <= area.max[k] &&
              area.max[k] <= coordinate_max))
            return invalid_argument(fmt::format(
                "area {}: min.{} is {:g} and max.{} is {:g}; min must not exceed max, and both "
                "must be within {:g} m",
                quoted(area.name), "xyz"[k], area.min[k], "xyz"[k], area.max[k], coordinate_max));
    if (area.min_role == PlayerRole::unspecified)
        return invalid_argument("area.min_role is missing");
    return {};
}

Status check_properties(const RoomProperties& room) {
    if (Status s = check_text("room.title", room.title, RoomProperties::title_bytes_max); !s.ok())
        return s;
    if (Status s =
            check_text("room.description", room.description, RoomProperties::description_bytes_max);
        !s.ok())
        return s;
    if (Status s =
            check_text("room.join_code", room.join_code, RoomProperties::join_code_bytes_max);
        !s.ok())
        return s;
    if (room.tags.size() > RoomProperties::tags_max)
        return invalid_argument(fmt::format("room.tags has {} entries; at most {} are allowed",
                                            room.tags.size(), RoomProperties::tags_max));
    for (const std::string& tag : room.tags)
        if (Status s = check_tag(tag); !s.ok()) return s;
    if (room.capacity > RoomProperties::capacity_max)
        return invalid_argument(fmt::format("room.capacity is {}; it must be from 0 to {}",
                                            room.capacity, RoomProperties::capacity_max));
    if (room.initial_role == PlayerRole::unspecified || room.initial_role == PlayerRole::owner)
        return invalid_argument("room.initial_role must be spectator, player or builder");
    if (room.timeline_seconds > RoomProperties::timeline_seconds_max)
        return invalid_argument(fmt::format("room.timeline_seconds is {}; it must be from 0 to {}",
                                            room.timeline_seconds,
                                            RoomProperties::timeline_seconds_max));
    if (room.areas.size() > RoomProperties::areas_max)
        return invalid_argument(fmt::format("room.areas has {} entries; at most {} are allowed",
                                            room.areas.size(), RoomProperties::areas_max));
    for (std::size_t i = 0; i < room.areas.size(); i++) {
        if (Status s = check_area(room.areas[i]); !s.ok())
            return invalid_argument(fmt::format("room.areas[{}]: {}", i, s.error().message));
        for (std::size_t j = 0; j < i; j++)
            if (room.areas[i].name == room.areas[j].name)
                return invalid_argument(fmt::format("room.areas[{}]: the name {} is taken", i,
                                                    quoted(room.areas[i].name)));
    }
    return {};
}

Status set_permission(RoomProperties& room, const std::string& key, const std::string& value) {
    const Result<RoleKey> at = parse_key("room.permissions", key);
    if (!at.ok()) return at.error();
    const auto action = parse_room_action(at->name);
    if (!action) {
        std::string names;
        for (std::size_t i = 0; i < room_actions; i++)
            names += (i == 0 ? "" : ", ") + std::string(name_of(static_cast<RoomAction>(i)));
        return invalid_argument(fmt::format("room.permissions: {} names no action; use one of {}",
                                            quoted(key, 64), names));
    }
    const auto reach = parse_reach(value);
    if (!reach)
        return invalid_argument(
            fmt::format("room.permissions: {} is {}; it must be none, own, unowned or any",
                        quoted(key, 64), quoted(value, 64)));
    room.permissions.set(at->role, *action, *reach);
    return {};
}

Status set_quota(RoomProperties& room, const std::string& key, double value) {
    const Result<RoleKey> at = parse_key("room.quotas", key);
    if (!at.ok()) return at.error();
    if (!(0 <= value && value <= quota_max))
        return invalid_argument(
            fmt::format("room.quotas: {} is {:g}; it must be from 0 (unlimited) to {:g}",
                        quoted(key, 64), value, quota_max));
    RoleQuotas& quotas = room.quotas[static_cast<std::size_t>(at->role)];
    if (at->name == "bodies")
        quotas.bodies = static_cast<std::uint32_t>(std::min(std::floor(value), 1e9));
    else if (at->name == "joints")
        quotas.joints = static_cast<std::uint32_t>(std::min(std::floor(value), 1e9));
    else if (at->name == "energy_per_second")
        quotas.energy_per_second = value;
    else if (at->name == "explosions_per_minute")
        quotas.explosions_per_minute = value;
    else
        return invalid_argument(
            fmt::format("room.quotas: {} names no quota; use bodies, joints, energy_per_second or "
                        "explosions_per_minute",
                        quoted(key, 64)));
    return {};
}

}  // namespace jostle::server
