// SPDX-License-Identifier: MIT
//
// Converts poses to integers and back. The error of a position component is at most half a unit
// (0.98 mm at 512 per metre), that of a rotation at most sqrt(6) / M rad (0.28 degrees at M = 511).
#pragma once

#include "jostle/snapshot/entity_state.h"

namespace jostle::snapshot {

struct Pose {
    std::array<double, 3> position{};            ///< m
    std::array<double, 4> rotation{0, 0, 0, 1};  ///< x y z w, unit
};

/// Quantizes a pose. The result is always valid: positions are clamped to the int32 range, a
/// non-finite component becomes 0, and an invalid rotation becomes the identity.
EntityState quantize(std::uint32_t id, const Pose& pose, bool at_rest, const QuantSpec& spec);

Pose dequantize(const EntityState& state, const QuantSpec& spec);

}  // namespace jostle::snapshot
