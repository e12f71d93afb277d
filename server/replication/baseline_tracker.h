// SPDX-License-Identifier: MIT
//
// The frames sent to one client over its stream. The stream is reliable and ordered, so the last
// frame sent is a baseline that the client will have when needed, without an acknowledgement.
// Clients with the same rate have the same baselines and share encoded snapshots.
#pragma once

#include <cstddef>
#include <cstdint>

#include "server/replication/snapshot_cache.h"
#include "server/util/fifo.h"

namespace jostle::server {

class BaselineTracker {
public:
    // decoded frames that a client stores (WIRE.md)
    static constexpr std::size_t client_frames_max = 32;

    // The baselines for the next frame: the last frame sent, and two older ones spaced about as far
    // apart, because extrapolating a long step from a short one would multiply rounding noise.
    snapshot::BaselineFrames baselines_for(std::uint32_t frame) const;
    void on_sent(std::uint32_t frame);
    // The client has `frame` and lost those sent after it. Returns false if `frame` is unknown; the
    // next snapshot is then a keyframe.
    bool roll_back_to(std::uint32_t frame);
    // The client lost its state: the next snapshot is a keyframe.
    void reset() { sent_.clear(); }
    std::uint32_t last() const { return sent_.empty() ? 0 : sent_.back(); }

private:
    Fifo<std::uint32_t> sent_;  // ascending; at most as many as the client stores
};

}  // namespace jostle::server
