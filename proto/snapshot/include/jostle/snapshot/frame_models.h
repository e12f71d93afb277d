// SPDX-License-Identifier: MIT
//
// The models of codec 2, against which the bits of a frame are coded. Every frame starts from
// start_models(), so frames do not depend on each other. The order of the fields below is the order
// of WIRE.md, "Codec 2".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "jostle/snapshot/range_coder.h"

namespace jostle::snapshot {

/// Models of a signed number: is it nonzero, negative, above 1, above 3, and odd (2 or 3).
struct MagnitudeModels {
    BitModel nonzero, negative, above_1, above_3, odd;
};
/// Shared models of numbers above 3: is it above 7, 15, 31, ..., and the bit below the leading one.
struct TailModels {
    static constexpr unsigned first_width = 2, last_width = 14;  ///< bits below the leading one
    BitModel wider[last_width - first_width], second[last_width - first_width + 1];
};
/// A count or a gap: its width in unary.
struct CountModels {
    static constexpr unsigned widths = 40;
    BitModel wider[widths];
};

struct FrameModels {
    BitModel changes_entities;  ///< any entity is removed or spawned
    CountModels removed, removed_gap, spawned, id_gap, position_step[3];
    BitModel position_negative, turned, spawned_at_rest;

    BitModel none_wake;  ///< no further entity at rest in the baseline changes
    CountModels resting_run;
    BitModel stays_at_rest;

    /// For entities that are awake in the baseline; the first index is the PriorMotion
    /// (range_frame_serializer.h).
    BitModel changes[3], falls_asleep[3][2];
    /// Indices: step in the baseline, whether it is the y axis, acceleration along the step,
    /// acceleration along the other axes, and error of the previous axes.
    MagnitudeModels position[4][2][7][3][4];
    TailModels position_tail[4];
    BitModel same_largest[4], other_largest[2];
    MagnitudeModels rotation[4][7][3][5];
    TailModels rotation_tail[4];
};

inline constexpr std::size_t frame_model_count = sizeof(FrameModels) / sizeof(BitModel);

inline std::span<BitModel> all_of(FrameModels& models) {
    return {reinterpret_cast<BitModel*>(&models), frame_model_count};
}

/// Initial models: one table for baselines that are one or two ticks old, one for older ones.
const FrameModels& start_models(std::int64_t base_age);

}  // namespace jostle::snapshot
