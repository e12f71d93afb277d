// SPDX-License-Identifier: MIT
//
// Players, attributes and user messages of one world, each encoded once for all clients that
// receive them (broadcast_cache.h). Any thread.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "server/limits/connected_clients.h"
#include "server/messages/out_message.h"
#include "server/messages/player_message.h"
#include "server/util/clock.h"
#include "server/world/attributes.h"
#include "server/world/players.h"
#include "server/world/room_state.h"
#include "server/world/user_messages.h"

namespace jostle::server {

// Fields of jostle.v1.Snapshot. A null pointer: nothing to send.
class SharedData {
public:
    SharedBytes player_list(const PlayerListPtr& list);
    // The events after revision `since`, which the list still has.
    SharedBytes player_events(const PlayerListPtr& list, std::uint32_t since);
    // The round-trip times of the clients of the world, measured once per second.
    SharedBytes pings(const ConnectedClients& clients, const std::string& world_id,
                      Clock::time_point now);

    SharedBytes attribute_table(const AttributeTablePtr& table, std::uint32_t tick,
                                PlayerRole role);
    SharedBytes attribute_changes(const std::shared_ptr<const AttributeChanges>& changes,
                                  PlayerRole role);

    SharedBytes message(const UserMessagePtr& message);

    // The room as clients of a role see it. Equal content has the same pointer.
    SharedBytes room(const RoomView& room, PlayerRole role);

private:
    using PerRole = std::array<SharedBytes, player_roles>;
    struct Changes {
        std::shared_ptr<const AttributeChanges> changes;
        PerRole bytes;
        std::array<bool, player_roles> is_encoded{};
    };
    struct Events {
        PlayerListPtr list;
        std::uint32_t since = 0;
        SharedBytes bytes;
    };

    std::mutex mutex_;
    PlayerListPtr list_;
    SharedBytes list_bytes_;
    std::deque<Events> events_;  // oldest first
    std::vector<PlayerPing> pings_;
    SharedBytes pings_bytes_;
    Clock::time_point pings_at_{};
    AttributeTablePtr table_;
    PerRole table_bytes_;
    std::deque<Changes> changes_;                                  // oldest first
    std::deque<std::pair<UserMessagePtr, SharedBytes>> messages_;  // ascending number
    RoomView room_;
    PerRole room_bytes_;
    std::array<bool, player_roles> room_is_encoded_{};
};

}  // namespace jostle::server
