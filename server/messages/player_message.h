// SPDX-License-Identifier: MIT
//
// Players and user messages as fields of jostle.v1.Snapshot. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "jostle/v1/play.pb.h"
#include "server/world/players.h"
#include "server/world/user_messages.h"

namespace jostle::server {

struct PlayerPing {
    ClientId client = 0;
    std::uint32_t ping_ms = 0;  // round-trip time; 0: unknown

    bool operator==(const PlayerPing&) const = default;
};

// `ping_ms`: 0: unknown.
void write_player(v1::Player& to, const Player& player, std::uint32_t ping_ms);
// `pings`: sorted by client.
std::string encode_player_list(const PlayerList& list, std::span<const PlayerPing> pings);
std::string encode_player_events(std::span<const PlayerEvent> events);
std::string encode_pings(std::span<const PlayerPing> pings);
std::string encode_user_message(const UserMessage& message);
std::string encode_messages_missed(std::uint32_t missed);

}  // namespace jostle::server
