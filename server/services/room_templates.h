// SPDX-License-Identifier: MIT
//
// Room templates: scenes of the catalogue with room settings, which CreateWorld accepts by name.
// Constant; any thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace jostle::v1 {
class RoomSettings;
class RoomTemplate;
}  // namespace jostle::v1

namespace jostle::server {

struct RoomTemplateEntry {
    std::string_view name, scene;
    std::string_view settings;  // RoomSettings as JSON
};

std::span<const RoomTemplateEntry> room_templates();
// Null: there is no template of this name.
const RoomTemplateEntry* find_room_template(std::string_view name);
void write_template(v1::RoomTemplate& to, const RoomTemplateEntry& entry);
v1::RoomSettings settings_of(const RoomTemplateEntry& entry);

}  // namespace jostle::server
