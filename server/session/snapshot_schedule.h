// SPDX-License-Identifier: MIT
//
// Decides which frames become snapshots for one client, and counts the frames that were skipped
// because a write was pending. Snapshots are of ticks that belong to the client's cadence class,
// even if the session is called later, so that the clients of the class share encodings. The first
// snapshot is due at once. Used on the session's thread.
#pragma once

#include <cstdint>
#include <optional>

#include "server/config/config.h"
#include "server/limits/flow_control.h"
#include "server/util/clock.h"

namespace jostle::server {

class SnapshotSchedule {
public:
    // See FlowControl.
    SnapshotSchedule(const StreamSettings& settings, double hz, int divider,
                     OverloadControl* overload = nullptr)
        : flow_(settings, hz, divider, overload),
          heartbeat_period_(from_seconds(1 / settings.heartbeats_per_second)) {}

    // The world published a frame. Frames between two calls are skipped if a write is blocked.
    void on_frame(std::uint32_t tick);
    // Requests a snapshot of the newest tick that belongs to the client's cadence class. It becomes
    // due if flow control permits it. Call it after on_frame().
    void request(Clock::time_point now);
    bool is_due() const { return is_due_; }
    // The tick that made the snapshot due; 0: any.
    std::uint32_t due_tick() const { return due_tick_; }
    // Ticks of the client's class that passed unconsidered before the due one, in ticks of the
    // world. Nothing: the client blocked its stream, so that the server is not to blame.
    std::optional<std::uint32_t> ticks_missed() const { return ticks_missed_; }
    // The due snapshot is not sent; the next tick of the class may be.
    void defer();
    bool heartbeat_due(Clock::time_point now) const {
        return now - last_snapshot_ >= heartbeat_period_;
    }
    void on_sent(std::uint32_t tick, Clock::time_point now);
    void set_write_blocked(bool blocked) { write_blocked_ = blocked; }

    std::uint32_t last_frame() const { return last_frame_; }  // newest tick considered; 0: none
    // Snapshots skipped because a write was pending, and for this or a full window.
    std::uint32_t skipped_pending() const { return skipped_pending_; }
    std::uint32_t skipped() const { return flow_.skipped() + skipped_pending_ + deferred_; }
    // Snapshots skipped because the frame had its maximum of encodings.
    std::uint32_t deferred() const { return deferred_; }
    FlowControl& flow() { return flow_; }
    const FlowControl& flow() const { return flow_; }

private:
    FlowControl flow_;
    const Clock::duration heartbeat_period_;
    Clock::time_point last_snapshot_{};
    std::uint32_t last_frame_ = 0, previous_frame_ = 0;
    std::uint32_t due_tick_ = 0;
    std::optional<std::uint32_t> ticks_missed_;
    std::uint32_t skipped_pending_ = 0, deferred_ = 0;
    bool is_due_ = true;
    bool write_blocked_ = false;
};

}  // namespace jostle::server
