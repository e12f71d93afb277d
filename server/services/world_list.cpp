// SPDX-License-Identifier: MIT
#include "server/services/world_list.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "jostle/v1/world.pb.h"

namespace jostle::server {
namespace {

constexpr std::size_t text_bytes_max = 64;

// Ignores the case of A to Z.
bool contains(std::string_view text, std::string_view part) {
    const auto lower = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    const auto same = [&](char a, char b) { return lower(a) == lower(b); };
    return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

void write_room_info(v1::RoomInfo& info, const RoomState& room) {
    const RoomProperties& properties = room.properties;
    info.set_title(properties.title);
    info.set_description(properties.description);
    for (const std::string& tag : properties.tags) info.add_tags(tag);
    info.set_capacity(properties.capacity);
    info.set_is_private(!properties.join_code.empty());
    info.set_unlisted(properties.unlisted);
    info.set_close_when_empty(properties.close_when_empty);
    std::uint32_t players = 0, spectators = 0;
    for (const RoomClient& client : room.clients)
        if (!client.removed) (client.role == PlayerRole::spectator ? spectators : players)++;
    info.set_players(players);
    info.set_spectators(spectators);
}

bool is_full(const RoomState& room, const WorldHost& world, const SessionDirectory& sessions) {
    const std::uint32_t capacity = room.properties.capacity;
    return capacity > 0 && sessions.clients_in(world.id()) >= static_cast<int>(capacity);
}

}  // namespace

void write_world(v1::WorldInfo& info, const WorldHost& world, const SessionDirectory& sessions) {
    const FramePtr frame = world.frame();
    info.set_id(world.id());
    info.set_name(world.name());
    info.set_scene(world.properties().scene->name);
    info.set_hz(world.hz());
    info.set_bodies(static_cast<std::uint32_t>(frame->entities.size()));
    info.set_awake(static_cast<std::uint32_t>(frame->awake));
    info.set_clients(static_cast<std::uint32_t>(sessions.clients_in(world.id())));
    info.set_tick(frame->tick);
    info.set_step_ms_mean(frame->tick_ms_mean);
    info.set_time_scale(frame->time_scale);
    info.set_paused(world.lifecycle().paused().value_or(""));
    info.set_owner(world.owner());
    info.set_oldest_restorable_tick(world.oldest_restorable_tick());
    if (frame->room) write_room_info(*info.mutable_room(), *frame->room);
}

Status check_filter(const v1::WorldFilter& filter) {
    if (filter.tags_size() > static_cast<int>(RoomProperties::tags_max))
        return invalid_argument(fmt::format("filter.tags has {} entries; at most {} are allowed",
                                            filter.tags_size(), RoomProperties::tags_max));
    if (filter.text().size() > text_bytes_max)
        return invalid_argument(fmt::format("filter.text has {} bytes; at most {} are allowed",
                                            filter.text().size(), text_bytes_max));
    return {};
}

bool matches(const v1::WorldFilter& filter, const WorldHost& world,
             const SessionDirectory& sessions) {
    if (!filter.scene().empty() && world.properties().scene->name != filter.scene()) return false;
    if (!filter.owner().empty() && world.owner() != filter.owner()) return false;
    const RoomView room = world.frame()->room;
    const bool needs_room = filter.tags_size() > 0 || filter.not_full() || filter.is_public();
    if (!room)
        return !needs_room && (filter.text().empty() || contains(world.name(), filter.text()));
    const RoomProperties& properties = room->properties;
    for (const std::string& tag : filter.tags())
        if (std::ranges::find(properties.tags, tag) == properties.tags.end()) return false;
    if (filter.not_full() && is_full(*room, world, sessions)) return false;
    if (filter.is_public() && !properties.join_code.empty()) return false;
    return filter.text().empty() || contains(world.name(), filter.text()) ||
           contains(properties.title, filter.text()) ||
           contains(properties.description, filter.text());
}

bool is_listed(const WorldHost& world, const Identity& who) {
    if (!who.opens(world.id(), world.name())) return false;
    if (!world.properties().is_room || who.role >= Role::admin) return true;
    const RoomView room = world.frame()->room;
    return !room->properties.unlisted ||
           (!who.anonymous && room->owner == std::string(subject_member) + who.subject);
}

}  // namespace jostle::server
