// SPDX-License-Identifier: MIT
#include "server/services/call_method.h"

#include "jostle/v1/world.pb.h"

namespace jostle::server {

namespace {

constexpr std::size_t small_request = 4096;

Status create(WorldControl& control, const CallContext& context,
              const v1::CreateWorldRequest& request, v1::CreateWorldResponse& response) {
    if (Status s = control.create(request, response, context.who, context.address);
        !s.ok() || !context.is_too_late())
        return s;
    // The caller has given up and does not know the new world, which would run unused.
    v1::DeleteWorldRequest removal;
    removal.set_world(response.world().id());
    v1::DeleteWorldResponse removed;
    if (Status s = control.remove(removal, removed); !s.ok()) return s;
    return Error{ErrorCode::deadline_exceeded, "building the world took longer than the deadline"};
}

}  // namespace

std::vector<CallMethod> world_methods(WorldControl& control, const WorldDirectory& worlds,
                                      std::size_t scene_bytes_max) {
    const std::string service = "/jostle.v1.WorldService/";
    return {
        unary_method<v1::ListWorldsRequest, v1::ListWorldsResponse>(
            service + "ListWorlds", CallWork::quick, small_request,
            [&](const CallContext& context, const auto& request, auto& response) {
                return control.list(request, response, context.who);
            }),
        world_method<v1::GetWorldRequest, v1::GetWorldResponse>(
            service + "GetWorld", CallWork::quick, small_request, worlds,
            [&](const CallContext&, const auto& request, auto& response) {
                return control.get(request, response);
            }),
        world_method<v1::JoinWorldRequest, v1::JoinWorldResponse>(
            service + "JoinWorld", CallWork::quick, small_request, worlds,
            [&](const CallContext& context, const auto& request, auto& response) {
                return control.join(request, response, context.who, context.address);
            }),
        unary_method<v1::JoinOrCreateWorldRequest, v1::JoinOrCreateWorldResponse>(
            service + "JoinOrCreateWorld", CallWork::control, scene_bytes_max,
            [&](const CallContext& context, const auto& request, auto& response) {
                return control.join_or_create(request, response, context.who, context.address);
            }),
        unary_method<v1::CreateWorldRequest, v1::CreateWorldResponse>(
            service + "CreateWorld", CallWork::control, scene_bytes_max,
            [&](const CallContext& context, const auto& request, auto& response) {
                Status done = create(control, context, request, response);
                const v1::WorldInfo& created = response.world();
                context.authorizer.record(
                    context.who,
                    context.access_request({created.id(), created.name(), created.owner()}), done);
                return done;
            }),
        world_method<v1::DeleteWorldRequest, v1::DeleteWorldResponse>(
            service + "DeleteWorld", CallWork::control, small_request, worlds,
            [&](const CallContext& context, const auto& request, auto& response) {
                Status done = control.remove(request, response);
                context.authorizer.record(context.who,
                                          context.access_request({request.world(), {}, {}}), done);
                return done;
            }),
    };
}

}  // namespace jostle::server
