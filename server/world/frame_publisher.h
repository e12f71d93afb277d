// SPDX-License-Identifier: MIT
//
// The outgoing side of a world: the newest frame, the events of the newest ticks, tick times, and
// the number of clients that need optional parts of a frame. The tick thread publishes; any thread
// reads frames and increments or decrements the numbers of listeners.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "server/world/frame.h"
#include "server/world/time_scale.h"

namespace jostle::server {

// Frames carry an optional part while its count is above zero.
struct FrameListeners {
    std::atomic<int> streams{0};  // past frames are retained (FrameRing)
    std::atomic<int> events{0};
    std::atomic<int> motion{0};  // velocities of bodies (module_channels.h)
    std::atomic<int> points{0};  // point objects of modules
    std::atomic<int> controlled_entities{0};
    std::atomic<int> joints{0};  // the list of joints
};

class FramePublisher {
public:
    // `on_frame`: called on the tick thread after each frame; `has_events`: the frame has changes,
    // events or input results. It must only wake another thread.
    FramePublisher(double hz, std::function<void(bool has_events)> on_frame);

    // Any thread: the newest frame; the first one exists before the first tick.
    FramePtr frame() const;
    FrameListeners& listeners() { return listeners_; }
    const FrameListeners& listeners() const { return listeners_; }

    // The tick thread. `events` of the step, if there were any; without listeners the list of
    // recent events is cleared.
    void record_events(std::optional<TickEvents> events);
    const std::shared_ptr<const RecentEvents>& events() const { return events_; }
    // Sets the mean and maximum tick time of the last second, this tick included, and the time
    // scale, which is 0 while the world is paused.
    void measure(Frame& frame, Clock::time_point began);
    // Counts a tick without a frame, at the time at which it was due.
    void count_resting_tick(Clock::time_point due) { time_scale_.count_tick(due); }
    // Ticks have this share of their rate from now on.
    void set_speed(double speed);
    TimeScale::Change poll_time_scale(Clock::time_point now) {
        return time_scale_.poll_change(now);
    }
    // Replaces the newest frame.
    void set_frame(FramePtr frame);
    // Wakes the listeners. `changed`: the frame differs from the previous one or has input results.
    void notify(bool changed);

private:
    const std::function<void(bool has_events)> on_frame_;
    FrameListeners listeners_;
    std::shared_ptr<const RecentEvents> events_ = std::make_shared<const RecentEvents>();
    std::vector<double> tick_ms_;  // ring of the last second
    std::size_t next_ = 0;
    const double hz_;
    double speed_ = 1;
    TimeScale time_scale_;                // relative to the speed
    std::uint32_t published_events_ = 0;  // count of events in the newest frame
    bool has_new_events_ = false;
    mutable std::mutex mutex_;
    FramePtr frame_;
};

}  // namespace jostle::server
