// SPDX-License-Identifier: MIT
//
// What a predictor may spend, and what it did.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jostle::client {

struct PredictorOptions {
    double neighbor_radius_m = 3;    // how far from the body others are foreseen, between origins
    std::size_t neighbors_max = 32;  // of these the nearest
    std::size_t static_bodies_max =
        1000;  // bodies that stand still or move on rails; the first by id
    // Further than this beyond the newest frame nothing is foreseen. A world in which nothing moves
    // sends a frame a second.
    std::uint32_t ticks_ahead_max = 120;
    int substeps = 8;  // of a world whose islands choose theirs; others say how many they take
};

struct PredictorStats {
    std::uint64_t frames = 0;               // that were compared
    std::uint64_t corrections = 0;          // of them: that were not what was foreseen
    std::uint64_t steps = 0;                // that were taken, again or not
    double last_error_m = 0;                // greatest of the last frame, before it was corrected
    std::uint64_t control_updates = 0;      // times that what is driven was told and compared
    std::uint64_t control_corrections = 0;  // of them: that were not what was foreseen
    double last_control_error_m = 0;        // of the last one
};

}  // namespace jostle::client
