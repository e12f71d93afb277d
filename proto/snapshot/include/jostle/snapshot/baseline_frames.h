// SPDX-License-Identifier: MIT
//
// Which earlier frames a snapshot is told against, as the one number that Snapshot.bases holds
// (WIRE.md, "A frame"). Pure functions; any thread.
#pragma once

#include <compare>
#include <cstdint>

#include "jostle/base/result.h"

namespace jostle::wire {

// Frame numbers, 0: none. baseline2 only with base, baseline3 only with baseline2; they fall, each
// by 1 to baseline_distance_max.
struct BaselineFrames {
    std::uint32_t baseline = 0, baseline2 = 0, baseline3 = 0;

    auto operator<=>(const BaselineFrames&) const = default;
};

inline constexpr std::uint32_t baseline_distance_max = 254;

// 0: no base. The bases are within reach of the frame and of each other.
std::uint32_t encode_baseline_frames(std::uint32_t frame, const BaselineFrames& baselines);
// corrupt_data: a base would be before frame 1, or the number has other bits.
Result<BaselineFrames> decode_baseline_frames(std::uint32_t frame, std::uint32_t code);

}  // namespace jostle::wire
