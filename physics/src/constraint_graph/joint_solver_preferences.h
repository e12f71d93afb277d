// SPDX-License-Identifier: MIT
//
// Solver preferences of the joints of a group (jostle/physics/joint_solver.h), and the cost limit
// of a group that requests the direct solver. Pure functions. stages/solver/joint_groups.cpp and
// constraints/joints/joint_batches.cpp form the groups.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "jostle/base/check.h"
#include "jostle/physics/joint_solver.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// The union of the preferences of some joints: one bit per JointSolver.
using JointSolverPreferences = std::uint8_t;

inline JointSolverPreferences preference_bit(std::optional<JointSolver> solver) {
    return solver ? static_cast<JointSolverPreferences>(1u << static_cast<unsigned>(*solver))
                  : JointSolverPreferences{0};
}
// The solver for the combined preferences, or the world's solver if there are none.
inline JointSolver solver_of(JointSolverPreferences preferences, JointSolver of_world) {
    for (const JointSolver solver :
         {JointSolver::direct, JointSolver::iterative, JointSolver::automatic})
        if ((preferences & preference_bit(solver)) != 0) return solver;
    return of_world;
}

// Maximum multiplications of one factorisation per joint of a group that requests `direct`. Depends
// only on the number of joints in the world: all groups together stay within
// tuning::max_direct_work for any scene, and the limit of a group does not depend on the other
// current groups.
inline std::int64_t direct_budget(std::size_t joints_of_world) {
    return tuning::max_direct_work /
           static_cast<std::int64_t>(joints_of_world == 0 ? 1 : joints_of_world);
}
// Maximum multiplications for a group. `cubes`: sum of the cubes of the joints' row counts.
// `budget`: direct_budget(), or 0 for groups without a request.
inline std::int64_t max_work(std::int64_t cubes, std::size_t joints, std::int64_t budget) {
    const std::int64_t affordable = tuning::direct_work * cubes;
    ASSERT(cubes >= 0 && budget >= 0);
    const std::int64_t granted = budget * static_cast<std::int64_t>(joints);
    return granted > affordable ? granted : affordable;
}

// Options for find_batches().
struct JointSolverOptions {
    // Indexed like JointLevels::joints. Empty if no joint has a preference.
    std::span<const JointSolverPreferences> preferences;
    JointSolver of_world = JointSolver::automatic;
    std::int64_t budget = 0;  // per joint that requests `direct`
    // Indexed like JointLevels::joints: whether it connects a body that may not move along some
    // axis. Empty if none does.
    std::span<const std::uint8_t> locked = {};
};

}  // namespace jostle::physics
