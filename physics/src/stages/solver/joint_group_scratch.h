// SPDX-License-Identifier: MIT
//
// Scratch data that joint_groups.h reuses from step to step.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/ids.h"
#include "physics/src/constraint_graph/joint_solver_preferences.h"
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/math/principal_axes.h"

namespace jostle::physics {

// A group of bodies. Cached from step to step: its pattern and principal axes remain valid until
// the group changes.
struct JointGroup {
    DirectGroup solver;
    std::vector<std::uint32_t> joints;  // in ascending order
    std::vector<std::uint32_t> bodies;  // by number in the group: body index
    std::vector<PrincipalAxes> axes;
    int substeps = 0;
};

struct JointGroupScratch {
    std::vector<std::unique_ptr<JointGroup>> of_island;  // indexed by island
    std::vector<std::uint32_t> active;  // islands, in ascending order, that form such groups
    std::vector<std::uint8_t> refused;  // indexed by island
    std::vector<JointSolverPreferences> preferences;  // indexed by island: of its joints
    std::vector<std::uint8_t>
        left_to_iterative;                // indexed by island: unless the joints request more
    std::vector<std::uint8_t> grouped;    // indexed by awake body: whether it is in a group
    std::vector<std::uint32_t> awake;     // awake indices of the bodies of all groups
    std::vector<FreeMotion> motions;      // of those bodies
    std::vector<std::size_t> first;       // by active group: its first entry in motions
    std::vector<std::int32_t> number_of;  // by body: number in its group, or -1
};

}  // namespace jostle::physics
