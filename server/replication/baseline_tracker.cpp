// SPDX-License-Identifier: MIT
#include "server/replication/baseline_tracker.h"

namespace jostle::server {
namespace {

constexpr std::uint32_t oldest_base = 200;  // ticks; the codec takes 255 between two frames

}  // namespace

wire::BaseFrames BaselineTracker::bases_for(std::uint32_t frame) const {
    wire::BaseFrames bases;
    if (sent_.empty() || frame - sent_.back() > oldest_base) return bases;
    bases.base = sent_.back();
    // The newest sent frame that is at least half of dt1 before `before`.
    const std::uint32_t apart = (frame - bases.base + 1) / 2;
    const auto older = [&](std::uint32_t before) -> std::uint32_t {
        for (auto at = sent_.rbegin(); at != sent_.rend(); ++at)
            if (*at + apart <= before) return before - *at > oldest_base ? 0 : *at;
        return 0;
    };
    bases.base2 = older(bases.base);
    if (bases.base2 != 0) bases.base3 = older(bases.base2);
    return bases;
}

bool BaselineTracker::go_back_to(std::uint32_t frame) {
    while (!sent_.empty() && sent_.back() > frame) sent_.pop_back();
    if (!sent_.empty() && sent_.back() == frame) return true;
    reset();
    return false;
}

void BaselineTracker::on_sent(std::uint32_t frame) {
    sent_.push_back(frame);
    if (sent_.size() > client_ring) sent_.pop_front();
}

}  // namespace jostle::server
