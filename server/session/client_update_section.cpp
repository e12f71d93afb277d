// SPDX-License-Identifier: MIT
#include "server/session/client_update_section.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

void ClientUpdateSection::append(const FramePtr&, Clock::time_point, SnapshotParts& parts) {
    std::uint32_t sequence = sent_sequence_;
    std::int64_t margin_us = 0;
    for (const InputResult& result : inputs_.results()) {
        sequence = std::max(sequence, result.sequence);
        margin_us = result.margin_us.value_or(margin_us);
    }
    ClientUpdate& update = parts.update;
    update.results = inputs_.results();
    update.echo_client_time_us = inputs_.take_client_time_us();
    update.input_margin_us = clamp_margin(margin_us);
    const std::uint32_t received = inputs_.confirmed(), skipped = schedule_.skipped();
    ASSERT(skipped >= sent_skipped_);
    if (reports_received_ && received != sent_received_)
        update.input_received = sent_received_ = received;
    if (sequence != sent_sequence_) update.input_sequence = sent_sequence_ = sequence;
    if (skipped != sent_skipped_) update.snapshots_skipped = sent_skipped_ = skipped;
}

}  // namespace jostle::server
