// SPDX-License-Identifier: MIT
#include "server/world/room_command.h"

#include <spdlog/fmt/fmt.h>

#include <string_view>
#include <variant>

#include "server/util/text.h"

namespace jostle::server {

namespace {

Status check_reason(std::string_view field, const std::string& reason) {
    if (reason.size() > RoomCommand::reason_bytes_max)
        return invalid_argument(fmt::format("{} has {} bytes; at most {} are allowed", field,
                                            reason.size(), RoomCommand::reason_bytes_max));
    if (has_control_character(reason))
        return invalid_argument(
            fmt::format("{} contains control characters or invalid UTF-8", field));
    return {};
}

Status check_seconds(std::string_view field, double seconds) {
    if (0 <= seconds && seconds <= RoomCommand::seconds_max) return {};
    return invalid_argument(fmt::format("{} is {:g}; it must be from 0 to {:.0f}", field, seconds,
                                        RoomCommand::seconds_max));
}

}  // namespace

Status check_room_command(const RoomCommand& command) {
    if (const auto* kick = std::get_if<KickClient>(&command.kind))
        return check_reason("kick.reason", kick->reason);
    if (const auto* ban = std::get_if<BanClient>(&command.kind)) {
        if (Status s = check_seconds("ban.seconds", ban->seconds); !s.ok()) return s;
        return check_reason("ban.reason", ban->reason);
    }
    if (const auto* mute = std::get_if<MuteClient>(&command.kind))
        return check_seconds("mute.seconds", mute->seconds);
    if (const auto* unban = std::get_if<UnbanMember>(&command.kind);
        unban && unban->member.size() > RoomCommand::member_bytes_max)
        return invalid_argument(fmt::format("unban.member has {} bytes; at most {} are allowed",
                                            unban->member.size(), RoomCommand::member_bytes_max));
    if (const auto* step = std::get_if<StepRoom>(&command.kind);
        step && (step->steps == 0 || step->steps > StepRoom::steps_max))
        return invalid_argument(fmt::format("step.steps is {}; it must be from 1 to {}",
                                            step->steps, StepRoom::steps_max));
    if (const auto* speed = std::get_if<SetRoomSpeed>(&command.kind);
        speed &&
        (speed->percent < SetRoomSpeed::percent_min || speed->percent > SetRoomSpeed::percent_max ||
         speed->percent % SetRoomSpeed::percent_step != 0))
        return invalid_argument(
            fmt::format("speed.percent is {}; it must be a multiple of {} "
                        "from {} to {}",
                        speed->percent, SetRoomSpeed::percent_step, SetRoomSpeed::percent_min,
                        SetRoomSpeed::percent_max));
    if (const auto* protect = std::get_if<ProtectArea>(&command.kind))
        return check_area(protect->area);
    if (const auto* update = std::get_if<UpdateRoom>(&command.kind))
        return check_properties(*update->properties);
    if (const auto* unprotect = std::get_if<UnprotectArea>(&command.kind);
        unprotect && unprotect->name.size() > RoomProperties::area_name_bytes_max)
        return invalid_argument(fmt::format("unprotect.name has {} bytes; at most {} are allowed",
                                            unprotect->name.size(),
                                            RoomProperties::area_name_bytes_max));
    return {};
}

}  // namespace jostle::server
