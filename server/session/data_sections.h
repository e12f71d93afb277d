// SPDX-License-Identifier: MIT
//
// The sections of players, attributes and user messages, for clients that subscribe to them. Used
// on the session's thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/limits/connected_clients.h"
#include "server/session/broadcast_cache.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

// The player list, then its events, and round-trip times once per second.
class PlayersSection final : public SnapshotSection {
public:
    PlayersSection(BroadcastCache& broadcast, const ConnectedClients& clients)
        : broadcast_(broadcast), clients_(clients) {}

    bool has_changes(const Frame& frame) const override {
        return revision_ != frame.players->revision;
    }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    TrafficKind traffic_kind() const override { return TrafficKind::attributes; }
    // The next snapshot is a keyframe, at which a recording can be entered: it carries the complete
    // list.
    void send_complete() { sends_complete_ = true; }

private:
    BroadcastCache& broadcast_;
    const ConnectedClients& clients_;
    std::optional<std::uint32_t> revision_;  // that was sent; nothing: none
    bool sends_complete_ = true;
    SharedBytes pings_;  // that were sent last
};

// The attributes that the client may read, then their changes.
class AttributesSection final : public SnapshotSection {
public:
    // Bytes of changes in one snapshot. A complete table is sent in one piece;
    // world.attribute_bytes_max bounds it.
    static constexpr std::size_t bytes_max = 1 << 20;

    // `initial`: the role until the world lists the client.
    AttributesSection(BroadcastCache& broadcast, ClientId client, PlayerRole initial)
        : broadcast_(broadcast), client_(client), initial_(initial), role_(initial) {}

    bool has_changes(const Frame& frame) const override {
        return revision_ != frame.attributes->revision || is_role_changed(frame);
    }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    TrafficKind traffic_kind() const override { return TrafficKind::attributes; }
    // As PlayersSection::send_complete().
    void send_complete() { revision_.reset(), has_table_ = true; }

private:
    PlayerRole role_in(const Frame& frame) const;
    bool is_role_changed(const Frame& frame) const {
        return players_ != frame.players && role_in(frame) != role_;
    }
    void append_table(const Frame& frame, SnapshotParts& parts);

    BroadcastCache& broadcast_;
    const ClientId client_;
    const PlayerRole initial_;
    PlayerRole role_;
    PlayerListPtr players_;                  // in which the client had this role
    std::optional<std::uint32_t> revision_;  // that was sent; nothing: none
    bool has_table_ = false;                 // a table was sent that the next one must replace
};

// The settings of the room as the role of the client may see them, after each change.
class RoomSection final : public SnapshotSection {
public:
    RoomSection(BroadcastCache& broadcast, ClientId client)
        : broadcast_(broadcast), client_(client) {}

    bool has_changes(const Frame& frame) const override { return frame.room != room_; }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    TrafficKind traffic_kind() const override { return TrafficKind::attributes; }

private:
    BroadcastCache& broadcast_;
    const ClientId client_;
    RoomView room_;     // that was examined last
    SharedBytes sent_;  // null: nothing
};

// User messages of the topics that the client requested.
class MessagesSection final : public SnapshotSection {
public:
    static constexpr std::size_t bytes_max = 1 << 20;  // in one snapshot

    MessagesSection(BroadcastCache& broadcast, ClientId client, std::vector<std::string> topics);

    bool has_changes(const Frame& frame) const override { return cursor_ < frame.messages->count; }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    TrafficKind traffic_kind() const override { return TrafficKind::messages; }

    // Number of the last message that was sent, skipped or missed.
    std::uint32_t cursor() const { return cursor_; }
    void set_cursor(std::uint32_t number) { cursor_ = number; }

private:
    bool is_wanted(const UserMessage& message) const;

    BroadcastCache& broadcast_;
    const ClientId client_;
    const std::vector<std::string> topics_;
    const bool all_topics_;
    std::uint32_t cursor_ = 0;
};

}  // namespace jostle::server
