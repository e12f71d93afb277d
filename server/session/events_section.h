// SPDX-License-Identifier: MIT
//
// Events of every tick, for a client that subscribed to them. Snapshots at a reduced rate carry the
// events of all ticks since the previous one; a client that lags too far is sent the number of
// ticks it missed. Used on the session's thread.
#pragma once

#include <cstdint>

#include "server/session/broadcast_cache.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

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

    // Number of ticks with events, as RecentEvents counts them, that were sent or missed.
    std::uint32_t cursor() const { return cursor_; }
    void set_cursor(std::uint32_t cursor) { cursor_ = cursor; }

private:
    BroadcastCache& broadcast_;
    std::uint32_t cursor_ = 0;
    std::uint32_t missed_ = 0;  // ticks missed since the last that were sent
};

}  // namespace jostle::server
