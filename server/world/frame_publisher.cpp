// SPDX-License-Identifier: MIT
#include "server/world/frame_publisher.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

FramePublisher::FramePublisher(double hz, std::function<void(bool has_events)> on_frame)
    : on_frame_(std::move(on_frame)),
      tick_ms_(static_cast<std::size_t>(std::max(1.0, hz)), 0.0),
      hz_(hz),
      time_scale_(hz) {}

void FramePublisher::set_speed(double speed) {
    if (speed == speed_) return;
    speed_ = speed;
    time_scale_.set_hz(speed * hz_);
}

FramePtr FramePublisher::frame() const {
    const std::lock_guard lock(mutex_);
    return frame_;
}

// Readers may hold the current list, so each tick with events makes a new one.
void FramePublisher::record_events(std::optional<TickEvents> events) {
    if (listeners_.events.load() == 0) {
        if (!events_->ticks.empty())
            events_ = std::make_shared<const RecentEvents>(RecentEvents{events_->count, {}});
        return;
    }
    if (!events) return;
    const auto& old = events_->ticks;
    const std::size_t dropped = old.size() == RecentEvents::ticks_max ? 1 : 0;
    auto recent = std::make_shared<RecentEvents>();
    recent->count = events_->count + 1;
    recent->ticks.assign(old.begin() + static_cast<std::ptrdiff_t>(dropped), old.end());
    recent->ticks.push_back(std::make_shared<const TickEvents>(*std::move(events)));
    ASSERT(recent->ticks.size() <= RecentEvents::ticks_max);
    events_ = std::move(recent);
}

// Measures the whole tick with commands and copies, so that no slow part stays invisible.
void FramePublisher::measure(Frame& frame, Clock::time_point began) {
    ASSERT(next_ < tick_ms_.size());
    tick_ms_[next_] = to_ms(Clock::now() - began);
    next_ = (next_ + 1) % tick_ms_.size();
    frame.tick_ms_mean = std::accumulate(tick_ms_.begin(), tick_ms_.end(), 0.0) /
                         static_cast<double>(tick_ms_.size());
    frame.tick_ms_max = *std::max_element(tick_ms_.begin(), tick_ms_.end());
    if (frame.paused)
        time_scale_.reset();
    else
        time_scale_.count_tick(began);
    frame.time_scale = frame.paused ? 0 : speed_ * time_scale_.value(began);
}

void FramePublisher::set_frame(FramePtr frame) {
    ASSERT(frame && frame->events);
    has_new_events_ =
        frame->events->count != std::exchange(published_events_, frame->events->count);
    FramePtr old;  // freed outside the lock
    const std::lock_guard lock(mutex_);
    old = std::exchange(frame_, std::move(frame));
}

void FramePublisher::notify(bool changed) {
    if (on_frame_) on_frame_(changed || has_new_events_);
}

}  // namespace jostle::server
