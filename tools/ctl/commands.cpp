// SPDX-License-Identifier: MIT
#include "tools/ctl/commands.h"

#include <google/protobuf/util/json_util.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "jostle/scenes/scene_file.h"
#include "server/storage/backup.h"
#include "server/storage/store_head.h"
#include "tools/common/table.h"
#include "tools/ctl/attribute_arguments.h"
#include "tools/ctl/outcome.h"
#include "tools/ctl/report.h"

namespace jostle::ctl {

using common::number_text, common::sanitized;

using Admin = v1::AdminService::Stub;
using Worlds = v1::WorldService::Stub;

namespace {

// Step interval of a world with the lowest rate, 4 Hz.
constexpr double slowest_step_s = 0.25;

std::string count_text(std::uint32_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::chrono::seconds whole_seconds(double seconds) {
    return std::chrono::seconds(static_cast<int>(seconds));
}

// A scene file is the JSON form of the message. The server validates its values.
Status read_scene(const std::string& text, v1::Scene& scene) {
    return scenes::read_json_message(text, scene);
}

std::string scene_file_text(const v1::Scene& scene) {
    google::protobuf::util::JsonPrintOptions options;
    options.add_whitespace = true;
    std::string text;
    if (!google::protobuf::util::MessageToJsonString(scene, &text, options).ok()) return {};
    return text;
}

// `Request`: BanRequest or UnbanRequest.
template <class Request>
void set_target(Request& request, const CommandArguments& arguments) {
    if (arguments.network.empty())
        request.set_subject(arguments.subject);
    else
        request.set_network(arguments.network);
}

std::string megabytes(std::uint64_t bytes) {
    return number_text(static_cast<double>(bytes) / 1e6, 1);
}

std::string report_text(const server::StoreReport& report) {
    std::string text = (report.is_backup ? "backup, " : "database, ") + megabytes(report.bytes) +
                       " MB, commit " + std::to_string(report.commits) + " of " +
                       server::utc_text(report.written) + "\n";
    for (const server::StoreReport::World& world : report.worlds)
        text += "  " + sanitized(world.id) + " \"" + sanitized(world.name) + "\": up to tick " +
                std::to_string(world.last_tick) + ", " + std::to_string(world.checkpoints) +
                " checkpoints, " + std::to_string(world.entries) + " journal entries\n";
    for (const std::string& error : report.errors)
        text += "  damage: " + sanitized(error, 300) + "\n";
    return text;
}

std::string report_json(const server::StoreReport& report) {
    nlohmann::json json = {{"isBackup", report.is_backup},      {"bytes", report.bytes},
                           {"commits", report.commits},         {"written", report.written},
                           {"worlds", nlohmann::json::array()}, {"errors", report.errors}};
    for (const server::StoreReport::World& world : report.worlds)
        json["worlds"].push_back({{"id", world.id},
                                  {"name", world.name},
                                  {"lastTick", world.last_tick},
                                  {"checkpoints", world.checkpoints},
                                  {"entries", world.entries}});
    return json.dump(2) + "\n";
}

Outcome set_paused(Connection& server, const CommandArguments& arguments, bool paused) {
    v1::SetPausedRequest request;
    request.set_world(arguments.world);
    request.set_paused(paused);
    request.set_reason(arguments.reason);
    const auto response = server.call(&Admin::SetPaused, request);
    return to_outcome(response, arguments,
                      sanitized(arguments.world) +
                          (paused ? " is paused; use jostlectl step or resume" : " is running"));
}

}  // namespace

Outcome list_worlds(Connection& server, const CommandArguments& arguments) {
    v1::ListWorldsRequest request;
    std::istringstream tags(arguments.tags);
    for (std::string tag; std::getline(tags, tag, ',');) request.mutable_filter()->add_tags(tag);
    request.mutable_filter()->set_text(arguments.words);
    request.mutable_filter()->set_not_full(arguments.not_full);
    request.mutable_filter()->set_is_public(arguments.is_public);
    const auto response = server.call(&Worlds::ListWorlds, request);
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : worlds_text(*response)};
}

Outcome create_world(Connection& server, const CommandArguments& arguments) {
    v1::CreateWorldRequest request;
    request.set_name(arguments.name);
    std::string text;
    if (!arguments.room.empty()) {
        const Result<std::string> read = read_file(arguments.room);
        if (!read.ok()) return usage_error(read.error());
        if (Status s = scenes::read_json_message(*read, *request.mutable_room()); !s.ok())
            return usage_error(in_file(arguments.room, s.error()));
    }
    if (!arguments.from.empty()) {
        request.mutable_checkpoint()->set_world(arguments.from);
        request.mutable_checkpoint()->set_tick(arguments.tick);
    } else if (!arguments.room_template.empty()) {
        request.set_room_template(arguments.room_template);
    } else if (arguments.file.empty()) {
        request.set_scene_name(arguments.scene);
    } else {
        Result<std::string> read = read_file(arguments.file);
        if (!read.ok()) return usage_error(read.error());
        text = *std::move(read);
        if (Status s = read_scene(text, *request.mutable_scene()); !s.ok())
            return usage_error(in_file(arguments.file, s.error()));
    }
    const auto response = server.call(&Worlds::CreateWorld, request, std::chrono::seconds(60));
    if (!response.ok() && response.error().code == ErrorCode::invalid_argument && !text.empty())
        return server_error(in_file(arguments.file, invalid_argument(scenes::with_positions(
                                                        text, "", response.error().message))));
    if (!response.ok()) return server_error(response.error());
    const v1::WorldInfo& world = response->world();
    return to_outcome(response, arguments,
                      world.id() + " \"" + sanitized(world.name()) + "\" runs with " +
                          std::to_string(world.bodies()) + " bodies");
}

Outcome delete_world(Connection& server, const CommandArguments& arguments) {
    v1::DeleteWorldRequest request;
    request.set_world(arguments.world);
    const auto response = server.call(&Worlds::DeleteWorld, request);
    return to_outcome(response, arguments, sanitized(arguments.world) + " is deleted");
}

Outcome list_clients(Connection& server, const CommandArguments& arguments) {
    v1::ListClientsRequest request;
    request.set_world(arguments.world);
    const auto response = server.call(&Admin::ListClients, request);
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : clients_text(*response)};
}

Outcome kick(Connection& server, const CommandArguments& arguments) {
    v1::KickRequest request;
    request.set_client(arguments.client);
    request.set_reason(arguments.reason);
    const auto response = server.call(&Admin::Kick, request);
    return to_outcome(
        response, arguments,
        "client " + std::to_string(arguments.client) + " was disconnected; it may reconnect");
}

Outcome ban(Connection& server, const CommandArguments& arguments) {
    v1::BanRequest request;
    set_target(request, arguments);
    request.set_reason(arguments.reason);
    request.set_duration_seconds(arguments.hours * 3600);
    const auto response = server.call(&Admin::Ban, request);
    if (!response.ok()) return server_error(response.error());
    const v1::BanInfo& ban = response->ban();
    return to_outcome(
        response, arguments,
        sanitized(ban.subject() + ban.network()) + " is banned" +
            (ban.expires().empty() ? "" : " until " + ban.expires()) +
            (response->persisted()
                 ? ""
                 : "; the server has no database, so the ban ends when the server stops"));
}

Outcome unban(Connection& server, const CommandArguments& arguments) {
    v1::UnbanRequest request;
    set_target(request, arguments);
    const auto response = server.call(&Admin::Unban, request);
    return to_outcome(response, arguments,
                      sanitized(arguments.subject + arguments.network) + " is no longer banned");
}

Outcome list_bans(Connection& server, const CommandArguments& arguments) {
    const auto response = server.call(&Admin::ListBans, v1::ListBansRequest());
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : bans_text(*response)};
}

Outcome pause(Connection& server, const CommandArguments& arguments) {
    return set_paused(server, arguments, true);
}

Outcome resume(Connection& server, const CommandArguments& arguments) {
    return set_paused(server, arguments, false);
}

Outcome step(Connection& server, const CommandArguments& arguments) {
    v1::StepWorldRequest request;
    request.set_world(arguments.world);
    request.set_steps(arguments.steps);
    const auto response =
        server.call(&Admin::StepWorld, request,
                    Connection::default_timeout + whole_seconds(slowest_step_s * arguments.steps));
    if (!response.ok()) return server_error(response.error());
    return to_outcome(response, arguments,
                      count_text(response->steps_taken(), "step") + " taken; tick " +
                          std::to_string(response->tick()));
}

Outcome export_world(Connection& server, const CommandArguments& arguments) {
    v1::ExportWorldRequest request;
    request.set_world(arguments.world);
    request.set_tick(arguments.tick);
    const auto response = server.call(&Admin::ExportWorld, request, std::chrono::seconds(60));
    if (!response.ok()) return server_error(response.error());
    if (Status s = write_file(arguments.file, scene_file_text(response->scene())); !s.ok())
        return usage_error(s.error());
    if (arguments.file == "-") return {};
    std::string sentence = arguments.file + " contains tick " + std::to_string(response->tick()) +
                           ": " + std::to_string(response->scene().bodies_size()) + " bodies, " +
                           std::to_string(response->scene().joints_size()) + " joints";
    for (const std::string& omitted : response->omitted())
        sentence += "\n  omitted: " + sanitized(omitted, 200);
    if (!arguments.json) return {.text = sentence + "\n"};
    v1::ExportWorldResponse without_scene = *response;
    without_scene.clear_scene();
    return {.text = json_text(without_scene)};
}

Outcome rewind(Connection& server, const CommandArguments& arguments) {
    v1::RewindWorldRequest request;
    request.set_world(arguments.world);
    request.set_tick(arguments.tick);
    const auto response = server.call(&Admin::RewindWorld, request, std::chrono::seconds(60));
    return to_outcome(response, arguments,
                      sanitized(arguments.world) + " was restored to its state after tick " +
                          std::to_string(arguments.tick) + "; ticks continue from " +
                          (response.ok() ? std::to_string(response->tick()) : ""));
}

Outcome undo(Connection& server, const CommandArguments& arguments) {
    v1::UndoClientRequest request;
    request.set_world(arguments.world);
    request.set_client(arguments.client);
    request.set_seconds(arguments.undo_seconds);
    const auto response = server.call(&Admin::UndoClient, request, std::chrono::seconds(600));
    if (!response.ok()) return server_error(response.error());
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.1f", response->seconds());
    const bool is_shorter = response->seconds() < arguments.undo_seconds - 0.05;
    return to_outcome(response, arguments,
                      std::to_string(response->inputs()) + " inputs of client " +
                          std::to_string(arguments.client) + " in the last " + seconds +
                          " s were undone in " + sanitized(arguments.world) +
                          (is_shorter ? ", which is all of its history" : "") +
                          "; ticks continue from " + std::to_string(response->tick()));
}

Outcome remove_bodies(Connection& server, const CommandArguments& arguments) {
    v1::RemoveBodiesRequest request;
    request.set_world(arguments.world);
    request.set_client(arguments.client);
    const auto response = server.call(&Admin::RemoveBodies, request, std::chrono::seconds(60));
    return to_outcome(response, arguments,
                      (response.ok() ? std::to_string(response->bodies()) : "") +
                          " bodies of client " + std::to_string(arguments.client) +
                          " were removed from " + sanitized(arguments.world));
}

Outcome list_players(Connection& server, const CommandArguments& arguments) {
    v1::ListPlayersRequest request;
    request.set_world(arguments.world);
    const auto response = server.call(&Admin::ListPlayers, request);
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : players_text(*response)};
}

Outcome set_role(Connection& server, const CommandArguments& arguments) {
    const Result<v1::PlayerRole> role = parse_role(arguments.role);
    if (!role.ok()) return usage_error(role.error());
    v1::SetPlayerRoleRequest request;
    request.set_world(arguments.world);
    request.set_client(arguments.client);
    request.set_role(*role);
    const auto response = server.call(&Admin::SetPlayerRole, request);
    return to_outcome(response, arguments,
                      "player " + std::to_string(arguments.client) + " of " +
                          sanitized(arguments.world) + " has the role " + arguments.role);
}

Outcome get_attributes(Connection& server, const CommandArguments& arguments) {
    v1::GetAttributesRequest request;
    request.set_world(arguments.world);
    if (!arguments.target.empty())
        if (Status s = parse_target(arguments.target, *request.mutable_target()); !s.ok())
            return usage_error(s.error());
    const auto response = server.call(&Admin::GetAttributes, request);
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : attributes_text(*response)};
}

Outcome set_attribute(Connection& server, const CommandArguments& arguments) {
    v1::SetAttributesRequest request;
    request.set_world(arguments.world);
    if (Status s = parse_target(arguments.target, *request.mutable_set()); !s.ok())
        return usage_error(s.error());
    v1::Attribute& attribute = *request.mutable_set()->add_attributes();
    attribute.set_key(arguments.key);
    if (!arguments.removes) {
        parse_value(arguments.value, arguments.is_text, attribute);
        if (Status s = parse_visibility(arguments.visibility, attribute); !s.ok())
            return usage_error(s.error());
    }
    const auto response = server.call(&Admin::SetAttributes, request);
    return to_outcome(
        response, arguments,
        sanitized(arguments.target) + " " + sanitized(arguments.key) +
            (arguments.removes ? " is removed" : " is " + sanitized(value_text(attribute), 300)));
}

Outcome send_message(Connection& server, const CommandArguments& arguments) {
    v1::SendMessageRequest request;
    request.set_world(arguments.world);
    request.set_topic(arguments.topic);
    request.set_data(arguments.text);
    request.mutable_to()->Add(arguments.recipients.begin(), arguments.recipients.end());
    const auto response = server.call(&Admin::SendMessage, request);
    if (!response.ok()) return server_error(response.error());
    return to_outcome(
        response, arguments,
        "message " + std::to_string(response->number()) + " was sent to " +
            (arguments.recipients.empty()
                 ? "all players"
                 : count_text(static_cast<std::uint32_t>(arguments.recipients.size()), "player")));
}

Outcome backup(Connection& server, const CommandArguments& arguments) {
    const std::string part = arguments.file + ".part";
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    const auto failed = [&](const Outcome& outcome) {
        std::remove(part.c_str());
        return outcome;
    };
    const auto cannot_write = [&] {
        return usage_error(
            {ErrorCode::unavailable, "cannot write " + part + ": " + std::strerror(errno)});
    };
    if (!file || ::chmod(part.c_str(), 0600) != 0) return cannot_write();
    const bool has_terminal = ::isatty(STDERR_FILENO) != 0;
    v1::BackupRequest request;
    for (;;) {
        // The first call makes the backup.
        const auto timeout =
            request.id().empty() ? std::chrono::seconds(600) : Connection::default_timeout;
        const auto response = server.call(&Admin::Backup, request, timeout);
        if (!response.ok()) return failed(server_error(response.error()));
        if (response->data().empty()) break;
        request.set_id(response->id());
        request.set_offset(request.offset() + response->data().size());
        file << response->data();
        if (!file) return failed(cannot_write());
        if (has_terminal)
            std::fprintf(stderr, "\r%s of %s MB%s", megabytes(request.offset()).c_str(),
                         megabytes(response->bytes()).c_str(),
                         request.offset() == response->bytes() ? "\n" : "");
    }
    file.close();
    if (!file) return failed(cannot_write());
    const auto report = server::verify_store(part);
    if (!report.ok()) return failed(server_error(report.error()));
    if (!report->errors.empty())
        return failed({.error = "the backup is damaged: " + report->errors.front()});
    if (std::rename(part.c_str(), arguments.file.c_str()) != 0) return failed(cannot_write());
    return {.text =
                arguments.json
                    ? report_json(*report)
                    : arguments.file + " is a backup of " +
                          count_text(static_cast<std::uint32_t>(report->worlds.size()), "world") +
                          "\n" + report_text(*report)};
}

Outcome verify(const CommandArguments& arguments) {
    const auto report = server::verify_store(arguments.file);
    if (!report.ok())
        return {.error = report.error().message,
                .is_usage_error = report.error().code == ErrorCode::not_found};
    Outcome outcome{.text = arguments.json ? report_json(*report) : report_text(*report)};
    if (!report->errors.empty())
        outcome.error = arguments.file + " is damaged: " + report->errors.front();
    return outcome;
}

Outcome restore(const CommandArguments& arguments) {
    const auto renamed = server::restore_store(arguments.file, arguments.database);
    if (!renamed.ok()) return {.error = renamed.error().message};
    if (arguments.json) {
        nlohmann::json json = {{"database", arguments.database}, {"renamed", *renamed}};
        return {.text = json.dump(2) + "\n"};
    }
    std::string text =
        arguments.database + " is restored from " + arguments.file + "; start the server with it\n";
    for (const std::string& name : *renamed) text += "  a file so far is now " + name + "\n";
    return {.text = text};
}

Outcome drain(Connection& server, const CommandArguments& arguments) {
    const auto response = server.call(&Admin::Drain, v1::DrainRequest());
    if (!response.ok()) return server_error(response.error());
    return to_outcome(response, arguments,
                      "the server is draining: " + count_text(response->clients(), "client") +
                          " notified, timeout " + number_text(response->timeout_seconds(), 0) +
                          " s");
}

Outcome profile(Connection& server, const CommandArguments& arguments) {
    v1::ProfileRequest request;
    request.set_world(arguments.world);
    request.set_seconds(arguments.seconds);
    const auto response = server.call(
        &Admin::Profile, request, Connection::default_timeout + whole_seconds(arguments.seconds));
    if (!response.ok()) return server_error(response.error());
    if (Status s = write_file(arguments.file, response->trace()); !s.ok())
        return usage_error(s.error());
    if (arguments.file == "-") return {};
    if (!arguments.json)
        return {.text = arguments.file + " contains " + count_text(response->ticks(), "tick") +
                        "; open it at https://ui.perfetto.dev or chrome://tracing\n"};
    v1::ProfileResponse without_trace = *response;
    without_trace.clear_trace();
    return {.text = json_text(without_trace)};
}

}  // namespace jostle::ctl
