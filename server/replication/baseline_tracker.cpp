// SPDX-License-Identifier: MIT
#include "server/replication/baseline_tracker.h"

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

// ticks; the codec supports at most 255 between two frames
constexpr std::uint32_t oldest_baseline_age = 200;

}  // namespace

snapshot::BaselineFrames BaselineTracker::baselines_for(std::uint32_t frame) const {
    snapshot::BaselineFrames baselines;
    if (sent_.empty() || frame - sent_.back() > oldest_baseline_age) return baselines;
    baselines.baseline = sent_.back();
    ASSERT(baselines.baseline <= frame);
    // The newest sent frame that precedes `newer` by at least half of dt1.
    const std::uint32_t apart = (frame - baselines.baseline + 1) / 2;
    const auto older = [&](std::uint32_t newer) -> std::uint32_t {
        for (auto at = sent_.rbegin(); at != sent_.rend(); ++at)
            if (*at + apart <= newer) return newer - *at > oldest_baseline_age ? 0 : *at;
        return 0;
    };
    baselines.baseline2 = older(baselines.baseline);
    ASSERT(baselines.baseline2 <= baselines.baseline);
    if (baselines.baseline2 != 0) baselines.baseline3 = older(baselines.baseline2);
    return baselines;
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
