// SPDX-License-Identifier: MIT
//
// Attributes as arguments of jostlectl: their targets, values and visibility. Pure functions.
#pragma once

#include <string>

#include "jostle/base/result.h"
#include "jostle/v1/play.pb.h"

namespace jostle::ctl {

// "world", "player:3" or "entity:7".
Status parse_target(const std::string& text, v1::AttributeSet& set);
// "true", "12", "1.5", "1,2,3" or a text; `as_text`: always a text.
void parse_value(const std::string& text, bool as_text, v1::Attribute& attribute);
// "everyone", "owner", or roles separated by commas, such as "builder,owner".
Status parse_visibility(const std::string& text, v1::Attribute& attribute);
// "spectator", "player", "builder" or "owner".
Result<v1::PlayerRole> parse_role(const std::string& text);

std::string target_text(const v1::AttributeSet& set);
std::string value_text(const v1::Attribute& attribute);
std::string visibility_text(const v1::Attribute& attribute);
std::string role_text(v1::PlayerRole role);

}  // namespace jostle::ctl
