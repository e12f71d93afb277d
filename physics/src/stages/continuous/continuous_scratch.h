// SPDX-License-Identifier: MIT
//
// What solve_continuous uses again from step to step, and leaves to place_toi_bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "stages/continuous/toi_body.h"

namespace jostle::physics {

struct ContinuousScratch {
    std::vector<std::vector<std::uint32_t>> ahead;  // by fast body: shapes that it may meet
    std::vector<ToiBody> changed;                   // those that an impact sent another way
};

}  // namespace jostle::physics
