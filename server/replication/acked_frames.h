// SPDX-License-Identifier: MIT
//
// What one client was sent by whatever way, and which of it it said that it decoded: bases for
// snapshots that may get lost. A client keeps the last 32 frames that it decoded, so of the last 32
// that were sent it has all that it acknowledged.
//
// Thread rule: one thread at a time.
#pragma once

#include <cstdint>

#include "server/replication/baseline_tracker.h"
#include "server/util/fifo.h"

namespace jostle::server {

class AckedFrames {
public:
    void on_sent(std::uint32_t frame, bool by_datagram = true);
    // The client decoded that frame and, for each bit k, the frame - 1 - k. What was never sent
    // counts for nothing. True: that is news of one that went by datagram.
    bool on_ack(std::uint32_t frame, std::uint32_t before);
    // The client lost track: nothing that it has counts any more.
    void reset() { sent_.clear(); }

    // The newest frame that the client said it has; 0: none that can be a base.
    std::uint32_t newest() const;
    std::uint32_t last_sent() const { return last_sent_; }
    // What it has, as if it had been sent nothing else.
    BaselineTracker known() const;
    wire::BaselineFrames baselines_for(std::uint32_t frame) const {
        return known().baselines_for(frame);
    }

private:
    struct Sent {
        std::uint32_t frame;
        bool by_datagram;
        bool acked = false;
    };
    std::uint32_t last_sent_ = 0;
    Fifo<Sent> sent_;  // rising; at most as many as the client keeps
};

}  // namespace jostle::server
