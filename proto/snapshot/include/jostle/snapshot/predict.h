// SPDX-License-Identifier: MIT
//
// Where a body should be, from up to three earlier frames. WIRE.md has the formulas. Integers only,
// and every product stays below 2^53, so that C++ and JavaScript agree to the bit. With M above 511
// that takes dt1 <= 50 dt2.
#pragma once

#include <array>
#include <cstdint>

#include "jostle/snapshot/entity_state.h"

namespace jostle::wire {

// The components that are sent when one is left out.
inline constexpr std::uint8_t others[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

// Ticks between the frames: 1 to 255, and 1 where a frame is missing.
struct Spacing {
    std::int64_t dt1 = 1, dt2 = 1,
                 dt3 = 1;  // frame - base, base - baseline2, baseline2 - baseline3
};

struct Prediction {
    std::array<std::int64_t, 3> position{};
    // x, y, z, w in units of 1 / (M sqrt 2), not normalised.
    std::array<std::int64_t, 4> rotation{};
    std::uint8_t largest = 0;  // index of the largest of those
    // The other three, as EntityState::rotation would have them.
    std::array<std::int64_t, 3> components{};
    // The last step, and how much it differed from the one before, which tells how large the
    // difference from the true pose will be. A turn too large to predict from counts as no step.
    std::array<std::int64_t, 3> position_step{}, position_acceleration{};
    std::array<std::int64_t, 4> rotation_step{}, rotation_acceleration{};
    // Sums of the magnitudes of both bends; of a rotation without its largest component.
    std::int64_t position_change = 0, rotation_change = 0;
};

// baseline2 and baseline3 may be null; baseline3 is used only with baseline2. What is at rest in
// base is predicted to stay.
Prediction predict(const EntityState& baseline, const EntityState* baseline2,
                   const EntityState* baseline3, const Spacing& spacing, const QuantSpec& spec);

// Nearest integer to a / b, halves away from zero; b > 0.
inline std::int64_t divide_rounded(std::int64_t a, std::int64_t b) {
    return a >= 0 ? (a + b / 2) / b : -((-a + b / 2) / b);
}

}  // namespace jostle::wire
