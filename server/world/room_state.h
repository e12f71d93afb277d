// SPDX-License-Identifier: MIT
//
// The state of a room: members, roles, quotas and decisions of moderation. Part of the state of the
// world: it changes only in ticks, by journaled commands and by the steps of the world, and it is
// saved with the world. room_codec.h encodes it. Times count the steps of the world, so that they
// do not pass while it is paused.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/world/player_role.h"
#include "server/world/room_properties.h"

namespace jostle::server {

// Prefixes of members: the subject of a token, or the network of an anonymous client. Roles persist
// for subjects only, bans for both.
inline constexpr std::string_view subject_member = "subject/", network_member = "network/";

// A token bucket. It may be overdrawn, because some costs are known only afterwards.
struct RoomBucket {
    double level = 0;
    std::uint64_t step = 0;  // of the level

    bool operator==(const RoomBucket&) const = default;
};

struct RoomClient {
    std::uint32_t client = 0;
    PlayerRole role = PlayerRole::unspecified;
    std::string member = {};
    bool spectator = false;         // it joined as one, so it cannot have another role
    std::uint64_t entered = 0;      // counts the clients that entered the room
    std::uint64_t muted_until = 0;  // step; 0: not muted
    std::uint64_t vote_after = 0;   // step before which it cannot begin a vote
    RoomBucket energy = {}, explosions = {};
    bool removed = false;  // kicked or banned: its session ends
    std::string removed_reason = {};

    bool operator==(const RoomClient&) const = default;
};
struct RoomBan {
    std::string member;
    std::uint64_t until = 0;  // step; 0: until UnbanMember
    std::string reason = {};

    bool operator==(const RoomBan&) const = default;
};
// A role that persists while the member is away.
struct RoomGrant {
    std::string member;
    PlayerRole role = PlayerRole::unspecified;

    bool operator==(const RoomGrant&) const = default;
};
struct RoomVote {
    std::uint32_t target = 0;
    std::uint64_t until = 0;                  // step
    std::vector<std::uint32_t> clients = {};  // that voted for it

    bool operator==(const RoomVote&) const = default;
};

struct RoomState {
    RoomProperties properties;
    // Member. Empty: the first player who enters, and after it the one that is present for longest.
    std::string owner = {};
    std::uint64_t step = 0;
    std::uint64_t entered = 0;
    std::vector<RoomClient> clients = {};  // in ascending order of id
    std::vector<RoomBan> bans = {};        // in order of time
    std::vector<RoomGrant> grants = {};    // likewise
    std::optional<RoomVote> vote = {};

    const RoomClient* find(std::uint32_t client) const {
        const auto at = std::ranges::lower_bound(clients, client, {}, &RoomClient::client);
        return at != clients.end() && at->client == client ? &*at : nullptr;
    }
    RoomClient* find(std::uint32_t client) {
        return const_cast<RoomClient*>(std::as_const(*this).find(client));
    }
    const RoomBan* ban_of(std::string_view member) const {
        for (const RoomBan& ban : bans)
            if (ban.member == member) return &ban;
        return nullptr;
    }
    bool operator==(const RoomState&) const = default;
};

// The state as of its last change, apart from steps and buckets: for sessions, lists of worlds and
// operators. Null: the world is no room.
using RoomView = std::shared_ptr<const RoomState>;

}  // namespace jostle::server
