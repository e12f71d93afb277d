// SPDX-License-Identifier: MIT
//
// What one client was sent by its stream. The stream is reliable and ordered, so the last frame put
// on it is a base that the client will have when it needs it; nothing has to be acknowledged first.
// Clients on the same cadence have the same bases and share their bytes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "server/replication/snapshot_cache.h"
#include "server/util/fifo.h"

namespace jostle::server {

class BaselineTracker {
public:
    static constexpr std::size_t client_frames_max = 32;  // decoded frames a client keeps (WIRE.md)

    // The bases for the frame that is to be sent now: the last one sent, and two older ones about
    // as far apart, because extrapolating a short step over a long one multiplies the rounding
    // noise.
    wire::BaselineFrames baselines_for(std::uint32_t frame) const;
    void on_sent(std::uint32_t frame);
    // The client has that frame and forgot those that were sent after it. False: that one is not
    // known, and the next snapshot is absolute.
    bool roll_back_to(std::uint32_t frame);
    // The client lost track: the next snapshot is absolute.
    void reset() { sent_.clear(); }
    std::uint32_t last() const { return sent_.empty() ? 0 : sent_.back(); }

private:
    Fifo<std::uint32_t> sent_;  // rising; at most as many as the client keeps
};

}  // namespace jostle::server
