// SPDX-License-Identifier: MIT
#include "server/services/room_templates.h"

#include <algorithm>

#include "jostle/scenes/scene_file.h"
#include "jostle/v1/room.pb.h"
#include "jostle/v1/world.pb.h"

namespace jostle::server {
namespace {

constexpr RoomTemplateEntry templates[] = {
    {"freeplay", "sandbox", R"({
        "title": "Free play", "description": "Everybody builds.", "tags": ["sandbox"],
        "initialRole": "builder", "capacity": 32, "closeWhenEmpty": true})"},
    {"workshop", "workshop", R"({
        "title": "Workshop", "description": "The owner decides who builds; others watch and play.",
        "tags": ["building"], "capacity": 16, "closeWhenEmpty": true,
        "permissions": {"player.explode": "none", "player.spawn": "none"}})"},
    {"race", "race_track", R"({
        "title": "Race", "description": "Drive a car; only the owner changes the track.",
        "tags": ["race", "vehicles"], "capacity": 6, "closeWhenEmpty": true,
        "permissions": {"player.spawn": "none", "player.drag": "none", "player.push": "none",
                        "player.explode": "none", "player.joints": "none"}})"},
    {"demolition", "demolition", R"({
        "title": "Demolition", "description": "Break everything.", "tags": ["destruction"],
        "capacity": 16, "closeWhenEmpty": true,
        "quotas": {"player.explosions_per_minute": 60, "player.energy_per_second": 1000000}})"},
};

}  // namespace

std::span<const RoomTemplateEntry> room_templates() {
    return templates;
}

const RoomTemplateEntry* find_room_template(std::string_view name) {
    const auto at = std::ranges::find(templates, name, &RoomTemplateEntry::name);
    return at == std::end(templates) ? nullptr : at;
}

void write_template(v1::RoomTemplate& to, const RoomTemplateEntry& entry) {
    to.set_name(std::string(entry.name));
    to.set_scene(std::string(entry.scene));
    *to.mutable_room() = settings_of(entry);
}

v1::RoomSettings settings_of(const RoomTemplateEntry& entry) {
    v1::RoomSettings settings;
    scenes::read_json_message(entry.settings, settings).expect();
    return settings;
}

}  // namespace jostle::server
