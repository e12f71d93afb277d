// SPDX-License-Identifier: MIT
#include "server/messages/room_message.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "jostle/v1/play.pb.h"
#include "jostle/v1/room.pb.h"
#include "server/messages/message_parts.h"
#include "server/util/text.h"

namespace jostle::server {
namespace {

Result<ProtectedArea> area_from_message(const v1::ProtectedArea& message) {
    ProtectedArea area{
        .name = message.name(), .min = to_vector(message.min()), .max = to_vector(message.max())};
    if (message.min_role().empty()) return area;
    const auto role = parse_player_role(message.min_role());
    if (!role)
        return invalid_argument(
            fmt::format("area.min_role is {}; it must be player, builder or owner",
                        quoted(message.min_role(), 64)));
    area.min_role = *role;
    return area;
}

// The entries in the order of their names, so that the first error is always the same.
template <class Value>
std::map<std::string, Value> sorted(const google::protobuf::Map<std::string, Value>& entries) {
    std::map<std::string, Value> out;
    for (const auto& entry : entries) out[entry.first] = entry.second;
    return out;
}

}  // namespace

Result<RoomProperties> room_from_message(const v1::RoomSettings& message) {
    RoomProperties room{.title = message.title(),
                        .description = message.description(),
                        .tags = {message.tags().begin(), message.tags().end()},
                        .capacity = message.capacity(),
                        .join_code = message.join_code(),
                        .unlisted = message.unlisted(),
                        .close_when_empty = message.close_when_empty(),
                        .areas = {},
                        .timeline_seconds = message.timeline_seconds()};
    if (!message.initial_role().empty()) {
        const auto role = parse_player_role(message.initial_role());
        if (!role)
            return invalid_argument(
                fmt::format("room.initial_role is {}; it must be spectator, player or builder",
                            quoted(message.initial_role(), 64)));
        room.initial_role = *role;
    }
    for (const auto& [key, value] : sorted(message.permissions()))
        if (Status s = set_permission(room, key, value); !s.ok()) return s.error();
    for (const auto& [key, value] : sorted(message.quotas()))
        if (Status s = set_quota(room, key, value); !s.ok()) return s.error();
    for (const v1::ProtectedArea& from : message.areas()) {
        Result<ProtectedArea> area = area_from_message(from);
        if (!area.ok())
            return invalid_argument(
                fmt::format("room.areas[{}]: {}", room.areas.size(), area.error().message));
        room.areas.push_back(*std::move(area));
    }
    if (Status s = check_properties(room); !s.ok()) return s.error();
    return room;
}

v1::RoomSettings with_changes(v1::RoomSettings settings, const v1::RoomSettings& changes) {
    // MergeFrom() would append lists.
    if (changes.tags_size() > 0) settings.clear_tags();
    if (changes.areas_size() > 0) settings.clear_areas();
    settings.MergeFrom(changes);
    return settings;
}

Result<v1::RoomSettings> settings_from_scene(const std::string& bytes) {
    v1::RoomSettings settings;
    if (settings.ParseFromString(bytes)) return settings;
    return invalid_argument("room: the bytes are not a jostle.v1.RoomSettings");
}

void write_room(v1::RoomSettings& to, const RoomProperties& room) {
    to.set_title(room.title);
    to.set_description(room.description);
    for (const std::string& tag : room.tags) to.add_tags(tag);
    to.set_capacity(room.capacity);
    to.set_unlisted(room.unlisted);
    to.set_close_when_empty(room.close_when_empty);
    to.set_timeline_seconds(room.timeline_seconds);
    to.set_initial_role(std::string(name_of(room.initial_role)));
    const PermissionTable usual = default_permissions();
    const auto usual_quotas = RoomProperties::default_quotas();
    for (const PlayerRole role :
         {PlayerRole::spectator, PlayerRole::player, PlayerRole::builder, PlayerRole::owner}) {
        const std::string prefix = std::string(name_of(role)) + ".";
        for (std::size_t i = 0; i < room_actions; i++) {
            const auto action = static_cast<RoomAction>(i);
            if (const Reach reach = room.permissions.of(role, action);
                reach != usual.of(role, action))
                (*to.mutable_permissions())[prefix + std::string(name_of(action))] =
                    std::string(name_of(reach));
        }
        const RoleQuotas& quotas = room.quotas_of(role);
        const RoleQuotas& before = usual_quotas[static_cast<std::size_t>(role)];
        auto& entries = *to.mutable_quotas();
        if (quotas.bodies != before.bodies) entries[prefix + "bodies"] = quotas.bodies;
        if (quotas.joints != before.joints) entries[prefix + "joints"] = quotas.joints;
        if (quotas.energy_per_second != before.energy_per_second)
            entries[prefix + "energy_per_second"] = quotas.energy_per_second;
        if (quotas.explosions_per_minute != before.explosions_per_minute)
            entries[prefix + "explosions_per_minute"] = quotas.explosions_per_minute;
    }
    for (const ProtectedArea& area : room.areas) {
        v1::ProtectedArea& message = *to.add_areas();
        message.set_name(area.name);
        write_vector(*message.mutable_min(), area.min);
        write_vector(*message.mutable_max(), area.max);
        message.set_min_role(std::string(name_of(area.min_role)));
    }
}

void write_ban(v1::RoomBan& to, const RoomBan& ban) {
    to.set_member(ban.member);
    to.set_reason(ban.reason);
    to.set_permanent(ban.until == 0);
}

std::string encode_room_update(const RoomState& room, PlayerRole role) {
    const auto may = [&](RoomAction action) {
        return room.properties.permissions.of(role, action) != Reach::none;
    };
    v1::Snapshot fields;
    v1::RoomUpdate& update = *fields.mutable_room();
    write_room(*update.mutable_settings(), room.properties);
    if (may(RoomAction::settings))
        update.mutable_settings()->set_join_code(room.properties.join_code);
    if (may(RoomAction::ban))
        for (const RoomBan& ban : room.bans) write_ban(*update.add_bans(), ban);
    // Maps have no order of their own.
    std::string bytes;
    {
        google::protobuf::io::StringOutputStream stream(&bytes);
        google::protobuf::io::CodedOutputStream out(&stream);
        out.SetSerializationDeterministic(true);
        fields.SerializeToCodedStream(&out);
    }
    return bytes;
}

Result<RoomCommand> room_command_from_message(const v1::RoomInput& input) {
    switch (input.kind_case()) {
        case v1::RoomInput::kSetRole: {
            const int role = input.set_role().role();
            if (role <= 0 || role >= static_cast<int>(player_roles))
                return invalid_argument(
                    fmt::format("set_role.role is {}; it must be from 1 to 4", role));
            return RoomCommand{SetRole{input.set_role().client(), static_cast<PlayerRole>(role)}};
        }
        case v1::RoomInput::kKick:
            return RoomCommand{KickClient{input.kick().client(), input.kick().reason()}};
        case v1::RoomInput::kBan:
            return RoomCommand{
                BanClient{input.ban().client(), input.ban().seconds(), input.ban().reason()}};
        case v1::RoomInput::kUnban:
            return RoomCommand{UnbanMember{input.unban().member()}};
        case v1::RoomInput::kMute:
            return RoomCommand{MuteClient{input.mute().client(), input.mute().seconds()}};
        case v1::RoomInput::kCleanUp:
            return RoomCommand{CleanUpBodies{input.clean_up().client()}};
        case v1::RoomInput::kProtect: {
            Result<ProtectedArea> area = area_from_message(input.protect().area());
            if (!area.ok()) return area.error();
            return RoomCommand{ProtectArea{*std::move(area)}};
        }
        case v1::RoomInput::kUnprotect:
            return RoomCommand{UnprotectArea{input.unprotect().name()}};
        case v1::RoomInput::kVoteKick:
            return RoomCommand{VoteToKick{input.vote_kick().client()}};
        case v1::RoomInput::kPause:
            return RoomCommand{PauseRoom{input.pause().paused()}};
        case v1::RoomInput::kReset:
            return RoomCommand{ResetRoom{}};
        case v1::RoomInput::kSettings: {
            Result<RoomProperties> room = room_from_message(input.settings());
            if (!room.ok()) return room.error();
            return RoomCommand{
                UpdateRoom{std::make_shared<const RoomProperties>(*std::move(room))}};
        }
        case v1::RoomInput::kStep:
            return RoomCommand{StepRoom{std::max(1u, input.step().steps())}};
        case v1::RoomInput::kSpeed:
            return RoomCommand{SetRoomSpeed{input.speed().percent()}};
        case v1::RoomInput::kRewind:
            return RoomCommand{RewindRoom{input.rewind().tick()}};
        case v1::RoomInput::KIND_NOT_SET:
            break;
    }
    return invalid_argument("the room input is empty or of an unknown kind");
}

}  // namespace jostle::server
