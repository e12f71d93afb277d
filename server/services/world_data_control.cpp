// SPDX-License-Identifier: MIT
#include "server/services/world_data_control.h"

#include <spdlog/fmt/fmt.h>

#include <optional>
#include <utility>

#include "jostle/v1/admin.pb.h"
#include "server/limits/admission.h"
#include "server/messages/attribute_message.h"
#include "server/messages/client_message.h"
#include "server/messages/player_message.h"
#include "server/services/find_world.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

// Clients of gRPC receive at most 4 MiB by default.
constexpr std::size_t response_bytes_max = 3 << 20;

void write(google::protobuf::RepeatedPtrField<v1::ReportInfo>& to, const WorldHost& world) {
    for (const PlayerReport& report : world.reports()->list()) {
        v1::ReportInfo& out = *to.Add();
        out.set_number(report.number);
        out.set_world(world.id());
        out.set_world_name(world.name());
        out.set_tick(report.tick);
        out.set_time(rfc3339(report.time));
        out.set_from(report.from);
        out.set_from_name(report.from_name);
        out.set_client(report.client);
        out.set_name(report.name);
        out.set_reason(report.reason);
        out.mutable_messages()->Add(report.messages.begin(), report.messages.end());
    }
}

}  // namespace

Status WorldDataControl::apply(WorldHost& world, const Action& action,
                               std::uint32_t* number) const {
    Status applied;
    const Status done = world.between_ticks().run([&](HostedWorld& hosted) {
        applied = hosted.apply_as_server(action);
        if (number) *number = hosted.message_count();
    });
    world.wake();
    return done.ok() ? applied : done;
}

Status WorldDataControl::list_players(const v1::ListPlayersRequest& request,
                                      v1::ListPlayersResponse& response) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const FramePtr frame = (*world)->frame();
    std::map<ClientId, double> round_trips;
    for (const auto& [client, round_trip_s] :
         context_.connected_clients.round_trips((*world)->id()))
        round_trips[client] = round_trip_s;
    for (const PlayerPtr& player : frame->players->players) {
        const auto known = round_trips.find(player->client);
        const double ms = known == round_trips.end() ? 0 : 1000 * known->second;
        write_player(*response.add_players(), *player, static_cast<std::uint32_t>(ms + 0.5));
    }
    return {};
}

Status WorldDataControl::set_player_role(const v1::SetPlayerRoleRequest& request,
                                         v1::SetPlayerRoleResponse&) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    if (request.role() <= v1::PLAYER_ROLE_UNSPECIFIED ||
        request.role() >= static_cast<int>(player_roles))
        return invalid_argument(
            fmt::format("role is {}; it must be SPECTATOR, PLAYER, BUILDER or OWNER",
                        static_cast<int>(request.role())));
    const auto role = static_cast<PlayerRole>(request.role());
    if (Status s = apply(**world, SetRoleCommand{request.client(), role}); !s.ok()) return s;
    log_info("world {}: an operator changed the role of client {} to {}", (*world)->id(),
             request.client(), name_of(role));
    return {};
}

Status WorldDataControl::get_attributes(const v1::GetAttributesRequest& request,
                                        v1::GetAttributesResponse& response) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const FramePtr frame = (*world)->frame();
    std::vector<std::shared_ptr<const AttributesOfTarget>> entries;
    if (request.has_target()) {
        const auto target = to_attribute_changes(request.target(), "target.");
        if (!target.ok()) return target.error();
        if (auto entry = frame->attributes->find(target->target))
            entries.push_back(std::move(entry));
    } else {
        entries = frame->attributes->targets();
    }
    for (const auto& entry : entries) {
        v1::AttributeSet& set = *response.add_sets();
        write_target(set, entry->target);
        for (const auto& [key, attribute] : entry->attributes)
            write_attribute(*set.add_attributes(), key, attribute);
    }
    if (response.ByteSizeLong() > response_bytes_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the attributes have {} bytes; at most {} are sent; request one "
                                 "target",
                                 response.ByteSizeLong(), response_bytes_max)};
    return {};
}

Status WorldDataControl::set_attributes(const v1::SetAttributesRequest& request,
                                        v1::SetAttributesResponse&) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    Result<SetAttributesCommand> command = to_attribute_changes(request.set(), "set.");
    if (!command.ok()) return command.error();
    if (Status s = check_numbers(*command); !s.ok()) return s;
    return apply(**world, *std::move(command));
}

Status WorldDataControl::send_message(const v1::SendMessageRequest& request,
                                      v1::SendMessageResponse& response) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    SendMessageCommand command{.topic = request.topic(),
                               .data = request.data(),
                               .to = {request.to().begin(), request.to().end()}};
    if (Status s = check_numbers(command); !s.ok()) return s;
    const int bytes_max = context_.config.client.user_message_bytes_max;
    if (command.data.size() > static_cast<std::size_t>(bytes_max))
        return invalid_argument(
            fmt::format("data has {} bytes; client.user_message_bytes_max allows {}",
                        command.data.size(), bytes_max));
    std::uint32_t number = 0;
    if (Status s = apply(**world, std::move(command), &number); !s.ok()) return s;
    response.set_number(number);
    return {};
}

Status WorldDataControl::apply_input(const v1::ApplyInputRequest& request,
                                     v1::ApplyInputResponse& response) {
    const Result<Action> action = decode_input(request.input());
    if (!action.ok()) return action.error();
    if (!is_build_command(*action))
        return invalid_argument(
            "input is of another kind; allowed are spawn, delete, edit, clone, create_joint, "
            "delete_joint and undo");
    const bool undoes = std::holds_alternative<UndoCommand>(*action);
    if (undoes != (request.client() != 0))
        return invalid_argument(
            undoes ? "client is 0; name the client whose action is undone"
                   : fmt::format("client is {}; it must be 0, except for undo", request.client()));
    if (Status s = check_numbers(*action); !s.ok()) return s;
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    InputResult result;
    Status applied;
    const Status done = (*world)->between_ticks().run([&](HostedWorld& hosted) {
        applied = hosted.apply_between_inputs(request.client(), *action, result);
    });
    (*world)->wake();
    if (!done.ok()) return done;
    if (!applied.ok()) return applied;
    log_info("world {}: an operator changed entity {}, joint {}", (*world)->id(), result.entity,
             result.joint);
    response.set_tick((*world)->frame()->tick);
    response.set_entity(result.entity);
    response.set_joint(result.joint);
    return {};
}

Status WorldDataControl::list_reports(const v1::ListReportsRequest& request,
                                      v1::ListReportsResponse& response, const Identity& who) {
    if (request.world().empty()) {
        write_reports(*response.mutable_reports(), who);
        return {};
    }
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    if (!who.opens((*world)->id(), (*world)->name()))
        return Error{ErrorCode::permission_denied, "the token is for another world"};
    write(*response.mutable_reports(), **world);
    return {};
}

void WorldDataControl::write_reports(google::protobuf::RepeatedPtrField<v1::ReportInfo>& to,
                                     const Identity& who) const {
    for (const auto& world : context_.worlds.list())
        if (who.opens(world->id(), world->name())) write(to, *world);
}

}  // namespace jostle::server
