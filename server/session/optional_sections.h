// SPDX-License-Identifier: MIT
//
// The sections that clients request besides cells: statistics, channels, events, the controlled
// entity and the client update. Used on the session's thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/physics/channels.h"
#include "server/config/config.h"
#include "server/limits/session_directory.h"
#include "server/session/broadcast_cache.h"
#include "server/session/input_intake.h"
#include "server/session/snapshot_schedule.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

// Statistics of the world, a few times per second.
class StatsSection final : public SnapshotSection {
public:
    StatsSection(const StreamSettings& settings, const SessionDirectory& sessions,
                 BroadcastCache& broadcast)
        : period_(from_seconds(1 / settings.stats_per_second)),
          sessions_(sessions),
          broadcast_(broadcast) {}

    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override {
        if (now - last_sent_ < period_) return;
        last_sent_ = now;
        const int clients = sessions_.clients_in(broadcast_.host().id());
        parts.fields += *broadcast_.world_stats(frame, static_cast<std::uint32_t>(clients));
    }
    TrafficKind traffic_kind() const override { return TrafficKind::statistics; }

private:
    const Clock::duration period_;
    const SessionDirectory& sessions_;
    BroadcastCache& broadcast_;
    Clock::time_point last_sent_{};
};

// One bit per kind that `names` contains. "*" names every kind except jostle.motion, "points:*"
// every kind with point objects.
std::uint64_t requested_channels(const std::vector<physics::ChannelKind>& kinds,
                                 const std::vector<std::string>& names);
// The bit of jostle.motion; 0: the world has no such kind.
std::uint64_t motion_channel(const std::vector<physics::ChannelKind>& kinds);
// The bits of kinds with point objects.
std::uint64_t point_channels(const std::vector<physics::ChannelKind>& kinds);

// The channel kinds that a client requested, which select the channels in the shared part of its
// snapshots.
class ChannelsSection final : public SnapshotSection {
public:
    // `motion`: the bit of jostle.motion.
    ChannelsSection(std::uint64_t kinds, std::uint64_t motion);

    void on_enter(FrameListeners& listeners) override;
    void on_leave(FrameListeners& listeners) override;
    void append(const FramePtr&, Clock::time_point, SnapshotParts& parts) override {
        parts.channel_kinds = kinds_;
    }
    std::uint64_t kinds() const { return kinds_; }

private:
    const std::uint64_t kinds_;
    const bool has_motion_;
};

// Events of every tick, for a client that subscribed to them. Snapshots at a reduced rate carry the
// events of all ticks since the previous one; a client that lags too far is sent the number of
// ticks it missed.
class EventsSection final : public SnapshotSection {
public:
    // Maximum size of the events in one snapshot: clients accept messages of up to 4 MiB by
    // default. A tick with more events counts as missed.
    static constexpr std::size_t bytes_max = 1 << 20;

    explicit EventsSection(BroadcastCache& broadcast) : broadcast_(broadcast) {}

    void on_enter(FrameListeners& listeners) override { listeners.events++; }
    void on_leave(FrameListeners& listeners) override;
    bool has_changes(const Frame& frame) const override { return cursor_ < frame.events->count; }
    // Includes ticks up to the frame's, so that the client knows the entities of every event.
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

    TrafficKind traffic_kind() const override { return TrafficKind::events; }

    // Number of ticks with events, as RecentEvents counts them, that were sent or missed.
    std::uint32_t cursor() const { return cursor_; }
    void set_cursor(std::uint32_t cursor) { cursor_ = cursor; }

private:
    BroadcastCache& broadcast_;
    std::uint32_t cursor_ = 0;
    std::uint32_t missed_ = 0;  // ticks missed since the last that were sent
};

// State of the entity that a client controls, several times per second, for a client that predicts
// it.
class ControlledEntitySection final : public SnapshotSection {
public:
    // `hz`: ticks per second of the world.
    ControlledEntitySection(ClientId client, double hz);

    void on_enter(FrameListeners& listeners) override { listeners.controlled_entities++; }
    void on_leave(FrameListeners& listeners) override;
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    TrafficKind traffic_kind() const override { return TrafficKind::results; }

private:
    const ClientId client_;
    const std::uint32_t period_;  // ticks between two updates
    // The update that was sent last; the next one is encoded as a difference from it.
    EntityId sent_entity_ = 0;  // 0: none
    std::uint32_t sent_tick_ = 0;
    std::vector<std::uint32_t> sent_words_;
};

// The part of a snapshot for one client: results of its inputs and counters, each only if it
// changed since the previous snapshot.
class ClientUpdateSection final : public SnapshotSection {
public:
    ClientUpdateSection(InputIntake& inputs, const SnapshotSchedule& schedule)
        : inputs_(inputs), schedule_(schedule) {}

    bool has_changes(const Frame&) const override { return !inputs_.results().empty(); }
    // The results stay with the InputIntake, valid until on_results_sent().
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

    // Inputs arrive in datagrams, so that the client must learn which ones were received.
    void report_received_inputs() { reports_received_ = true; }

private:
    InputIntake& inputs_;
    const SnapshotSchedule& schedule_;
    // Values that were sent last.
    std::uint32_t sent_sequence_ = 0, sent_skipped_ = 0, sent_received_ = 0;
    bool reports_received_ = false;
};

}  // namespace jostle::server
