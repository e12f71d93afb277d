// SPDX-License-Identifier: MIT
//
// AdminService without a transport, used by gRPC (grpc/admin_methods.cpp) and by the admin port.
// The transport authorizes the calls. Any thread. step_world(), export_world(), rewind_world(),
// undo_client() and profile() wait for a world and block the thread for up to half a minute, undos
// of a long time for longer, so only a few of them run at a time.
#pragma once

#include <atomic>

#include "jostle/base/result.h"
#include "server/services/backup_download.h"
#include "server/services/export_download.h"
#include "server/services/world_data_control.h"
#include "server/session/play_context.h"

namespace jostle::v1 {
class BackupRequest;
class BackupResponse;
class BanRequest;
class BanResponse;
class DownloadWorldRequest;
class DownloadWorldResponse;
class DrainRequest;
class DrainResponse;
class ExportWorldRequest;
class ExportWorldResponse;
class GetRoomRequest;
class GetRoomResponse;
class GetServerStatusRequest;
class GetServerStatusResponse;
class KickRequest;
class KickResponse;
class ListBansRequest;
class ListBansResponse;
class ListClientsRequest;
class ListClientsResponse;
class ListReportsRequest;
class ListReportsResponse;
class ModerateRoomRequest;
class ModerateRoomResponse;
class ProfileRequest;
class ProfileResponse;
class RemoveBodiesRequest;
class RemoveBodiesResponse;
class RewindWorldRequest;
class RewindWorldResponse;
class SetPausedRequest;
class SetPausedResponse;
class StepWorldRequest;
class StepWorldResponse;
class UnbanRequest;
class UnbanResponse;
class UndoClientRequest;
class UndoClientResponse;
}  // namespace jostle::v1

namespace jostle::server {

class AdminControl {
public:
    static constexpr int waiting_max = 2;  // concurrent calls that wait for a world
    static constexpr double profile_seconds_max = 30;
    static constexpr double undo_seconds_max = 3600;

    explicit AdminControl(PlayContext& context) : context_(context), data_(context) {}

    // Players, attributes and user messages.
    WorldDataControl& data() { return data_; }

    Authorizer& authorizer() const { return context_.authorizer; }
    // The world of a request, for authorization; null: no such world.
    std::shared_ptr<WorldHost> find(const std::string& world) const {
        return context_.worlds.find(world);
    }

    // The server is shutting down: calls that wait for a world return at once.
    void stop();

    Status get_server_status(const v1::GetServerStatusRequest& request,
                             v1::GetServerStatusResponse& response, const Identity& who);
    Status list_reports(const v1::ListReportsRequest& request, v1::ListReportsResponse& response,
                        const Identity& who);
    // Lists and removes clients of the worlds that the token of `who` opens; others are refused.
    Status list_clients(const v1::ListClientsRequest& request, v1::ListClientsResponse& response,
                        const Identity& who);
    Status kick(const v1::KickRequest& request, v1::KickResponse& response, const Identity& who);
    // Bans by `who`, who cannot ban itself.
    Status ban(const v1::BanRequest& request, v1::BanResponse& response, const Identity& who);
    Status unban(const v1::UnbanRequest& request, v1::UnbanResponse& response);
    Status list_bans(const v1::ListBansRequest& request, v1::ListBansResponse& response);
    Status set_paused(const v1::SetPausedRequest& request, v1::SetPausedResponse& response);
    Status step_world(const v1::StepWorldRequest& request, v1::StepWorldResponse& response);
    Status export_world(const v1::ExportWorldRequest& request, v1::ExportWorldResponse& response);
    Status download_world(const v1::DownloadWorldRequest& request,
                          v1::DownloadWorldResponse& response);
    Status rewind_world(const v1::RewindWorldRequest& request, v1::RewindWorldResponse& response);
    Status undo_client(const v1::UndoClientRequest& request, v1::UndoClientResponse& response);
    Status remove_bodies(const v1::RemoveBodiesRequest& request,
                         v1::RemoveBodiesResponse& response);
    Status get_room(const v1::GetRoomRequest& request, v1::GetRoomResponse& response);
    Status moderate_room(const v1::ModerateRoomRequest& request,
                         v1::ModerateRoomResponse& response);
    Status backup(const v1::BackupRequest& request, v1::BackupResponse& response);
    // Deletes downloads that nobody reads. Call it every few seconds.
    void remove_idle_downloads(Clock::time_point now) {
        backup_download_.remove_idle(now);
        export_download_.remove_idle(now);
    }
    Status drain(const v1::DrainRequest& request, v1::DrainResponse& response);
    Status profile(const v1::ProfileRequest& request, v1::ProfileResponse& response);

private:
    Status write_export(ExportedScene exported, v1::ExportWorldResponse& response) const;
    PlayContext& context_;
    const Clock::time_point started_ = Clock::now();
    WorldDataControl data_;
    std::atomic<int> waiting_{0};
    BackupDownload backup_download_;
    ExportDownload export_download_;
};

}  // namespace jostle::server
