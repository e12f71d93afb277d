// SPDX-License-Identifier: MIT
#include "server/services/world_control.h"

#include <spdlog/fmt/fmt.h>

#include "jostle/scenes/catalog.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/world.pb.h"
#include "server/session/peer.h"

namespace jostle::server {

namespace {

void describe(v1::WorldInfo& info, const WorldHost& world, const SessionDirectory& sessions) {
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
    info.set_owner(world.properties().label.owner);
    info.set_oldest_restorable_tick(world.oldest_restorable_tick());
}

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
    if (!request.has_scene_name()) {
        return Error{ErrorCode::invalid_argument,
                     "give scene_name, scene, scene_json or checkpoint"};
    }
    if (auto scene = scenes::find_scene(request.scene_name())) return *std::move(scene);
    return Error{ErrorCode::not_found,
                 fmt::format("there is no scene \"{}\"{}; ListWorlds lists the scenes",
                             request.scene_name(), scenes::scene_suggestion(request.scene_name()))};
}

}  // namespace

Status WorldControl::list(const v1::ListWorldsRequest&, v1::ListWorldsResponse& response,
                          const Identity& who) const {
    for (const auto& world : context_.worlds.list()) {
        if (who.opens(world->id(), world->name()))
            describe(*response.add_worlds(), *world, context_.sessions);
    }
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
    describe(*response.mutable_world(), *world, context_.sessions);
    return {};
}

Status WorldControl::create(const v1::CreateWorldRequest& request,
                            v1::CreateWorldResponse& response, const Identity& who,
                            const std::string& address) {
    if (context_.draining) return going_down();
    const auto world = create_from(request, who, address);
    if (!world.ok()) return world.error();
    describe(*response.mutable_world(), **world, context_.sessions);
    return {};
}

Result<std::shared_ptr<WorldHost>> WorldControl::create_from(const v1::CreateWorldRequest& request,
                                                             const Identity& who,
                                                             const std::string& address) {
    if (!request.has_checkpoint()) {
        const Result<scenes::SceneDescription> scene = scene_of(request);
        if (!scene.ok()) return scene.error();
        return context_.worlds.create(request.name(), *scene, who.subject);
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
    return context_.worlds.create_from(request.name(), *world, checkpoint.tick(), who.subject);
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
    describe(*response.mutable_world(), *world, context_.sessions);
    return {};
}

Status WorldControl::join(const v1::JoinWorldRequest& request, v1::JoinWorldResponse& response,
                          const Identity& who, const std::string& address) {
    if (context_.draining) return going_down();
    const auto world = context_.worlds.find(request.world());
    if (!world) return no_such_world(request.world());
    if (context_.sessions.clients() >= context_.config.world.clients_max) {
        return Error{ErrorCode::resource_exhausted, fmt::format("the server is full: {} clients",
                                                                context_.config.world.clients_max)};
    }
    Result<std::string> ticket = context_.authorizer.issue_ticket(who, world->id(), address);
    if (!ticket.ok()) return ticket.error();
    describe(*response.mutable_world(), *world, context_.sessions);
    response.set_play_address(addresses_.grpc);
    response.set_websocket_url(addresses_.websocket);
    response.set_ticket(*std::move(ticket));
    return {};
}

}  // namespace jostle::server
