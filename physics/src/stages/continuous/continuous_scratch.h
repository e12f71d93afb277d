// SPDX-License-Identifier: MIT
//
// What solve_continuous uses again from step to step, and leaves to move_toi_bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/toi_body.h"

namespace jostle::physics {

struct CenterMotion {
    Vec3 from, to;  // m: of a centre of mass, in a step
};

struct ContinuousScratch {
    // Of find_sweep_candidates.
    std::vector<CenterMotion> center_motions;  // by body; of awake ones
    std::vector<std::uint32_t> fast_body;      // by body: which fast body it is, or none
    std::vector<std::uint32_t> with_manifold;  // contacts
    std::vector<std::uint8_t> ends;            // by bound or contact: whose fast bodies may meet
    std::vector<std::vector<std::uint32_t>>
        sweep_candidates;  // by fast body: shapes that it may meet
    // By fast body: pair_key() of the shapes of its manifolds.
    std::vector<std::vector<std::uint64_t>> manifolds;

    std::vector<ToiBody> changed;  // those that an impact sent another way
};

}  // namespace jostle::physics
