// SPDX-License-Identifier: MIT
//
// Scratch data that solve_continuous reuses from step to step and leaves to move_toi_bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/toi_body.h"

namespace jostle::physics {

struct CenterMotion {
    Vec3 from, to;  // m: of a centre of mass, in a step
};

struct ContinuousScratch {
    // Data of find_sweep_candidates.
    std::vector<CenterMotion> center_motions;  // by body; valid for awake bodies
    std::vector<std::uint32_t> fast_body;      // by body: index among the fast bodies, or none
    std::vector<std::uint32_t> with_manifold;  // contact indices
    std::vector<std::uint8_t>
        ends;  // by bound or contact: which of its fast bodies may hit the other
    // By fast body: shapes that it may hit.
    std::vector<std::vector<std::uint32_t>> sweep_candidates;
    // By fast body: pair_key() of the shapes of its manifolds.
    std::vector<std::vector<std::uint64_t>> manifolds;

    std::vector<ToiBody> changed;  // bodies deflected by impacts
};

}  // namespace jostle::physics
