// SPDX-License-Identifier: MIT
#include "server/services/call_method.h"

#include <spdlog/fmt/fmt.h>

#include "jostle/v1/admin.pb.h"

namespace jostle::server {

namespace {

constexpr std::size_t admin_request_bytes_max = 4096;
// 64 attributes with texts of 256 bytes, or a user message.
constexpr std::size_t data_request_bytes_max = 128 << 10;

std::string path_of(const char* name) {
    return fmt::format("/jostle.v1.AdminService/{}", name);
}

enum class Audit { no, yes };

// The details of a request in the audit log, besides its world.
template <class Request>
std::string audit_target(const Request& request) {
    if constexpr (std::is_same_v<Request, v1::KickRequest>)
        return "client " + std::to_string(request.client());
    else if constexpr (requires { request.network(); })
        return request.has_network() ? "network " + request.network()
                                     : "subject " + request.subject();
    else
        return {};
}
template <class Request>
std::string_view audit_reason(const Request& request) {
    if constexpr (requires { request.reason(); })
        return request.reason();
    else
        return {};
}

// A call about the server as a whole, or about the worlds that the caller's token opens.
// `Caller`: nothing, or the identity of the caller.
template <class Request, class Response, class... Caller>
CallMethod server_call(AdminControl& control, const char* name, Audit audit,
                       Status (AdminControl::*handle)(const Request&, Response&, Caller...)) {
    return unary_method<Request, Response>(
        path_of(name), CallWork::quick, admin_request_bytes_max,
        [&control, handle, audit](const CallContext& context, const Request& request,
                                  Response& response) {
            Status done;
            if constexpr (sizeof...(Caller) == 0)
                done = (control.*handle)(request, response);
            else
                done = (control.*handle)(request, response, context.who);
            if (audit == Audit::yes) {
                const std::string target = audit_target(request);
                AccessRequest access = context.access_request({});
                access.target = target;
                access.reason = audit_reason(request);
                context.authorizer.record(context.who, access, done);
            }
            return done;
        });
}

// A call about the world named in the request. `Control`: AdminControl or WorldDataControl.
template <class Control, class Request, class Response>
CallMethod world_call(Control& control, const WorldDirectory& worlds, const char* name,
                      CallWork work, Audit audit,
                      Status (Control::*handle)(const Request&, Response&)) {
    constexpr bool has_data = std::is_same_v<Control, WorldDataControl>;
    return world_method<Request, Response>(
        path_of(name), work, has_data ? data_request_bytes_max : admin_request_bytes_max, worlds,
        [&control, handle, audit](const CallContext& context, const Request& request,
                                  Response& response) {
            Status done = (control.*handle)(request, response);
            if (audit == Audit::yes)
                context.authorizer.record(context.who,
                                          context.access_request({request.world(), {}, {}}), done);
            return done;
        });
}

}  // namespace

std::vector<CallMethod> admin_methods(AdminControl& control, const WorldDirectory& worlds) {
    return {
        server_call(control, "GetServerStatus", Audit::no, &AdminControl::get_server_status),
        server_call(control, "ListClients", Audit::no, &AdminControl::list_clients),
        server_call(control, "ListReports", Audit::no, &AdminControl::list_reports),
        server_call(control, "Kick", Audit::yes, &AdminControl::kick),
        unary_method<v1::BackupRequest, v1::BackupResponse>(
            path_of("Backup"), CallWork::blocking, admin_request_bytes_max,
            [&control](const CallContext& context, const v1::BackupRequest& request,
                       v1::BackupResponse& response) {
                Status done = control.backup(request, response);
                // Once for each backup.
                if (request.id().empty())
                    context.authorizer.record(context.who, context.access_request({}), done);
                return done;
            }),
        server_call(control, "Ban", Audit::yes, &AdminControl::ban),
        server_call(control, "Unban", Audit::yes, &AdminControl::unban),
        server_call(control, "ListBans", Audit::no, &AdminControl::list_bans),
        server_call(control, "Drain", Audit::yes, &AdminControl::drain),
        world_call(control, worlds, "SetPaused", CallWork::quick, Audit::yes,
                   &AdminControl::set_paused),
        world_call(control, worlds, "StepWorld", CallWork::blocking, Audit::yes,
                   &AdminControl::step_world),
        world_call(control, worlds, "ExportWorld", CallWork::blocking, Audit::no,
                   &AdminControl::export_world),
        world_call(control, worlds, "DownloadWorld", CallWork::blocking, Audit::no,
                   &AdminControl::download_world),
        world_call(control, worlds, "RemoveBodies", CallWork::blocking, Audit::yes,
                   &AdminControl::remove_bodies),
        world_call(control, worlds, "GetRoom", CallWork::quick, Audit::no, &AdminControl::get_room),
        world_call(control, worlds, "ModerateRoom", CallWork::blocking, Audit::yes,
                   &AdminControl::moderate_room),
        world_call(control, worlds, "RewindWorld", CallWork::blocking, Audit::yes,
                   &AdminControl::rewind_world),
        world_call(control, worlds, "UndoClient", CallWork::blocking, Audit::yes,
                   &AdminControl::undo_client),
        world_call(control.data(), worlds, "ListPlayers", CallWork::quick, Audit::no,
                   &WorldDataControl::list_players),
        world_call(control.data(), worlds, "SetPlayerRole", CallWork::blocking, Audit::yes,
                   &WorldDataControl::set_player_role),
        world_call(control.data(), worlds, "GetAttributes", CallWork::quick, Audit::no,
                   &WorldDataControl::get_attributes),
        world_call(control.data(), worlds, "SetAttributes", CallWork::blocking, Audit::yes,
                   &WorldDataControl::set_attributes),
        world_call(control.data(), worlds, "SendMessage", CallWork::blocking, Audit::yes,
                   &WorldDataControl::send_message),
        world_call(control.data(), worlds, "ApplyInput", CallWork::blocking, Audit::yes,
                   &WorldDataControl::apply_input),
        world_call(control, worlds, "Profile", CallWork::blocking, Audit::no,
                   &AdminControl::profile),
    };
}

}  // namespace jostle::server
