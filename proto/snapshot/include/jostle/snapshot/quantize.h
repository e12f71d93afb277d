// SPDX-License-Identifier: MIT
//
// Poses to integers and back. A position component is off by at most half a unit (0.98 mm at 512
// per metre), a rotation by at most sqrt(6) / M rad (0.28 degrees at M = 511).
#pragma once

#include "jostle/snapshot/entity_state.h"

namespace jostle::wire {

struct Pose {
    std::array<double, 3> position{};            // m
    std::array<double, 4> rotation{0, 0, 0, 1};  // x y z w, unit
};

// Every state made here can be sent: positions are clamped to the range of int32 units, a component
// that is no number becomes 0, and what is no rotation becomes the identity.
EntityState quantize(std::uint32_t id, const Pose& pose, bool at_rest, const QuantSpec& spec);

Pose dequantize(const EntityState& state, const QuantSpec& spec);

}  // namespace jostle::wire
