// SPDX-License-Identifier: MIT
#include "server/services/world_control.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/world.pb.h"
#include "server/messages/room_message.h"
#include "server/services/room_templates.h"
#include "server/services/world_list.h"
#include "server/session/peer.h"
#include "server/session/room_admission.h"
#include "server/util/random_id.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

Error no_such_world(const std::string& world) {
    if (world.empty()) return Error{ErrorCode::not_found, "the server has no world"};
    return Error{ErrorCode::not_found, fmt::format("there is no world \"{}\"", world)};
}

Error going_down() {
    return Error{ErrorCode::unavailable, "the server is shutting down; try another server"};
}

// Scene names refer to the catalogue only: clients must not make the server read files.
Result<scenes::SceneDescription> scene_of(const v1::CreateWorldRequest& request) {
    if (request.has_scene()) return scenes::from_message(request.scene());
    if (request.has_scene_json()) return scenes::read_scene_json(request.scene_json());
    if (request.has_room_template()) {
        const RoomTemplateEntry* const entry = find_room_template(request.room_template());
        if (entry) return *scenes::find_scene(entry->scene);
        return Error{ErrorCode::not_found,
                     fmt::format("there is no room template {}; ListWorlds lists the templates",
                                 in_quotes(request.room_template(), 64))};
    }
    if (!request.has_scene_name()) {
        return Error{ErrorCode::invalid_argument,
                     "give scene_name, room_template, scene, scene_json or checkpoint"};
    }
    if (auto scene = scenes::find_scene(request.scene_name())) return *std::move(scene);
    return Error{ErrorCode::not_found,
                 fmt::format("there is no scene \"{}\"{}; ListWorlds lists the scenes",
                             request.scene_name(), scenes::scene_suggestion(request.scene_name()))};
}

// Nothing: the world is no room. `scene`: null: the world continues from a checkpoint.
Result<std::optional<RoomProperties>> room_of(const v1::CreateWorldRequest& request,
                                              const scenes::SceneDescription* scene) {
    std::optional<v1::RoomSettings> settings;
    if (const RoomTemplateEntry* const entry = find_room_template(request.room_template())) {
        settings = settings_of(*entry);
    } else if (scene && !scene->room.empty()) {
        Result<v1::RoomSettings> read = settings_from_scene(scene->room);
        if (!read.ok()) return read.error();
        settings = *std::move(read);
    }
    if (request.has_room())
        settings = settings ? with_changes(*std::move(settings), request.room()) : request.room();
    if (!settings) return std::optional<RoomProperties>();
    Result<RoomProperties> room = room_from_message(*settings);
    if (!room.ok()) return room.error();
    return std::optional(*std::move(room));
}

}  // namespace

Status WorldControl::list(const v1::ListWorldsRequest& request, v1::ListWorldsResponse& response,
                          const Identity& who) const {
    if (Status s = check_filter(request.filter()); !s.ok()) return s;
    const std::uint32_t limit = request.limit();
    for (const auto& world : context_.worlds.list()) {
        if (limit > 0 && response.worlds_size() >= static_cast<int>(std::min(limit, 1u << 30)))
            break;
        if (is_listed(*world, who) && matches(request.filter(), *world, context_.sessions))
            write_world(*response.add_worlds(), *world, context_.sessions);
    }
    for (const RoomTemplateEntry& entry : room_templates())
        write_template(*response.add_templates(), entry);
    for (const scenes::CatalogEntry& entry : scenes::catalog()) {
        v1::SceneInfo& scene = *response.add_scenes();
        scene.set_name(std::string(entry.name));
        scene.set_description(std::string(entry.description));
    }
    return {};
}

Status WorldControl::get(const v1::GetWorldRequest& request, v1::GetWorldResponse& response) const {
    const auto world = context_.worlds.find(request.world());
    if (!world) return no_such_world(request.world());
    write_world(*response.mutable_world(), *world, context_.sessions);
    return {};
}

Status WorldControl::create(const v1::CreateWorldRequest& request,
                            v1::CreateWorldResponse& response, const Identity& who,
                            const std::string& address) {
    if (context_.draining) return going_down();
    const auto world = create_from(request, who, address);
    if (!world.ok()) return world.error();
    write_world(*response.mutable_world(), **world, context_.sessions);
    return {};
}

Result<std::shared_ptr<WorldHost>> WorldControl::create_from(const v1::CreateWorldRequest& request,
                                                             const Identity& who,
                                                             const std::string& address) {
    if (!request.has_checkpoint()) {
        const Result<scenes::SceneDescription> scene = scene_of(request);
        if (!scene.ok()) return scene.error();
        Result<std::optional<RoomProperties>> room = room_of(request, &*scene);
        if (!room.ok()) return room.error();
        return context_.worlds.create(request.name(), *scene, who.subject, *std::move(room));
    }
    const v1::Checkpoint& checkpoint = request.checkpoint();
    if (checkpoint.world().empty())
        return Error{ErrorCode::invalid_argument, "checkpoint.world is missing; name the world"};
    const auto world = context_.worlds.find(checkpoint.world());
    if (!world) return no_such_world(checkpoint.world());
    if (Status s = context_.authorizer.admit(
            who, {"jostle.v1.WorldService/JoinWorld", world_target(*world), address});
        !s.ok())
        return s.error();
    if (Status s = check_room_access(*world, who, address, {}, false); !s.ok()) return s.error();
    Result<std::optional<RoomProperties>> room = room_of(request, nullptr);
    if (!room.ok()) return room.error();
    return context_.worlds.create_from(request.name(), *world, checkpoint.tick(), who.subject,
                                       *std::move(room));
}

Status WorldControl::remove(const v1::DeleteWorldRequest& request, v1::DeleteWorldResponse&) {
    if (request.world().empty())
        return Error{ErrorCode::invalid_argument, "name the world to delete"};
    if (!context_.worlds.remove(request.world())) return no_such_world(request.world());
    return {};
}

Status WorldControl::resume(const std::string& name, v1::GetWorldResponse& response) {
    const auto world = context_.worlds.find(name);
    if (name.empty() || !world) return no_such_world(name);
    world->resume();
    write_world(*response.mutable_world(), *world, context_.sessions);
    return {};
}

Status WorldControl::join(const v1::JoinWorldRequest& request, v1::JoinWorldResponse& response,
                          const Identity& who, const std::string& address) {
    if (context_.draining) return going_down();
    const auto world = context_.worlds.find(request.world());
    if (!world) return no_such_world(request.world());
    if (Status s = check_room_access(*world, who, address, request.join_code(), false); !s.ok())
        return s;
    if (Status s = check_room_capacity(*world, context_.sessions, who, address); !s.ok()) return s;
    if (context_.sessions.clients() >= context_.config.world.clients_max) {
        return Error{ErrorCode::resource_exhausted, fmt::format("the server is full: {} clients",
                                                                context_.config.world.clients_max)};
    }
    Result<std::string> ticket = context_.authorizer.issue_ticket(who, world->id(), address);
    if (!ticket.ok()) return ticket.error();
    write_world(*response.mutable_world(), *world, context_.sessions);
    response.set_play_address(addresses_.grpc);
    response.set_websocket_url(addresses_.websocket);
    response.set_ticket(*std::move(ticket));
    return {};
}

Status WorldControl::join_or_create(const v1::JoinOrCreateWorldRequest& request,
                                    v1::JoinOrCreateWorldResponse& response, const Identity& who,
                                    const std::string& address) {
    if (Status s = check_filter(request.filter()); !s.ok()) return s;
    v1::JoinWorldRequest join_request;
    join_request.set_join_code(request.join_code());
    for (const auto& world : context_.worlds.list()) {
        if (!world->properties().is_room || !is_listed(*world, who) ||
            !matches(request.filter(), *world, context_.sessions) ||
            !check_room_capacity(*world, context_.sessions, who, address).ok() ||
            !check_room_access(*world, who, address, request.join_code(), false).ok())
            continue;
        join_request.set_world(world->id());
        return join(join_request, *response.mutable_join(), who, address);
    }
    if (!request.has_create())
        return Error{ErrorCode::not_found, "no room matches the filter; set create to create one"};
    if (Status s =
            context_.authorizer.admit(who, {"jostle.v1.WorldService/CreateWorld", {}, address});
        !s.ok())
        return s;
    v1::CreateWorldRequest creation = request.create();
    // Rooms of one kind have the same scene, so the name of the scene would be taken.
    if (creation.name().empty()) creation.set_name("room-" + random_id().substr(0, 8));
    if (!creation.has_room() && !creation.has_room_template()) creation.mutable_room();
    v1::CreateWorldResponse created;
    Status done = create(creation, created, who, address);
    const v1::WorldInfo& info = created.world();
    context_.authorizer.record(
        who,
        {"jostle.v1.WorldService/CreateWorld", {info.id(), info.name(), info.owner()}, address},
        done);
    if (!done.ok()) return done;
    response.set_created(true);
    join_request.set_world(info.id());
    join_request.set_join_code(creation.room().join_code());
    return join(join_request, *response.mutable_join(), who, address);
}

}  // namespace jostle::server
