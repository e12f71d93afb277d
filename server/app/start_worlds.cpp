// SPDX-License-Identifier: MIT
#include "server/app/start_worlds.h"

#include <spdlog/fmt/fmt.h>

#include <optional>
#include <utility>

#include "jostle/scenes/scene_file.h"
#include "jostle/v1/room.pb.h"
#include "server/messages/room_message.h"
#include "server/util/log.h"

namespace jostle::server {

void resume_persisted_worlds(WorldArchive& archive, PlayContext& context) {
    const Clock::time_point until =
        Clock::now() + from_seconds(context.config.client.resume_timeout_seconds);
    for (PersistedWorld& persisted : archive.take_worlds()) {
        const auto world = context.worlds.adopt(std::move(persisted.start));
        for (const PreviousClient& previous : persisted.previous_clients)
            expect_resume(context, world, previous.client, previous.last_sequence, until);
    }
}

Status create_configured_worlds(const Config& config, WorldDirectory& worlds,
                                const WorldArchive* archive) {
    // A new world must not take the place of one that can still be restored.
    const auto is_blocked = [&](const std::string& name) {
        const auto conflict = archive ? archive->name_conflict(name) : std::nullopt;
        if (conflict) log_error("world \"{}\" is not created: {}", name, *conflict);
        return conflict.has_value();
    };
    for (const std::string& entry : config.scenes) {
        const auto failed = [&](const Error& error) {
            return Error{error.code, fmt::format("scene \"{}\": {}", entry, error.message)};
        };
        const std::size_t equals = entry.find('=');
        const bool named = equals != std::string::npos;
        if (named && worlds.find(entry.substr(0, equals))) continue;  // resumed from the database
        if (named && is_blocked(entry.substr(0, equals))) continue;
        const auto scene = scenes::load_scene(named ? entry.substr(equals + 1) : entry);
        if (!scene.ok()) return failed(scene.error());
        if (!named && (worlds.find(scene->name) || is_blocked(scene->name))) continue;
        std::optional<RoomProperties> room;
        if (!scene->room.empty()) {
            const Result<v1::RoomSettings> settings = settings_from_scene(scene->room);
            if (!settings.ok()) return failed(settings.error());
            Result<RoomProperties> read = room_from_message(*settings);
            if (!read.ok()) return failed(read.error());
            room = *std::move(read);
        }
        const auto world =
            worlds.create(named ? entry.substr(0, equals) : "", *scene, {}, std::move(room));
        if (!world.ok()) return failed(world.error());
    }
    return {};
}

}  // namespace jostle::server
