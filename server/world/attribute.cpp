// SPDX-License-Identifier: MIT
#include "server/world/attribute.h"

#include <algorithm>
#include <cmath>

namespace jostle::server {

namespace {

bool is_finite(const AttributeValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return std::isfinite(*number);
    if (const auto* v = std::get_if<physics::Vec3>(&value))
        return std::isfinite(v->x) && std::isfinite(v->y) && std::isfinite(v->z);
    return true;
}

bool is_key_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

}  // namespace

std::size_t bytes_of(const std::string& key, const AttributeValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    return attribute_overhead_bytes + key.size() + (text ? text->size() : 0);
}

std::string describe(const AttributeTarget& target) {
    switch (target.kind) {
        case AttributeTargetKind::world:
            return "the world";
        case AttributeTargetKind::player:
            return "player " + std::to_string(target.id);
        case AttributeTargetKind::entity:
            return "entity " + std::to_string(target.id);
    }
    return "an unknown target";
}

bool is_key(std::string_view text) {
    return !text.empty() && text.size() <= attribute_key_bytes_max &&
           std::ranges::all_of(text, is_key_character);
}

Status check_attribute_change(const AttributeChange& change, const std::string& where) {
    if (!is_key(change.key))
        return invalid_argument(where +
                                "key is invalid; it must be 1 to 32 of the characters a-z, 0-9, "
                                "'_' and '.'");
    if (!change.value) return {};
    if (!is_finite(*change.value))
        return invalid_argument(where + "value of \"" + change.key +
                                "\" is not finite; numbers must be finite");
    const bool has_roles = change.visibility == AttributeVisibility::roles;
    if (has_roles ? change.roles == 0 || change.roles >> player_roles != 0 : change.roles != 0)
        return invalid_argument(
            where + "roles of \"" + change.key + "\" is " + std::to_string(change.roles) +
            "; with the visibility ROLES it must have one bit per role, 1 to " +
            std::to_string((1u << player_roles) - 1) + ", otherwise it must be 0");
    return {};
}

}  // namespace jostle::server
