// SPDX-License-Identifier: MIT
//
// Typed values with names on a world, a player or an entity, as plain data. Any thread.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "jostle/base/result.h"
#include "jostle/physics/vec3.h"
#include "server/world/player_role.h"

namespace jostle::server {

inline constexpr std::size_t attribute_key_bytes_max = 32;
inline constexpr std::size_t attributes_per_input_max = 64;
// Counted for each attribute in addition to its key and its text.
inline constexpr std::size_t attribute_overhead_bytes = 16;

// The number of a target kind and the index of a value kind are saved: append new ones.
enum class AttributeTargetKind : std::uint8_t { world, player, entity };

struct AttributeTarget {
    AttributeTargetKind kind = AttributeTargetKind::world;
    std::uint32_t id = 0;  // of the client or the entity; 0 for the world

    auto operator<=>(const AttributeTarget&) const = default;
};

using AttributeValue = std::variant<bool, std::int64_t, double, std::string, physics::Vec3>;

// The numbers are those of jostle.v1.AttributeVisibility.
enum class AttributeVisibility : std::uint8_t { everyone = 1, owner, roles };

// Sets or removes one attribute.
struct AttributeChange {
    std::string key;
    std::optional<AttributeValue> value;  // nothing: removes the attribute
    AttributeVisibility visibility = AttributeVisibility::everyone;
    std::uint32_t roles = 0;  // one bit per PlayerRole; only with AttributeVisibility::roles

    bool operator==(const AttributeChange&) const = default;
};

struct Attribute {
    AttributeValue value;
    AttributeVisibility visibility = AttributeVisibility::everyone;
    std::uint32_t roles = 0;
    std::uint32_t setter = 0;  // client that set it last; 0: the server, so clients cannot set it

    bool operator==(const Attribute&) const = default;
};

// Whether all clients with this role may read the attribute.
constexpr bool is_visible_to_role(const Attribute& attribute, PlayerRole role) {
    return attribute.visibility == AttributeVisibility::everyone ||
           (attribute.visibility == AttributeVisibility::roles &&
            (attribute.roles >> static_cast<unsigned>(role) & 1) != 0);
}

std::size_t bytes_of(const std::string& key, const AttributeValue& value);
// "entity 7", "player 3" or "the world".
std::string describe(const AttributeTarget& target);
// Whether the text is 1 to 32 of the characters a-z, 0-9, '_' and '.'.
bool is_key(std::string_view text);
// Checks everything that does not depend on the state of a world. `where`: prefix of field names.
Status check_attribute_change(const AttributeChange& change, const std::string& where);

}  // namespace jostle::server
