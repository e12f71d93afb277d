// SPDX-License-Identifier: MIT
//
// What solve_constraints and solve_joints use again from step to step, and leave to integrate_free,
// finalize and update_sleep. A hot index is 1 + the index in the awake set; 0 is what stands still.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/quat.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/joint_levels.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/contact_passes.h"
#include "physics/src/constraints/joints/joint_batches.h"
#include "physics/src/stages/solver/joint_group_scratch.h"

namespace jostle::physics {

// In which axes the solver keeps a body's spin.
enum class SpinAxes : std::uint8_t {
    world,  // the gyroscopic change of spin is spread evenly over the step
    // A gyroscopic body that joints hold and nothing touches: the world's axes, and its inertia
    // follows it by sub-steps.
    world_by_substeps,
    // A gyroscopic body with contacts: the frame in which it stood as the step began and which
    // turns with it. There the inertia is constant, and contacts know it from the start of the step
    // alone: seen with another one, what they do to a thin body would be far too much. Joints turn
    // its spin and its inertia to the world's axes and back (SolverBody::spins_along).
    body,
};

// A body that turns far in a step, and not evenly: what each sub-step needs of it.
struct GyroscopicBody {
    Mat3 axes;         // of the body: at the start of the step; by sub-steps: now
    Quat start, now;   // its rotation; now: of what joints hold
    Vec3 half_change;  // rad/s, in its axes: of a sub-step, of what joints hold
    Vec3 bend;         // PrincipalRatios, if its axes are the principal ones
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

// What a trial of half of the sub-steps keeps (stages/solver/error_trial.h).
struct ErrorTrial {
    std::vector<GraphColour> colours;  // as they were before it
    std::vector<SolverBody> bodies;    // as they were after it, in the task's order
};

// What listeners are shown of a group.
struct ListenedGroup {
    std::vector<std::uint32_t> awake;
    std::vector<BodyId> bodies;
};

struct SolverScratch {
    SolverBodies hot;                      // by hot index
    std::vector<ExternalChange> external;  // by hot index
    BodiesBySet bodies;                    // dynamic bodies with contacts or joints
    BodiesBySet jointed;                   // those of them with joints
    std::vector<std::uint8_t> set_of;  // by awake body: index of its colour set, if it is solved
    std::vector<std::uint32_t> kinematic;  // hot indices of kinematic bodies that the solver reads
    std::vector<std::uint32_t> free;  // awake indices of the other bodies, and all kinematic ones
    // These by the first set of a task.
    std::array<JointLevels, solved_set_count> joints;
    std::array<JointBatches, solved_set_count> joint_batches;
    std::array<std::vector<ColourRun>, solved_set_count> colour_runs;
    std::array<std::vector<std::uint32_t>, solved_set_count> in_fields;  // hot indices
    std::array<ErrorTrial, solved_set_count> trials;
    JointGroupScratch groups;
    std::vector<SpinAxes> spin_axes;         // by hot index
    std::vector<GyroscopicBody> gyroscopic;  // by hot index; filled where spin_axes is not world
    // Groups of bodies whose sub-steps listeners are called for: by the first set; of free bodies.
    std::array<ListenedGroup, solved_set_count> listened;
    std::vector<ListenedGroup> listened_free;
    std::vector<std::uint32_t> free_index;  // by awake body: its place among dynamic free ones
};

}  // namespace jostle::physics
