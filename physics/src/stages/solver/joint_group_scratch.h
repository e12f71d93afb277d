// SPDX-License-Identifier: MIT
//
// What joint_groups.h uses again from step to step.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/ids.h"
#include "physics/src/constraint_graph/joint_solver_preferences.h"
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/direct/principal_axes.h"
#include "physics/src/constraints/free_motion.h"

namespace jostle::physics {

// A group of bodies. Kept from step to step: its pattern and principal axes are those of the step
// before unless something about it changed.
struct JointGroup {
    DirectGroup solver;
    std::vector<std::uint32_t> joints;  // in order
    std::vector<std::uint32_t> bodies;  // by number in the group: body index
    std::vector<Mat3> inertias;         // of which `axes` are
    std::vector<PrincipalAxes> axes;
    int substeps = 0;
};

struct JointGroupScratch {
    std::vector<std::unique_ptr<JointGroup>> of_island;  // by island
    std::vector<std::uint32_t> active;                   // islands, in order, that are such groups
    std::vector<std::uint8_t> refused;                   // by island
    std::vector<JointSolverPreferences> preferences;     // by island: of its joints
    std::vector<std::uint8_t> left_to_iterative;         // by island: unless they ask for more
    std::vector<std::uint8_t> grouped;                   // by awake body: is in one
    std::vector<std::uint32_t> awake;                    // bodies of all of them
    std::vector<FreeMotion> motions;                     // of those
    std::vector<std::size_t> first;                      // of each active group, in motions
    std::vector<std::int32_t> number_of;                 // by body: number in its group, or -1
};

}  // namespace jostle::physics
