// SPDX-License-Identifier: MIT
//
// What solve_constraints and solve_joints use again from step to step, and leave to integrate_free,
// finalize and update_sleep. A hot index is 1 + the index in the awake set; 0 is what stands still.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "constraint_graph/joint_levels.h"
#include "constraint_graph/solver_body.h"
#include "constraints/contact_passes.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"

namespace jostle::physics {

// A body that turns far in a step, and not evenly: what each sub-step needs of it.
struct GyroscopicBody {
    Mat3 axes;  // of the body at the start of the step
    Vec3 bend;  // PrincipalRatios, if its axes are the principal ones
    bool principal = false;
};

// Hot indices of bodies, colour set after colour set.
struct BodiesBySet {
    std::vector<std::uint32_t> all;
    std::array<std::uint32_t, solved_set_count + 1> begin{};

    std::span<const std::uint32_t> of(std::size_t first, std::size_t last) const {  // sets
        return std::span(all).subspan(begin[first], begin[last] - begin[first]);
    }
};

struct SolverScratch {
    HotBodies hot;                         // by hot index
    std::vector<ExternalChange> external;  // by hot index
    BodiesBySet bodies;                    // dynamic bodies with contacts or joints
    BodiesBySet jointed;                   // those of them with joints
    std::vector<std::uint8_t> set_of;  // by awake body: index of its colour set, if it is solved
    std::vector<std::uint32_t> kinematic;  // hot indices of kinematic bodies that the solver reads
    std::vector<std::uint32_t> free;  // awake indices of the other bodies, and all kinematic ones
    // These by the first set of a task.
    std::array<JointLevels, solved_set_count> joints;
    std::array<std::vector<ColourRun>, solved_set_count> colour_runs;
    std::array<std::vector<std::uint32_t>, solved_set_count> in_fields;  // hot indices
    std::vector<std::uint8_t> is_gyroscopic;                             // by hot index
    std::vector<GyroscopicBody> gyroscopic;  // by hot index; filled where is_gyroscopic
    // Of the group of bodies whose sub-step listeners are called for.
    std::vector<std::uint32_t> listened_awake;
    std::vector<BodyId> listened;
    std::vector<std::uint32_t> free_place;  // by awake body: its place among dynamic free ones
};

}  // namespace jostle::physics
