// SPDX-License-Identifier: MIT
//
// Commands about a room: its members, its rules and moderation. They change the state of the room
// in a tick, like the other actions of clients (command.h). Plain values.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include "server/world/player_role.h"
#include "server/world/room_properties.h"

namespace jostle::server {

// A client joined or resumed. From its session, not from the client; without a sequence number.
struct EnterRoom {
    // What identifies the person across sessions: "subject/NAME" or "network/PREFIX" (room.h).
    std::string member = {};
    bool spectator = false;
    bool admin = false;  // an administrator of the server has the rights of the owner
};
// The role owner transfers the ownership.
struct SetRole {
    std::uint32_t client = 0;
    PlayerRole role = PlayerRole::unspecified;
};
struct KickClient {
    std::uint32_t client = 0;
    std::string reason;
};
// Kicks all clients of the member and refuses new ones.
struct BanClient {
    std::uint32_t client = 0;
    double seconds = 0;  // simulated; 0: until UnbanMember
    std::string reason = {};
};
struct UnbanMember {
    std::string member;
};
struct MuteClient {
    std::uint32_t client = 0;
    double seconds = 0;  // simulated; 0: ends the mute
};
// Deletes all bodies that the client spawned, also after it left.
struct CleanUpBodies {
    std::uint32_t client = 0;
};
// Adds the area or replaces that of the same name.
struct ProtectArea {
    ProtectedArea area;
};
struct UnprotectArea {
    std::string name;
};
// Begins a vote to kick the client, or joins it.
struct VoteToKick {
    std::uint32_t client = 0;
};
struct PauseRoom {
    bool paused = false;
};
// Starts the world from its scene again.
struct ResetRoom {};
// Steps a world that a member of the room paused.
struct StepRoom {
    static constexpr std::uint32_t steps_max = 60;
    std::uint32_t steps = 1;
};
// Changes the time between two ticks, not the result of a step.
struct SetRoomSpeed {
    static constexpr std::uint32_t percent_min = 5, percent_max = 100, percent_step = 5;
    std::uint32_t percent = percent_max;
};
// Continues the world from an earlier state.
struct RewindRoom {
    std::uint32_t tick = 0;
};

// Replaces all settings.
struct UpdateRoom {
    // Never null. Shared, because commands are copied and few of them are as large.
    std::shared_ptr<const RoomProperties> properties = std::make_shared<const RoomProperties>();
};

struct RoomCommand {
    static constexpr double seconds_max = 10 * 365.0 * 86400;
    static constexpr std::size_t reason_bytes_max = 100, member_bytes_max = 320;

    std::variant<EnterRoom, SetRole, KickClient, BanClient, UnbanMember, MuteClient, CleanUpBodies,
                 ProtectArea, UnprotectArea, VoteToKick, PauseRoom, ResetRoom, UpdateRoom, StepRoom,
                 SetRoomSpeed, RewindRoom>
        kind;
};

// Whether the values of a command of a client are in range. invalid_argument: names the field.
Status check_room_command(const RoomCommand& command);

}  // namespace jostle::server
