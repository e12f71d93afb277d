// SPDX-License-Identifier: MIT
#include "server/replication/baseline_tracker.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

// ticks; the codec supports at most 255 between two frames
constexpr std::uint32_t oldest_baseline_age = 200;

// A baseline at a multiple of this step is less than twice as old as the newest one.
std::uint32_t coarsest_step_within(std::uint32_t gap) {
    std::uint32_t step = 1;
    for (const std::uint32_t coarser : {2u, 4u, 6u, 12u, 30u, 60u})
        if (coarser <= gap) step = coarser;
    return step;
}

}  // namespace

snapshot::BaselineFrames BaselineTracker::baselines_for(std::uint32_t frame) const {
    snapshot::BaselineFrames baselines;
    if (sent_.empty() || frame - sent_.back() > oldest_baseline_age) return baselines;
    const std::uint32_t gap = frame - sent_.back();
    ASSERT(sent_.back() <= frame);
    const bool regular = sent_.size() < 2 || gap < 2 * (sent_.back() - sent_[sent_.size() - 2]);
    const std::uint32_t step = regular ? 1 : coarsest_step_within(gap);
    baselines.baseline = newest_multiple(step, sent_.back());
    if (baselines.baseline == 0) baselines.baseline = sent_.back();
    // The newest sent frame that precedes `newer` by at least half of dt1.
    const std::uint32_t apart = (frame - baselines.baseline + 1) / 2;
    const auto older = [&](std::uint32_t newer) -> std::uint32_t {
        if (newer <= apart) return 0;
        std::uint32_t found = newest_multiple(step, newer - apart);
        if (found == 0) found = newest_multiple(1, newer - apart);
        return found == 0 || newer - found > oldest_baseline_age ? 0 : found;
    };
    baselines.baseline2 = older(baselines.baseline);
    ASSERT(baselines.baseline2 <= baselines.baseline);
    if (baselines.baseline2 != 0) baselines.baseline3 = older(baselines.baseline2);
    return baselines;
}

// The newest sent frame that is a multiple of `step` and at most `frame_max`; 0: there is none.
std::uint32_t BaselineTracker::newest_multiple(std::uint32_t step, std::uint32_t frame_max) const {
    for (auto at = sent_.rbegin(); at != sent_.rend(); ++at)
        if (*at <= frame_max && *at % step == 0) return *at;
    return 0;
}

bool BaselineTracker::was_sent(std::uint32_t frame) const {
    return frame == 0 || std::ranges::binary_search(sent_, frame);
}

bool BaselineTracker::has(const snapshot::BaselineFrames& baselines) const {
    return was_sent(baselines.baseline) && was_sent(baselines.baseline2) &&
           was_sent(baselines.baseline3);
}

bool BaselineTracker::roll_back_to(std::uint32_t frame) {
    while (!sent_.empty() && sent_.back() > frame) sent_.pop_back();
    if (!sent_.empty() && sent_.back() == frame) return true;
    reset();
    return false;
}

void BaselineTracker::on_sent(std::uint32_t frame) {
    ASSERT(sent_.empty() || sent_.back() < frame);
    sent_.push_back(frame);
    if (sent_.size() > client_frames_max) sent_.pop_front();
    ASSERT(sent_.size() <= client_frames_max);
}

}  // namespace jostle::server
