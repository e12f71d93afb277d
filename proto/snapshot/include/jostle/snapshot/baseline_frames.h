// SPDX-License-Identifier: MIT
//
// Encodes the baseline frames of a snapshot as the single number Snapshot.baselines (WIRE.md,
// "Frame encoding"). Pure functions; any thread.
#pragma once

#include <compare>
#include <cstdint>

#include "jostle/base/result.h"
#include "jostle/snapshot/entity_state.h"

namespace jostle::snapshot {

/// Frame numbers; 0: none. baseline2 requires baseline, baseline3 requires baseline2. They descend,
/// by 1 to baseline_distance_max each.
struct BaselineFrames {
    std::uint32_t baseline = 0, baseline2 = 0, baseline3 = 0;

    auto operator<=>(const BaselineFrames&) const = default;
};

inline constexpr std::uint32_t baseline_distance_max = 254;

/// Omits baselines whose spacing makes products of the prediction exceed 2^53, which a browser
/// cannot compute exactly: with fine rotations, dt1 is at most 50 dt2 (WIRE.md, "Prediction").
BaselineFrames predictable(std::uint32_t frame, const BaselineFrames& baselines,
                           const QuantSpec& spec);

/// Returns 0 without a baseline. The distances must be at most baseline_distance_max.
std::uint32_t encode_baseline_frames(std::uint32_t frame, const BaselineFrames& baselines);
/// Returns corrupt_data if a baseline would be before frame 1 or if the number is malformed.
Result<BaselineFrames> decode_baseline_frames(std::uint32_t frame, std::uint32_t code);

}  // namespace jostle::snapshot
