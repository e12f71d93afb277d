// SPDX-License-Identifier: MIT
//
// The frames sent to one client over its stream. The stream is reliable and ordered, so the last
// frame sent is a baseline that the client will have when needed, without an acknowledgement.
// Clients of the same cadence class have the same baselines and share encoded snapshots.
#pragma once

#include <cstddef>
#include <cstdint>

#include "jostle/snapshot/baseline_frames.h"
#include "server/util/fifo.h"

namespace jostle::server {

class BaselineTracker {
public:
    // decoded frames that a client stores (WIRE.md)
    static constexpr std::size_t client_frames_max = 32;

    // The baselines for the next frame: the last frame sent, and two older ones spaced about as far
    // apart, because extrapolating a long step from a short one would multiply rounding noise. If
    // the gap is at least twice as long as usual, frames at multiples of a step of that length are
    // preferred, which clients with other gaps have, too.
    snapshot::BaselineFrames baselines_for(std::uint32_t frame) const;
    // Whether the client has all of these baselines.
    bool has(const snapshot::BaselineFrames& baselines) const;
    void on_sent(std::uint32_t frame);
    // The client has `frame` and lost those sent after it. Returns false if `frame` is unknown; the
    // next snapshot is then a keyframe.
    bool roll_back_to(std::uint32_t frame);
    // The client lost its state: the next snapshot is a keyframe.
    void reset() { sent_.clear(); }
    std::uint32_t last() const { return sent_.empty() ? 0 : sent_.back(); }

private:
    bool was_sent(std::uint32_t frame) const;
    std::uint32_t newest_multiple(std::uint32_t step, std::uint32_t frame_max) const;

    Fifo<std::uint32_t> sent_;  // ascending; at most as many as the client stores
};

}  // namespace jostle::server
