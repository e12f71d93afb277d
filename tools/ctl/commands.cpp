// SPDX-License-Identifier: MIT
#include "tools/ctl/commands.h"

#include <google/protobuf/util/json_util.h>

#include "tools/common/table.h"
#include "tools/ctl/report.h"

namespace jostle::ctl {

using Admin = v1::AdminService::Stub;
using Worlds = v1::WorldService::Stub;

namespace {

// A world of the lowest rate, 4 Hz, takes so long for a step.
constexpr double slowest_step_s = 0.25;

Outcome refused(const Error& error) {
    return {.error = error.message};
}
Outcome misuse(const Error& error) {
    return {.error = error.message, .is_misuse = true};
}

// A sentence for people; the answer itself for programs.
template <class Answer>
Outcome said(const Result<Answer>& answer, const CommandArguments& wanted, const std::string& sentence) {
    if (!answer.ok()) return refused(answer.error());
    return {.text = wanted.json ? json_text(*answer) : sentence + "\n"};
}

std::string count_text(std::uint32_t count, const std::string& thing) {
    return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::chrono::seconds whole_seconds(double seconds) {
    return std::chrono::seconds(static_cast<int>(seconds));
}

// A scene file is the message as JSON. The server checks what it says.
Status read_scene(const std::string& path, v1::Scene& scene) {
    const auto text = read_file(path);
    if (!text.ok()) return text.error();
    const auto read = google::protobuf::util::JsonStringToMessage(*text, &scene);
    if (read.ok()) return {};
    return Error{ErrorCode::invalid_argument,
                 path + " is no scene file (docs/scene_format.md): " + std::string(read.message())};
}

std::string scene_file_text(const v1::Scene& scene) {
    google::protobuf::util::JsonPrintOptions options;
    options.add_whitespace = true;
    std::string text;
    if (!google::protobuf::util::MessageToJsonString(scene, &text, options).ok()) return {};
    return text;
}

Outcome set_paused(Connection& server, const CommandArguments& wanted, bool paused) {
    v1::SetPausedRequest request;
    request.set_world(wanted.world);
    request.set_paused(paused);
    request.set_reason(wanted.reason);
    const auto answer = server.ask(&Admin::SetPaused, request);
    return said(
        answer, wanted,
        shown(wanted.world) + (paused ? " is paused; jostlectl step and resume go on" : " runs"));
}

}  // namespace

Outcome list_worlds(Connection& server, const CommandArguments& wanted) {
    const auto answer = server.ask(&Worlds::ListWorlds, v1::ListWorldsRequest());
    if (!answer.ok()) return refused(answer.error());
    return {.text = wanted.json ? json_text(*answer) : worlds_text(*answer)};
}

Outcome create_world(Connection& server, const CommandArguments& wanted) {
    v1::CreateWorldRequest request;
    request.set_name(wanted.name);
    if (!wanted.from.empty()) {
        request.mutable_checkpoint()->set_world(wanted.from);
        request.mutable_checkpoint()->set_tick(wanted.tick);
    } else if (wanted.file.empty())
        request.set_scene_name(wanted.scene);
    else if (Status s = read_scene(wanted.file, *request.mutable_scene()); !s.ok())
        return misuse(s.error());
    const auto answer = server.ask(&Worlds::CreateWorld, request, std::chrono::seconds(60));
    if (!answer.ok()) return refused(answer.error());
    const v1::WorldInfo& world = answer->world();
    return said(answer, wanted,
                world.id() + " \"" + shown(world.name()) + "\" runs with " +
                    std::to_string(world.bodies()) + " bodies");
}

Outcome delete_world(Connection& server, const CommandArguments& wanted) {
    v1::DeleteWorldRequest request;
    request.set_world(wanted.world);
    const auto answer = server.ask(&Worlds::DeleteWorld, request);
    return said(answer, wanted, shown(wanted.world) + " is deleted");
}

Outcome list_clients(Connection& server, const CommandArguments& wanted) {
    v1::ListClientsRequest request;
    request.set_world(wanted.world);
    const auto answer = server.ask(&Admin::ListClients, request);
    if (!answer.ok()) return refused(answer.error());
    return {.text = wanted.json ? json_text(*answer) : clients_text(*answer)};
}

Outcome kick(Connection& server, const CommandArguments& wanted) {
    v1::KickRequest request;
    request.set_client(wanted.client);
    request.set_reason(wanted.reason);
    const auto answer = server.ask(&Admin::Kick, request);
    return said(answer, wanted,
                "client " + std::to_string(wanted.client) + " is told to go; it may come back");
}

Outcome pause(Connection& server, const CommandArguments& wanted) {
    return set_paused(server, wanted, true);
}

Outcome resume(Connection& server, const CommandArguments& wanted) {
    return set_paused(server, wanted, false);
}

Outcome step(Connection& server, const CommandArguments& wanted) {
    v1::StepWorldRequest request;
    request.set_world(wanted.world);
    request.set_steps(wanted.steps);
    const auto answer =
        server.ask(&Admin::StepWorld, request,
                   Connection::usual_patience + whole_seconds(slowest_step_s * wanted.steps));
    if (!answer.ok()) return refused(answer.error());
    return said(
        answer, wanted,
        count_text(answer->taken(), "step") + " taken; tick " + std::to_string(answer->tick()));
}

Outcome export_world(Connection& server, const CommandArguments& wanted) {
    v1::ExportWorldRequest request;
    request.set_world(wanted.world);
    request.set_tick(wanted.tick);
    const auto answer = server.ask(&Admin::ExportWorld, request, std::chrono::seconds(60));
    if (!answer.ok()) return refused(answer.error());
    if (Status s = write_file(wanted.file, scene_file_text(answer->scene())); !s.ok())
        return misuse(s.error());
    if (wanted.file == "-") return {};
    std::string sentence = wanted.file + " holds tick " + std::to_string(answer->tick()) + ": " +
                           std::to_string(answer->scene().bodies_size()) + " bodies, " +
                           std::to_string(answer->scene().joints_size()) + " joints";
    for (const std::string& left_out : answer->left_out())
        sentence += "\n  left out: " + shown(left_out, 200);
    if (!wanted.json) return {.text = sentence + "\n"};
    v1::ExportWorldResponse without_scene = *answer;
    without_scene.clear_scene();
    return {.text = json_text(without_scene)};
}

Outcome rewind(Connection& server, const CommandArguments& wanted) {
    v1::RewindWorldRequest request;
    request.set_world(wanted.world);
    request.set_tick(wanted.tick);
    const auto answer = server.ask(&Admin::RewindWorld, request, std::chrono::seconds(60));
    return said(answer, wanted,
                shown(wanted.world) + " is as it was after tick " + std::to_string(wanted.tick) +
                    "; ticks go on from " + (answer.ok() ? std::to_string(answer->tick()) : ""));
}

Outcome drain(Connection& server, const CommandArguments& wanted) {
    const auto answer = server.ask(&Admin::Drain, v1::DrainRequest());
    if (!answer.ok()) return refused(answer.error());
    return said(answer, wanted,
                "the server goes down: " + count_text(answer->clients(), "client") +
                    " told, at most " + number_text(answer->timeout_seconds(), 0) + " s");
}

Outcome profile(Connection& server, const CommandArguments& wanted) {
    v1::ProfileRequest request;
    request.set_world(wanted.world);
    request.set_seconds(wanted.seconds);
    const auto answer = server.ask(&Admin::Profile, request,
                                   Connection::usual_patience + whole_seconds(wanted.seconds));
    if (!answer.ok()) return refused(answer.error());
    if (Status s = write_file(wanted.file, answer->trace()); !s.ok()) return misuse(s.error());
    if (wanted.file == "-") return {};
    if (!wanted.json)
        return {.text = wanted.file + " holds " + count_text(answer->ticks(), "tick") +
                        "; open it at https://ui.perfetto.dev or chrome://tracing\n"};
    v1::ProfileResponse without_trace = *answer;
    without_trace.clear_trace();
    return {.text = json_text(without_trace)};
}

}  // namespace jostle::ctl
