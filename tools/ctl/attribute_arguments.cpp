// SPDX-License-Identifier: MIT
#include "tools/ctl/attribute_arguments.h"

#include <array>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "jostle/base/format_text.h"

namespace jostle::ctl {

namespace {

// The names of PlayerRole, by number.
constexpr std::array role_names{"unspecified", "spectator", "player", "builder", "owner"};

template <class Number>
std::optional<Number> number_of(const std::string& text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (text.empty() || parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    return number;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
    return parts;
}

// "1,2,3"
bool parse_vector(const std::string& text, v1::Attribute& attribute) {
    const std::vector<std::string> parts = split(text);
    if (parts.size() != 3 || text.back() == ',') return false;
    const auto x = number_of<double>(parts[0]), y = number_of<double>(parts[1]),
               z = number_of<double>(parts[2]);
    if (!x || !y || !z) return false;
    attribute.mutable_vector()->set_x(*x);
    attribute.mutable_vector()->set_y(*y);
    attribute.mutable_vector()->set_z(*z);
    return true;
}

std::string shortest_text(double number) {
    return format_text("%.9g", number);
}

}  // namespace

Status parse_target(const std::string& text, v1::AttributeSet& set) {
    const std::size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    const auto id = colon == std::string::npos ? std::nullopt
                                               : number_of<std::uint32_t>(text.substr(colon + 1));
    if (text == "world")
        set.set_world(true);
    else if (kind == "player" && id)
        set.set_player(*id);
    else if (kind == "entity" && id)
        set.set_entity(*id);
    else
        return invalid_argument("\"" + text +
                                "\" is no target; write world, player:CLIENT or entity:ENTITY");
    return {};
}

void parse_value(const std::string& text, bool as_text, v1::Attribute& attribute) {
    if (as_text) return attribute.set_text(text);
    if (text == "true" || text == "false") return attribute.set_boolean(text == "true");
    if (const auto integer = number_of<std::int64_t>(text)) return attribute.set_integer(*integer);
    if (const auto number = number_of<double>(text)) return attribute.set_number(*number);
    if (!parse_vector(text, attribute)) attribute.set_text(text);
}

Result<v1::PlayerRole> parse_role(const std::string& text) {
    for (std::size_t k = 1; k < role_names.size(); k++)
        if (text == role_names[k]) return static_cast<v1::PlayerRole>(k);
    return invalid_argument("\"" + text +
                            "\" is no role; write spectator, player, builder or owner");
}

Status parse_visibility(const std::string& text, v1::Attribute& attribute) {
    if (text == "everyone") return {};
    if (text == "owner") {
        attribute.set_visibility(v1::ATTRIBUTE_VISIBILITY_OWNER);
        return {};
    }
    std::string roles = text;
    if (roles.starts_with("roles:")) roles = roles.substr(6);
    for (const std::string& name : split(roles)) {
        const Result<v1::PlayerRole> role = parse_role(name);
        if (!role.ok())
            return invalid_argument("\"" + text +
                                    "\" is no visibility; write everyone, owner or "
                                    "roles:ROLE,ROLE");
        attribute.set_roles(attribute.roles() | 1u << *role);
    }
    attribute.set_visibility(v1::ATTRIBUTE_VISIBILITY_ROLES);
    return {};
}

std::string target_text(const v1::AttributeSet& set) {
    if (set.has_entity()) return "entity:" + std::to_string(set.entity());
    if (set.has_player()) return "player:" + std::to_string(set.player());
    return "world";
}

std::string value_text(const v1::Attribute& attribute) {
    switch (attribute.value_case()) {
        case v1::Attribute::kBoolean:
            return attribute.boolean() ? "true" : "false";
        case v1::Attribute::kInteger:
            return std::to_string(attribute.integer());
        case v1::Attribute::kNumber:
            return shortest_text(attribute.number());
        case v1::Attribute::kText:
            return attribute.text();
        case v1::Attribute::kVector:
            return shortest_text(attribute.vector().x()) + "," +
                   shortest_text(attribute.vector().y()) + "," +
                   shortest_text(attribute.vector().z());
        case v1::Attribute::VALUE_NOT_SET:
            break;
    }
    return "-";
}

std::string visibility_text(const v1::Attribute& attribute) {
    if (attribute.visibility() == v1::ATTRIBUTE_VISIBILITY_OWNER) return "owner";
    if (attribute.visibility() != v1::ATTRIBUTE_VISIBILITY_ROLES) return "everyone";
    std::string text;
    for (std::size_t k = 0; k < role_names.size(); k++)
        if ((attribute.roles() >> k & 1) != 0)
            text += (text.empty() ? "roles:" : ",") + std::string(role_names[k]);
    return text;
}

std::string role_text(v1::PlayerRole role) {
    const auto index = static_cast<std::size_t>(role);
    return index < role_names.size() ? role_names[index] : "unknown";
}

}  // namespace jostle::ctl
