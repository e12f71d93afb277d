// SPDX-License-Identifier: MIT
//
// The models of codec 2: what each bit of a frame is coded against. They begin every frame as
// start_models() has them, so that frames do not depend on each other. WIRE.md, "Codec 2", has
// their order, which is that of the fields below.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "jostle/snapshot/range_coder.h"

namespace jostle::wire {

// A signed number: is it 0, is it negative, is it above 1, is it above 3, and which of 2 and 3.
struct MagnitudeModels {
    BitModel nonzero, negative, above_1, above_3, odd;
};
// What numbers above 3 share: is it above 7, 15, 31 ..., and the bit below the leading one.
struct TailModels {
    static constexpr unsigned first_width = 2, last_width = 14;  // bits below the leading one
    BitModel wider[last_width - first_width], second[last_width - first_width + 1];
};
// A count or a gap: its width in unary.
struct CountModels {
    static constexpr unsigned widths = 40;
    BitModel wider[widths];
};

struct FrameModels {
    BitModel changes_entities;  // is anything removed or spawned
    CountModels removed, removed_gap, spawned, id_gap, position_step[3];
    BitModel position_negative, turned, spawned_at_rest;

    BitModel none_wake;  // of those at rest in base, none changes any more
    CountModels resting_run;
    BitModel stays_at_rest;

    // Of what is awake in base; the first index is its Pace (range_frame.cpp).
    BitModel changes[3], falls_asleep[3][2];
    // Step in base, is it the y axis, how the step bent along its own direction, along the other
    // axes, and what the axes before it were off by.
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

// How they begin: one table for bases one or two ticks back, one for older ones.
const FrameModels& start_models(std::int64_t base_age);

}  // namespace jostle::wire
