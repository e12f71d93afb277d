// SPDX-License-Identifier: MIT
//
// The frames sent to one client over any transport, and those it acknowledged as decoded: baselines
// for snapshots that may be lost. A client stores the last 32 decoded frames, so it still has every
// acknowledged frame among the last 32 sent.
//
// Threads: one thread at a time.
#pragma once

#include <cstdint>

#include "server/replication/baseline_tracker.h"
#include "server/util/fifo.h"

namespace jostle::server {

class AckedFrames {
public:
    void on_sent(std::uint32_t frame, bool by_datagram = true);
    // The client decoded `frame` and, for each bit k of `ack_bits`, the frame - 1 - k. Frames that
    // were never sent are ignored. Returns true if this newly acknowledges a frame sent by
    // datagram.
    bool on_ack(std::uint32_t frame, std::uint32_t ack_bits);
    // The client lost its state: no frame is available as a baseline.
    void reset() { sent_.clear(); }

    // The newest acknowledged frame; 0: none can be a baseline.
    std::uint32_t newest() const;
    std::uint32_t last_sent() const { return last_sent_; }
    // The acknowledged frames, as if nothing else had been sent.
    BaselineTracker known() const;
    snapshot::BaselineFrames baselines_for(std::uint32_t frame) const {
        return known().baselines_for(frame);
    }

private:
    struct Sent {
        std::uint32_t frame;
        bool by_datagram;
        bool acked = false;
    };
    std::uint32_t last_sent_ = 0;
    Fifo<Sent> sent_;  // ascending; at most as many as the client stores
};

}  // namespace jostle::server
