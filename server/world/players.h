// SPDX-License-Identifier: MIT
//
// The players of a world: every client from its first join until it leaves for good, including
// clients whose connection broke and that may resume. The thread that owns the world changes them
// and publishes immutable lists, which any thread may read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "server/world/command.h"
#include "server/world/player_role.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

inline constexpr std::size_t player_name_bytes_max = 32;

struct Player {
    ClientId client = 0;
    std::string name;
    PlayerRole role = PlayerRole::player;
    std::optional<std::uint32_t> color;  // 0xRRGGBB
    bool connected = true;               // false: the client may resume
    std::uint32_t joined_tick = 0;

    bool operator==(const Player&) const = default;
};
using PlayerPtr = std::shared_ptr<const Player>;

// The numbers are those of jostle.v1.PlayerEventKind.
enum class PlayerEventKind : std::uint8_t {
    joined = 1,
    left,
    renamed,
    role_changed,
    disconnected,
    resumed,
};

struct PlayerEvent {
    std::uint32_t tick = 0;
    PlayerEventKind kind = PlayerEventKind::joined;
    PlayerPtr player;  // after the event; of a player that left: before it
};

// An immutable copy of the list with its newest events.
struct PlayerList {
    static constexpr std::size_t recent_max = 256;

    // Number of events since the start of the process, and of recent.back().
    std::uint32_t revision = 0;
    std::vector<PlayerPtr> players;   // sorted by client
    std::vector<PlayerEvent> recent;  // oldest first

    const Player* find(ClientId client) const;  // null: no such player
};
using PlayerListPtr = std::shared_ptr<const PlayerList>;

class Players {
public:
    Players();

    // A new client joins. A known one resumes: it keeps its name and role.
    void join(const Player& player);
    void disconnect(ClientId client);
    // False: it was no player.
    bool leave(ClientId client);
    Status rename(ClientId client, const std::string& name);
    Status set_role(ClientId client, PlayerRole role);

    const Player* find(ClientId client) const;  // null: no such player
    // unspecified: no such player.
    PlayerRole role_of(ClientId client) const;
    std::size_t size() const { return players_.size(); }

    // The list after the changes since the last call, which happened in `tick`; the same pointer if
    // there were none.
    const PlayerListPtr& publish(std::uint32_t tick);

    void write(SavedHostState& host_state) const;
    void restore(const SavedHostState& host_state);

private:
    void put(Player player, PlayerEventKind kind);

    std::map<ClientId, PlayerPtr> players_;
    std::vector<PlayerEvent> events_;  // since the last publish()
    bool changed_ = false;             // likewise
    PlayerListPtr list_;
};

// Checks a name for RenameInput.
Status check_player_name(const std::string& name, const std::string& where);

}  // namespace jostle::server
