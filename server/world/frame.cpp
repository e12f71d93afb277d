// SPDX-License-Identifier: MIT
#include "server/world/frame.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

const PoseGrid& Frame::pose_grid() const {
    return pose_grid_.get([this] {
        ASSERT(entity_list && entity_list->size() == entities.size());
        std::vector<double> radii;
        radii.reserve(entity_list->size());
        for (const auto& entity : *entity_list) radii.push_back(entity->bounding_radius);
        return PoseGrid(entities, radii);
    });
}

FrameRing::FrameRing(double history_ms, double hz)
    : frames_max_(1 + static_cast<std::size_t>(std::ceil(std::max(0.0, history_ms) * hz / 1000))) {}

void FrameRing::put(FramePtr frame, bool retain) {
    std::vector<FramePtr> old;  // freed outside the lock
    const std::lock_guard lock(mutex_);
    ASSERT(frames_.empty() || frame->tick > frames_.back()->tick);
    const bool follows = frames_.empty() || frame->tick == frames_.back()->tick + 1;
    frames_.push_back(std::move(frame));
    const std::size_t retained = retain && follows ? frames_max_ : 1;
    while (frames_.size() > retained) {
        old.push_back(std::move(frames_.front()));
        frames_.pop_front();
    }
}

std::optional<RewindFrames> FrameRing::at(const ViewTime& view_time) const {
    const std::lock_guard lock(mutex_);
    if (frames_.empty()) return std::nullopt;
    const FramePtr &oldest = frames_.front(), &newest = frames_.back();
    if (view_time.tick >= newest->tick) return RewindFrames{newest, newest, 0, false};
    if (view_time.tick < oldest->tick) return RewindFrames{oldest, oldest, 0, true};
    ASSERT(view_time.tick - oldest->tick + 1 < frames_.size());
    const FramePtr& before = frames_[view_time.tick - oldest->tick];
    if (view_time.fraction == 0) return RewindFrames{before, before, 0, false};
    return RewindFrames{before, frames_[view_time.tick - oldest->tick + 1], view_time.fraction,
                        false};
}

}  // namespace jostle::server
