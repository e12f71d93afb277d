// SPDX-License-Identifier: MIT
//
// Groups of bodies that joints tie together and nothing touches. They are solved directly, apart
// from the solver's colours and levels: constraints/direct/direct_group.h.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "constraints/direct/direct_group.h"
#include "constraints/direct/principal_axes.h"
#include "constraints/free_motion.h"
#include "jostle/physics/ids.h"

namespace jostle::physics {

struct StepContext;

// One group. Kept from step to step: its pattern and principal axes are those of the step before
// unless something about it changed.
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
    std::vector<std::uint8_t> grouped;                   // by awake body: is in one
    std::vector<std::uint32_t> awake;                    // bodies of all of them
    std::vector<FreeMotion> motions;                     // of those
    std::vector<std::size_t> first;                      // of each active group, in motions
    std::vector<std::int32_t> number_of;                 // by body: number in its group, or -1
};

// Finds the groups of this step: islands with joints of kinds that they know, none of whose bodies
// has a contact. Before solve_constraints() sorts out the others.
void find_joint_groups(StepContext& step);
// Moves them through the step. Leaves motions for integrate_free, and what acted in the joints.
void solve_joint_groups(StepContext& step);

}  // namespace jostle::physics
