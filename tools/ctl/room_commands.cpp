// SPDX-License-Identifier: MIT
#include "tools/ctl/room_commands.h"

#include <google/protobuf/util/json_util.h>

#include "jostle/scenes/scene_file.h"
#include "tools/common/table.h"
#include "tools/ctl/attribute_arguments.h"
#include "tools/ctl/outcome.h"

namespace jostle::ctl {

using common::number_text, common::sanitized;

using Admin = v1::AdminService::Stub;

namespace {

Result<v1::GetRoomResponse> get_room(Connection& server, const CommandArguments& arguments) {
    v1::GetRoomRequest request;
    request.set_world(arguments.world);
    return server.call(&Admin::GetRoom, request);
}

Outcome moderate(Connection& server, const CommandArguments& arguments,
                 const v1::RoomInput& command, const std::string& sentence) {
    v1::ModerateRoomRequest request;
    request.set_world(arguments.world);
    *request.mutable_command() = command;
    const auto response = server.call(&Admin::ModerateRoom, request);
    return to_outcome(response, arguments, sentence);
}

std::string client_text(const CommandArguments& arguments) {
    return "client " + std::to_string(arguments.client);
}

}  // namespace

Outcome show_room(Connection& server, const CommandArguments& arguments) {
    const auto response = get_room(server, arguments);
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : room_text(*response)};
}

Outcome set_room_role(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_set_role()->set_client(arguments.client);
    const Result<v1::PlayerRole> role = parse_role(arguments.role);
    if (!role.ok()) return usage_error(role.error());
    command.mutable_set_role()->set_role(*role);
    return moderate(server, arguments, command,
                    client_text(arguments) + " has the role " + arguments.role);
}

Outcome kick_from_room(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_kick()->set_client(arguments.client);
    command.mutable_kick()->set_reason(arguments.reason);
    return moderate(server, arguments, command,
                    client_text(arguments) + " was removed from the room; it may join again");
}

Outcome ban_from_room(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_ban()->set_client(arguments.client);
    command.mutable_ban()->set_seconds(arguments.hours * 3600);
    command.mutable_ban()->set_reason(arguments.reason);
    return moderate(server, arguments, command,
                    client_text(arguments) + " is banned from the room");
}

Outcome unban_from_room(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_unban()->set_member(arguments.member);
    return moderate(server, arguments, command,
                    sanitized(arguments.member) + " is no longer banned from the room");
}

Outcome mute(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_mute()->set_client(arguments.client);
    command.mutable_mute()->set_seconds(arguments.seconds);
    return moderate(
        server, arguments, command,
        client_text(arguments) + (arguments.seconds > 0
                                      ? " is muted for " + number_text(arguments.seconds, 0) + " s"
                                      : " is no longer muted"));
}

Outcome clean_up(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_clean_up()->set_client(arguments.client);
    return moderate(server, arguments, command,
                    "the bodies of " + client_text(arguments) + " were deleted");
}

Outcome protect(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    v1::ProtectedArea& area = *command.mutable_protect()->mutable_area();
    const auto write = [](v1::Vec3& to, const std::vector<double>& from) {
        to.set_x(from.at(0)), to.set_y(from.at(1)), to.set_z(from.at(2));
    };
    area.set_name(arguments.area);
    area.set_min_role(arguments.role);
    write(*area.mutable_min(), arguments.min);
    write(*area.mutable_max(), arguments.max);
    return moderate(server, arguments, command, sanitized(arguments.area) + " is protected");
}

Outcome unprotect(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_unprotect()->set_name(arguments.area);
    return moderate(server, arguments, command,
                    sanitized(arguments.area) + " is no longer protected");
}

Outcome update_room(Connection& server, const CommandArguments& arguments) {
    const Result<std::string> read = read_file(arguments.file);
    if (!read.ok()) return usage_error(read.error());
    v1::RoomInput command;
    if (Status s = scenes::read_json_message(*read, *command.mutable_settings()); !s.ok())
        return usage_error(in_file(arguments.file, s.error()));
    return moderate(server, arguments, command,
                    sanitized(arguments.world) + " has the settings of " + arguments.file);
}

Outcome reset(Connection& server, const CommandArguments& arguments) {
    v1::RoomInput command;
    command.mutable_reset();
    return moderate(server, arguments, command,
                    sanitized(arguments.world) + " starts from its scene again");
}

Outcome set_room_speed(Connection& server, const CommandArguments& a) {
    v1::RoomInput command;
    command.mutable_speed()->set_percent(a.percent);
    return moderate(
        server, a, command,
        sanitized(a.world) + " runs at " + std::to_string(a.percent) + " % of real time");
}

Outcome rewind_room(Connection& server, const CommandArguments& a) {
    v1::RoomInput command;
    command.mutable_rewind()->set_tick(a.tick);
    return moderate(server, a, command,
                    sanitized(a.world) + " continues from its state after tick " +
                        std::to_string(a.tick) + "; clients resume their sessions");
}

Outcome list_restorable_ticks(Connection& server, const CommandArguments& a) {
    const auto room = get_room(server, a);
    if (!room.ok()) return server_error(room.error());
    v1::GetRoomResponse ticks;
    ticks.set_speed_percent(room->speed_percent());
    *ticks.mutable_restorable_ticks() = room->restorable_ticks();
    if (a.json) return {.text = json_text(ticks)};
    if (ticks.restorable_ticks().empty())
        return {.text =
                    "The room has no timeline. Set timelineSeconds in its settings: jostlectl "
                    "room update.\n"};
    std::string text;
    for (const std::uint32_t tick : ticks.restorable_ticks()) text += std::to_string(tick) + "\n";
    return {.text = text};
}

Outcome write_room_settings(Connection& server, const CommandArguments& a) {
    const auto room = get_room(server, a);
    if (!room.ok()) return server_error(room.error());
    google::protobuf::util::JsonPrintOptions options;
    options.add_whitespace = true;
    std::string text;
    if (!google::protobuf::util::MessageToJsonString(room->settings(), &text, options).ok())
        return {.error = "the settings of the room have no JSON form"};
    if (Status s = write_file(a.file, text); !s.ok()) return usage_error(s.error());
    if (a.file == "-") return {};
    return {.text = a.file + " has the settings of " + sanitized(a.world) +
                    ", without the join code\n"};
}

Outcome list_reports(Connection& server, const CommandArguments& a) {
    v1::ListReportsRequest request;
    request.set_world(a.world);
    const auto response = server.call(&Admin::ListReports, request);
    if (!response.ok()) return server_error(response.error());
    return {.text = a.json ? json_text(*response) : reports_text(*response)};
}

}  // namespace jostle::ctl
