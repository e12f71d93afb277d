// SPDX-License-Identifier: MIT
#include "server/replication/acked_frames.h"

#include "jostle/base/check.h"

namespace jostle::server {

void AckedFrames::on_sent(std::uint32_t frame, bool by_datagram) {
    if (frame <= last_sent_) return;
    last_sent_ = frame;
    ASSERT(sent_.empty() || sent_.back().frame < frame);
    sent_.push_back({frame, by_datagram});
    if (sent_.size() > BaselineTracker::client_frames_max) sent_.pop_front();
    ASSERT(sent_.size() <= BaselineTracker::client_frames_max);
}

bool AckedFrames::on_ack(std::uint32_t frame, std::uint32_t ack_bits) {
    bool is_new = false;
    for (Sent& sent : sent_) {
        if (sent.frame > frame) break;
        const std::uint32_t back = frame - sent.frame;
        if (sent.acked || (back != 0 && (back > 32 || (ack_bits >> (back - 1) & 1) == 0))) continue;
        sent.acked = true;
        is_new = is_new || sent.by_datagram;
    }
    return is_new;
}

std::uint32_t AckedFrames::newest() const {
    for (auto at = sent_.rbegin(); at != sent_.rend(); ++at)
        if (at->acked) return at->frame;
    return 0;
}

BaselineTracker AckedFrames::known() const {
    BaselineTracker known;
    for (const Sent& sent : sent_)
        if (sent.acked) known.on_sent(sent.frame);
    return known;
}

}  // namespace jostle::server
