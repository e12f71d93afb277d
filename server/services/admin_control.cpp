// SPDX-License-Identifier: MIT
#include "server/services/admin_control.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/admin.pb.h"
#include "server/limits/admission.h"
#include "server/messages/room_message.h"
#include "server/services/find_world.h"
#include "server/services/world_list.h"
#include "server/util/log.h"
#include "server/util/text.h"
#include "server/world/tick_trace.h"

namespace jostle::server {

namespace {

constexpr std::size_t reason_bytes_max = 100;
constexpr double ban_seconds_max = 10 * 365.0 * 86400;
constexpr std::uint32_t steps_max = 1000;
// Added to the time that the steps take at the world's rate.
constexpr double step_timeout_s = 2;

Status check_reason(const std::string& reason) {
    if (reason.size() <= reason_bytes_max) return {};
    return invalid_argument(fmt::format("the reason has {} bytes; at most {} are shown to clients",
                                        reason.size(), reason_bytes_max));
}

// A slot for a call that waits for a world; their number is limited.
class WaitSlot {
public:
    explicit WaitSlot(std::atomic<int>& count)
        : count_(count), admitted_(count.fetch_add(1) < AdminControl::waiting_max) {}
    ~WaitSlot() {
        ASSERT(count_ > 0);
        count_--;
    }
    WaitSlot(const WaitSlot&) = delete;
    WaitSlot& operator=(const WaitSlot&) = delete;

    Status admitted() const {
        if (admitted_) return {};
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("{} such calls are already waiting; retry when they are done",
                                 AdminControl::waiting_max)};
    }

private:
    std::atomic<int>& count_;
    const bool admitted_;
};

void write(v1::ClientInfo& out, const ClientStatus& status) {
    out.set_id(status.who.id);
    out.set_name(status.who.name);
    out.set_subject(status.who.subject);
    out.set_world(status.who.world_id);
    out.set_world_name(status.who.world_name);
    out.set_address(status.who.address);
    out.set_spectator(status.who.spectator);
    out.set_connected_seconds(status.connected_seconds);
    out.set_kbit_per_second(status.kbit_per_second);
    out.set_snapshots_skipped(status.skipped);
    out.set_round_trip_ms(status.round_trip_ms);
}

// `Request`: BanRequest or UnbanRequest.
template <class Request>
Result<BanTarget> target_of(const Request& request) {
    BanTarget target;
    if (request.has_network()) {
        const Result<Network> network = parse_network(request.network());
        if (!network.ok()) return network.error();
        target.network = *network;
    } else if (request.subject().empty()) {
        return invalid_argument("name a subject or a network");
    } else {
        target.subject = request.subject();
    }
    return target;
}

template <class Label>
void write(google::protobuf::RepeatedPtrField<v1::Count>& out, const CountersBy<Label>& counters) {
    for (std::size_t i = 0; i < names_of(Label{}).size(); i++) {
        v1::Count& count = *out.Add();
        count.set_name(std::string(names_of(Label{})[i]));
        count.set_value(counters[static_cast<Label>(i)].Value());
    }
}

void write(v1::BanInfo& out, const Ban& ban) {
    out.set_subject(ban.target.subject);
    if (ban.target.network) out.set_network(text_of(*ban.target.network));
    out.set_reason(ban.reason);
    out.set_by(ban.by);
    out.set_created(rfc3339(ban.created));
    if (ban.expires != WallTime::max()) out.set_expires(rfc3339(ban.expires));
}

Status check_restorable(const Frame& frame, std::uint32_t tick) {
    if (!frame.restorable_ticks) return {};  // the world is no room
    const std::vector<std::uint32_t>& ticks = *frame.restorable_ticks;
    if (std::ranges::binary_search(ticks, tick)) return {};
    if (ticks.empty())
        return Error{ErrorCode::not_found,
                     "the room has no timeline; set timeline_seconds in its settings"};
    return Error{ErrorCode::not_found,
                 fmt::format("tick {} cannot be restored; the timeline has {} states from tick {} "
                             "to tick {}, one per second (GetRoomResponse.restorable_ticks)",
                             tick, ticks.size(), ticks.front(), ticks.back())};
}

}  // namespace

void AdminControl::stop() {
    for (const auto& world : context_.worlds.list()) world->cancel_waiters();
}

Status AdminControl::get_server_status(const v1::GetServerStatusRequest& request,
                                       v1::GetServerStatusResponse& response, const Identity& who) {
    const Clock::time_point now = Clock::now();
    response.set_version(JOSTLE_VERSION);
    response.set_uptime_seconds(std::chrono::duration<double>(now - started_).count());
    response.set_draining(context_.draining);
    for (const auto& world : context_.worlds.list())
        if (who.opens(world->id(), world->name()))
            write_world(*response.add_worlds(), *world, context_.sessions);
    for (const ClientStatus& status : context_.connected_clients.status(now))
        if (who.opens(status.who.world_id, status.who.world_name))
            write(*response.add_clients(), status);
    data_.write_reports(*response.mutable_reports(), who);
    if (who.is_limited_to_worlds()) return {};
    if (context_.metrics) {
        write(*response.mutable_sent_bytes(), context_.metrics->sent_bytes);
        write(*response.mutable_inputs(), context_.metrics->inputs);
        write(*response.mutable_refusals(), context_.metrics->refusals);
    }
    for (const Ban& ban : authorizer().bans().list(std::chrono::system_clock::now()))
        write(*response.add_bans(), ban);
    for (LogLine& line : log_tail(request.log_after())) {
        v1::LogLine& out = *response.add_log();
        out.set_number(line.number);
        out.set_time(std::move(line.time));
        out.set_level(std::move(line.level));
        out.set_text(std::move(line.text));
    }
    return {};
}

Status AdminControl::list_reports(const v1::ListReportsRequest& request,
                                  v1::ListReportsResponse& response, const Identity& who) {
    return data_.list_reports(request, response, who);
}

Status AdminControl::list_clients(const v1::ListClientsRequest& request,
                                  v1::ListClientsResponse& response, const Identity& who) {
    std::string world_id;
    if (!request.world().empty()) {
        const auto world = find_world(context_, request.world());
        if (!world.ok()) return world.error();
        world_id = (*world)->id();
        if (!who.opens(world_id, (*world)->name()))
            return Error{ErrorCode::permission_denied, "the token is for another world"};
    }
    for (const ClientStatus& status : context_.connected_clients.status(Clock::now()))
        if ((world_id.empty() || status.who.world_id == world_id) &&
            who.opens(status.who.world_id, status.who.world_name))
            write(*response.add_clients(), status);
    return {};
}

Status AdminControl::kick(const v1::KickRequest& request, v1::KickResponse&, const Identity& who) {
    if (Status s = check_reason(request.reason()); !s.ok()) return s;
    const std::string reason = request.reason().empty() ? "no reason given" : request.reason();
    if (Status s = context_.connected_clients.kick(request.client(), reason, who); !s.ok())
        return s;
    log_info("client {} was kicked by an operator", request.client());
    return {};
}

Status AdminControl::ban(const v1::BanRequest& request, v1::BanResponse& response,
                         const Identity& who) {
    const Result<BanTarget> target = target_of(request);
    if (!target.ok()) return target.error();
    if (!who.anonymous && target->subject == who.subject)
        return invalid_argument("the subject is your own; another administrator can ban it");
    const double seconds = request.duration_seconds();
    if (!(0 <= seconds && seconds <= ban_seconds_max))
        return invalid_argument(fmt::format("duration_seconds is {:g}; it must be from 0 to {:.0f}",
                                            seconds, ban_seconds_max));
    const WallTime now = std::chrono::system_clock::now();
    Ban ban{.target = *target,
            .reason = request.reason(),
            .by = who.subject,
            .created = std::chrono::floor<std::chrono::seconds>(now)};
    if (seconds > 0)
        ban.expires = std::chrono::ceil<std::chrono::seconds>(
            now + std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000)));
    BanList& bans = authorizer().bans();
    if (Status s = bans.add(ban, now); !s.ok()) return s;
    log_info("{} was banned by an operator{}", printable(text_of(ban.target), 300),
             bans.is_persisted() ? "" : " until the server stops: it has no database");
    write(*response.mutable_ban(), ban);
    response.set_persisted(bans.is_persisted());
    return {};
}

Status AdminControl::unban(const v1::UnbanRequest& request, v1::UnbanResponse&) {
    const Result<BanTarget> target = target_of(request);
    if (!target.ok()) return target.error();
    if (Status s = authorizer().bans().remove(*target, std::chrono::system_clock::now()); !s.ok())
        return s;
    log_info("the ban of {} was removed by an operator", printable(text_of(*target), 300));
    return {};
}

Status AdminControl::list_bans(const v1::ListBansRequest&, v1::ListBansResponse& response) {
    BanList& bans = authorizer().bans();
    for (const Ban& ban : bans.list(std::chrono::system_clock::now()))
        write(*response.add_bans(), ban);
    response.set_persisted(bans.is_persisted());
    return {};
}

Status AdminControl::set_paused(const v1::SetPausedRequest& request,
                                v1::SetPausedResponse& response) {
    if (Status s = check_reason(request.reason()); !s.ok()) return s;
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    if (request.paused())
        (*world)->pause(request.reason().empty() ? "by an operator" : request.reason());
    else
        (*world)->resume();
    response.set_tick((*world)->frame()->tick);
    return {};
}

Status AdminControl::step_world(const v1::StepWorldRequest& request,
                                v1::StepWorldResponse& response) {
    if (request.steps() < 1 || request.steps() > steps_max)
        return invalid_argument(
            fmt::format("steps is {}; it must be from 1 to {}", request.steps(), steps_max));
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    if (!(*world)->lifecycle().paused())
        return Error{ErrorCode::failed_precondition,
                     fmt::format("world {} is not paused; pause it first", (*world)->id())};
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    const auto steps = static_cast<int>(request.steps());
    const Result<int> taken =
        (*world)->single_step().step(steps, from_seconds(steps / (*world)->hz() + step_timeout_s));
    if (!taken.ok()) return taken.error();
    response.set_tick((*world)->frame()->tick);
    ASSERT(*taken >= 0 && *taken <= steps);
    response.set_steps_taken(static_cast<std::uint32_t>(*taken));
    return {};
}

Status AdminControl::export_world(const v1::ExportWorldRequest& request,
                                  v1::ExportWorldResponse& response) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    ExportedScene exported;
    if (request.tick() != 0) {
        Result<ExportedScene> past = context_.worlds.scene_at(**world, request.tick());
        if (!past.ok()) return past.error();
        exported = *std::move(past);
        response.set_tick(request.tick());
        return write_export(std::move(exported), response);
    }
    const Status done = (*world)->between_ticks().run([&](HostedWorld& hosted) {
        exported = hosted.exported(*(*world)->properties().scene);
        response.set_tick((*world)->frame()->tick);
    });
    return done.ok() ? write_export(std::move(exported), response) : done;
}

Status AdminControl::download_world(const v1::DownloadWorldRequest& request,
                                    v1::DownloadWorldResponse& response) {
    const Clock::time_point now = Clock::now();
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    Result<ExportDownload::Piece> piece = Error{};
    if (request.id().empty()) {
        if (Status s = export_download_.admit(now); !s.ok()) return s;  // before the expensive part
        v1::ExportWorldRequest export_request;
        export_request.set_world(request.world());
        export_request.set_tick(request.tick());
        v1::ExportWorldResponse exported;
        if (Status s = export_world(export_request, exported); !s.ok()) return s;
        piece = export_download_.begin((*world)->id(), exported.SerializeAsString(), Clock::now());
    } else {
        piece = export_download_.read((*world)->id(), request.id(), request.offset(), now);
    }
    if (!piece.ok()) return piece.error();
    response.set_id(piece->id);
    response.set_bytes(piece->bytes);
    response.set_data(std::move(piece->data));
    return {};
}

Status AdminControl::rewind_world(const v1::RewindWorldRequest& request,
                                  v1::RewindWorldResponse& response) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    const auto rewound = context_.worlds.rewind(*world, request.tick());
    if (!rewound.ok()) return rewound.error();
    log_info("world {} was rewound to tick {} by an operator", (*rewound)->id(), request.tick());
    response.set_tick((*rewound)->properties().first_tick);
    return {};
}

Status AdminControl::undo_client(const v1::UndoClientRequest& request,
                                 v1::UndoClientResponse& response) {
    if (request.client() == scene_client)
        return invalid_argument("client is 0; it must be the id of a client");
    if (!(1 <= request.seconds() && request.seconds() <= undo_seconds_max))
        return invalid_argument(fmt::format("seconds is {:g}; it must be from 1 to {:g}",
                                            request.seconds(), undo_seconds_max));
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    const auto undone = context_.worlds.undo(*world, request.client(), request.seconds());
    if (!undone.ok()) return undone.error();
    const WorldHost& host = *undone->host;
    const std::uint32_t tick = host.properties().first_tick;
    const double seconds = (tick - undone->first_tick) / host.hz();
    log_info(
        "world {}: an operator undid {} inputs of client {} in the last {:.1f} s, from tick {} on",
        host.id(), undone->inputs, request.client(), seconds, undone->first_tick);
    response.set_tick(tick);
    response.set_first_tick(undone->first_tick);
    response.set_inputs(static_cast<std::uint32_t>(undone->inputs));
    response.set_seconds(seconds);
    return {};
}

Status AdminControl::write_export(ExportedScene exported, v1::ExportWorldResponse& response) const {
    *response.mutable_scene() = scenes::to_message(exported.scene);
    for (std::string& sentence : exported.omitted) *response.add_omitted() = std::move(sentence);
    const auto bytes_max = static_cast<std::size_t>(context_.config.scene.request_bytes_max);
    // A scene that could not be created again is not exported.
    if (const std::size_t bytes = response.ByteSizeLong(); bytes > bytes_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the scene has {} bytes; the setting scene.request_bytes_max "
                                 "allows {}",
                                 bytes, bytes_max)};
    return {};
}

Status AdminControl::remove_bodies(const v1::RemoveBodiesRequest& request,
                                   v1::RemoveBodiesResponse& response) {
    if (request.client() == scene_client)
        return invalid_argument("client is 0; it must be the id of a client");
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    std::size_t removed = 0;
    const Status done = (*world)->between_ticks().run(
        [&](HostedWorld& hosted) { removed = hosted.remove_bodies_of(request.client()); });
    if (!done.ok()) return done;
    log_info("world {}: an operator removed {} bodies of client {}", (*world)->id(), removed,
             request.client());
    response.set_bodies(static_cast<std::uint32_t>(removed));
    return {};
}

Status AdminControl::get_room(const v1::GetRoomRequest& request, v1::GetRoomResponse& response) {
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const RoomView room = (*world)->frame()->room;
    if (!room)
        return Error{
            ErrorCode::failed_precondition,
            fmt::format("world {} has no room; create it with room settings", (*world)->id())};
    write_room(*response.mutable_settings(), room->properties);
    response.set_owner(room->owner);
    for (const RoomClient& client : room->clients) {
        v1::RoomMember& member = *response.add_members();
        member.set_client(client.client);
        member.set_role(static_cast<v1::PlayerRole>(client.role));
        member.set_member(client.member);
        member.set_muted(client.muted_until != 0);
        member.set_removed(client.removed);
    }
    for (const RoomBan& ban : room->bans) write_ban(*response.add_bans(), ban);
    const FramePtr frame = (*world)->frame();
    response.set_speed_percent(frame->speed_percent);
    if (frame->restorable_ticks)
        response.mutable_restorable_ticks()->Add(frame->restorable_ticks->begin(),
                                                 frame->restorable_ticks->end());
    if (!room->vote) return {};
    response.set_vote_target(room->vote->target);
    response.set_votes(static_cast<std::uint32_t>(room->vote->clients.size()));
    return {};
}

Status AdminControl::moderate_room(const v1::ModerateRoomRequest& request,
                                   v1::ModerateRoomResponse& response) {
    const Result<RoomCommand> command = room_command_from_message(request.command());
    if (!command.ok()) return command.error();
    if (std::holds_alternative<PauseRoom>(command->kind))
        return invalid_argument("use SetPaused to pause or resume a world");
    if (std::holds_alternative<StepRoom>(command->kind))
        return invalid_argument("use StepWorld to step a paused world");
    if (Status s = check_numbers(*command); !s.ok()) return s;
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    if (const auto* const rewind = std::get_if<RewindRoom>(&command->kind))
        if (Status s = check_restorable(*(*world)->frame(), rewind->tick); !s.ok()) return s;
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    Status applied;
    const Status done = (*world)->between_ticks().run(
        [&](HostedWorld& hosted) { applied = hosted.apply_to_room(*command); });
    if (!done.ok()) return done;
    if (!applied.ok()) return applied;
    log_info("world {}: an operator moderated its room", (*world)->id());
    response.set_tick((*world)->frame()->tick);
    return {};
}

Status AdminControl::backup(const v1::BackupRequest& request, v1::BackupResponse& response) {
    const Clock::time_point now = Clock::now();
    Result<BackupDownload::Piece> piece = Error{};
    if (request.id().empty()) {
        WorldPersistence* const persistence = context_.worlds.persistence();
        if (persistence == nullptr)
            return Error{ErrorCode::failed_precondition,
                         "the server persists no worlds; set persistence.database"};
        const WaitSlot slot(waiting_);
        if (Status s = slot.admitted(); !s.ok()) return s;
        piece = backup_download_.begin(*persistence, now);
        if (piece.ok()) log_info("an operator makes a backup of {} bytes", piece->bytes);
    } else {
        piece = backup_download_.read(request.id(), request.offset(), now);
    }
    if (!piece.ok()) return piece.error();
    response.set_id(piece->id);
    response.set_bytes(piece->bytes);
    response.set_data(std::move(piece->data));
    return {};
}

Status AdminControl::drain(const v1::DrainRequest&, v1::DrainResponse& response) {
    response.set_clients(static_cast<std::uint32_t>(context_.sessions.clients()));
    response.set_timeout_seconds(context_.config.drain_timeout_seconds);
    if (!context_.drain_requested.exchange(true)) log_info("an operator requested a drain");
    return {};
}

Status AdminControl::profile(const v1::ProfileRequest& request, v1::ProfileResponse& response) {
    if (!(1 <= request.seconds() && request.seconds() <= profile_seconds_max))
        return invalid_argument(fmt::format("seconds is {:g}; it must be from 1 to {:g}",
                                            request.seconds(), profile_seconds_max));
    const auto world = find_world(context_, request.world());
    if (!world.ok()) return world.error();
    const WaitSlot slot(waiting_);
    if (Status s = slot.admitted(); !s.ok()) return s;
    const auto ticks = (*world)->tick_metrics().record(from_seconds(request.seconds()));
    if (!ticks.ok()) return ticks.error();
    response.set_ticks(static_cast<std::uint32_t>(ticks->size()));
    response.set_trace(tick_trace((*world)->name(), *ticks));
    return {};
}

}  // namespace jostle::server
