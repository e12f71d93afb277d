// SPDX-License-Identifier: MIT
//
// Solver effort and estimated error per island (World::island_substeps()).
#pragma once

#include "jostle/physics/ids.h"

namespace jostle::physics {

/// Sub-steps and error of one awake island whose bodies have contacts or joints.
struct IslandSubsteps {
    BodyId body;  ///< the body of the island with the lowest id
    /// Counts of bodies, touching manifolds and joints.
    int bodies = 0, contacts = 0, joints = 0;
    bool direct = false;      ///< its joints were solved directly, because nothing touches it
    int substeps = 0;         ///< sub-steps in the next step, unless the island changes before
    int target_substeps = 0;  ///< larger than `substeps` only if the sub-step budget is exhausted
    /// Estimated error in m: distance between the island's bodies and the converged solution after
    /// one second of steps like the last measured one. 0 if unknown, as in a world without a
    /// tolerance.
    double error = 0;
};

}  // namespace jostle::physics
