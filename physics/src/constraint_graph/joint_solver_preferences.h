// SPDX-License-Identifier: MIT
//
// What the joints of a group ask of the solver (jostle/physics/joint_solver.h), and how much a
// group may cost that asks to be solved directly. Pure functions: which groups there are decide
// stages/solver/joint_groups.cpp and constraints/joints/joint_batches.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "jostle/physics/joint_solver.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// The own wishes of some joints: a bit for each JointSolver.
using JointSolverPreferences = std::uint8_t;

inline JointSolverPreferences preference_bit(std::optional<JointSolver> solver) {
    return solver ? static_cast<JointSolverPreferences>(1u << static_cast<unsigned>(*solver))
                  : JointSolverPreferences{0};
}
// By all their wishes together, else the world's.
inline JointSolver solver_of(JointSolverPreferences preferences, JointSolver of_world) {
    for (const JointSolver solver :
         {JointSolver::direct, JointSolver::iterative, JointSolver::automatic})
        if ((preferences & preference_bit(solver)) != 0) return solver;
    return of_world;
}

// Multiplications of one factorisation that each joint of a group may take that asks for `direct`,
// where the world has so many joints: all groups together stay within tuning::max_direct_work,
// whoever made the scene. What a group may take does not depend on which others there are just now.
inline std::int64_t direct_budget(std::size_t joints_of_world) {
    return tuning::max_direct_work /
           static_cast<std::int64_t>(joints_of_world == 0 ? 1 : joints_of_world);
}
// ... and that a group may take: `cubes`, of the joints' rows. `budget`: 0 for those that do not
// ask.
inline std::int64_t max_work(std::int64_t cubes, std::size_t joints, std::int64_t budget) {
    const std::int64_t affordable = tuning::direct_work * cubes;
    const std::int64_t granted = budget * static_cast<std::int64_t>(joints);
    return granted > affordable ? granted : affordable;
}

// By what find_batches() chooses.
struct JointSolverOptions {
    std::span<const JointSolverPreferences>
        preferences;  // by place in JointLevels::joints; empty: none has one
    JointSolver of_world = JointSolver::automatic;
    std::int64_t budget = 0;  // of those that ask for `direct`
};

}  // namespace jostle::physics
