// SPDX-License-Identifier: MIT
//
// How hard the solver works on each island, and how exact that is: World::island_substeps().
#pragma once

#include "jostle/physics/ids.h"

namespace jostle::physics {

// An awake island whose bodies have contacts or joints.
struct IslandSubsteps {
    BodyId body;                               // the first of its bodies, by id
    int bodies = 0, contacts = 0, joints = 0;  // contacts: manifolds that touch
    bool direct = false;      // its joints were solved at once, as nothing touches it
    int substeps = 0;         // in the next step, but for what that finds first
    int target_substeps = 0;  // more than that only where the budget falls short
    // m: how far, in a second of steps like the last that was measured, it leads from where
    // endlessly many sub-steps would: an estimate. 0: not known, as in a world without a tolerance.
    double error = 0;
};

}  // namespace jostle::physics
