// SPDX-License-Identifier: MIT
//
// Scratch data that solve_constraints and solve_joints reuse from step to step and leave to
// integrate_free, finalize and update_sleep. A hot index is 1 + the index in the awake set; 0 is
// the immovable body.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/quat.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/gyroscopic_wide.h"
#include "physics/src/constraint_graph/joint_levels.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/contact_group/contact_group.h"
#include "physics/src/constraints/contact_passes.h"
#include "physics/src/constraints/joints/joint_batches.h"
#include "physics/src/stages/solver/joint_group_scratch.h"
#include "physics/src/stages/solver/limited_groups.h"

namespace jostle::physics {

// The axes in which the solver stores a body's spin.
enum class SpinAxes : std::uint8_t {
    world,  // the gyroscopic spin change is spread evenly over the step
    // For a gyroscopic body with joints and without contacts: world axes, with the inertia updated
    // in each sub-step.
    world_by_substeps,
    // For a gyroscopic body with contacts: body-fixed axes that coincide with the world axes at the
    // start of the step. The inertia is constant in them, and contacts only know the inertia at the
    // start of the step: with a different inertia, their effect on a thin body would be far too
    // large. Joints transform spin and inertia to world axes and back (SolverBody::spins_along).
    body,
};

// The gyroscopic bodies of a task: those whose spin axes are not `world`.
struct GyroscopicBodies {
    std::vector<GyroscopicWide> jointed, others;
    std::vector<std::uint32_t> hot[2];  // scratch memory
};

// Hot indices of bodies, grouped by colour set.
struct BodiesBySet {
    std::vector<std::uint32_t> all;
    std::array<std::uint32_t, solved_set_count + 1> begin{};

    std::span<const std::uint32_t> of(std::size_t first, std::size_t last) const {  // sets
        return std::span(all).subspan(begin[first], begin[last] - begin[first]);
    }
};

// Data of a trial with half of the sub-steps (stages/solver/error_trial.h).
struct ErrorTrial {
    std::vector<GraphColour> colours;  // before the trial
    std::vector<SolverBody> bodies;    // after the trial, in the task's order
};

// The contact groups of a task of SolverTier::direct. They keep their memory from step to step.
struct ContactGroups {
    std::vector<ContactGroup> all;
    std::vector<std::uint32_t> lowest;  // by group, the hot index of its lowest body
    std::size_t used = 0;
    int passes = 0, unsolved = 0;  // unsolved: passes in which a group missed its tolerance

    std::span<ContactGroup> groups() { return std::span(all).first(used); }
};

// A group of bodies as passed to listeners.
struct ListenedGroup {
    std::vector<std::uint32_t> awake;
    std::vector<BodyId> bodies;
};

struct SolverScratch {
    SolverBodies hot;                      // indexed by hot index
    std::vector<ExternalChange> external;  // indexed by hot index
    BodiesBySet bodies;                    // dynamic bodies with contacts or joints
    BodiesBySet jointed;                   // the subset with joints
    std::vector<std::uint8_t> set_of;  // by awake body: index of its colour set, if it is solved
    std::vector<std::uint32_t> kinematic;  // hot indices of kinematic bodies that the solver reads
    std::vector<std::uint32_t>
        free;  // awake indices of the other bodies, and of all kinematic ones
    // Indexed by the first set of a task.
    std::array<JointLevels, solved_set_count> joints;
    std::array<JointBatches, solved_set_count> joint_batches;
    std::array<LimitedGroups, solved_set_count> limited;
    std::vector<std::unique_ptr<LimitedGroup>> limited_groups;  // by the lowest joint of a group
    std::array<std::vector<ColourRun>, solved_set_count> colour_runs;
    std::array<std::vector<std::uint32_t>, solved_set_count> in_fields;  // hot indices
    std::array<ErrorTrial, solved_set_count> trials;
    std::array<ContactGroups, solved_set_count> contact_groups;  // of tasks of SolverTier::direct
    std::vector<std::uint32_t> unsolved;  // a body of each group without a solution
    JointGroupScratch groups;
    std::vector<SpinAxes> spin_axes;                            // indexed by hot index
    std::array<GyroscopicBodies, solved_set_count> gyroscopic;  // by the first set of a task
    // Groups of bodies for which sub-step listeners are called: by the first set; of free bodies.
    std::array<ListenedGroup, solved_set_count> listened;
    std::vector<ListenedGroup> listened_free;
    std::vector<std::uint32_t> free_index;  // by awake body: its index among dynamic free bodies
};

}  // namespace jostle::physics
