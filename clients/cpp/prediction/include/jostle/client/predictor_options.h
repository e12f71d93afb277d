// SPDX-License-Identifier: MIT
//
// Limits and statistics of a predictor.
#pragma once

#include <cstddef>
#include <cstdint>

namespace jostle::client {

/// Options of a Predictor.
struct PredictorOptions {
    /// m, between origins: dynamic bodies within this distance of the followed one are predicted
    double neighbor_radius_m = 3;
    std::size_t neighbors_max = 32;  ///< maximum number of predicted neighbours; the closest ones
    /// Maximum number of static and kinematic bodies; those with the lowest ids.
    std::size_t static_bodies_max = 1000;
    /// Maximum number of ticks predicted beyond the newest frame. While nothing moves, the server
    /// sends one frame per second.
    std::uint32_t ticks_ahead_max = 120;
    /// for worlds that choose sub-steps per island; other worlds report their number
    int substeps = 8;
};

/// Statistics of a Predictor.
struct PredictorStats {
    std::uint64_t frames = 0;       ///< compared frames
    std::uint64_t corrections = 0;  ///< compared frames that differed from the prediction
    std::uint64_t steps = 0;        ///< simulated steps, including repeated ones
    double last_error_m = 0;        ///< largest error of the last frame before the correction, m
    std::uint64_t control_updates = 0;      ///< compared states of the controlled entity
    std::uint64_t control_corrections = 0;  ///< compared states that differed from the prediction
    double last_control_error_m = 0;        ///< error of the last one, m
};

}  // namespace jostle::client
