// SPDX-License-Identifier: MIT
//
// Eight bodies that rotate far in a step at a varying rate, one per lane. Floats are relative to
// the orientation at the start of the step.
#pragma once

#include <cstdint>

namespace jostle::physics {

struct alignas(32) GyroscopicWide {
    std::int32_t hot[8];    // 0: the lane is not used
    float by_substeps[8];   // 1: SpinAxes::world_by_substeps; 0: SpinAxes::body
    float principal[4][8];  // orientation of the principal axes at the start of the step
    // (I3 - I2) / I1, (I1 - I3) / I2, (I2 - I1) / I3.
    float bend[3][8];
    float inverse_moments[3][8];  // 1/(kg m^2)
    // For bodies with joints: rotation since the start of the step, and half of the spin change of
    // the sub-step in the axes of the start, rad/s.
    float turned[4][8];
    float half_change[3][8];
};

// A range of blocks.
struct GyroscopicRange {
    GyroscopicWide* blocks;
    int begin, end;
};

}  // namespace jostle::physics
