// SPDX-License-Identifier: MIT
//
// The models of codec 2, against which the bits of a frame are coded. Every frame starts from
// start_models(), so frames do not depend on each other. The order of the fields below is the order
// of WIRE.md, "Codec 2".
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "jostle/snapshot/range_numbers.h"

namespace jostle::snapshot {

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

/// The initial model that a letter of a table stands for (WIRE.md, "Initial models").
BitModel model_of_letter(char letter);

/// Initial models: one table for baselines that are one or two ticks old, one for older ones.
const FrameModels& start_models(std::int64_t base_age);

}  // namespace jostle::snapshot
