// SPDX-License-Identifier: MIT
//
// Predicts the points of an object from its earlier states (WIRE.md, "Points").
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jostle/snapshot/point_layout.h"
#include "jostle/snapshot/point_state.h"

namespace jostle::snapshot {

/// Predictions in time of all points of a state.
struct PointPredictions {
    std::vector<std::int64_t> values;  ///< like PointState::values; 0 for new points
    /// For each point: the number of earlier states that have it, at most 2.
    std::vector<std::uint8_t> depths;
};

/// Predicts the points of a state by a polynomial of degree 0 to 2 in the number of the state.
/// `previous` is PointState::previous of that state; `count`: its points.
PointPredictions predict_points(std::size_t components, std::uint32_t number, std::size_t count,
                                const std::vector<std::uint32_t>& previous,
                                const PointBaselines& baselines, unsigned degree);

inline constexpr unsigned no_point_degree = 3;  ///< no prediction in time

/// The largest degree for which the baselines suffice.
unsigned point_degree_limit(std::uint32_t number, const PointBaselines& baselines);

/// How an encoder predicts a state.
struct PointPlan {
    PointPredictions predictions;
    unsigned degree = 0;  ///< or no_point_degree
    unsigned scale = 0;   ///< the expected magnitude of the first residuals
};
/// Selects the degree with the smallest residuals.
PointPlan plan_points(const PointLayout& layout, const PointOrder& order, const PointState& state,
                      const PointBaselines& baselines);

}  // namespace jostle::snapshot
