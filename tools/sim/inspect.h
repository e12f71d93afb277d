// SPDX-License-Identifier: MIT
//
// jostle-sim --inspect: what the next step has to solve for the bodies of a scene, taken apart and
// solved in many ways.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jostle/analysis/analysis.h"
#include "jostle/analysis/methods.h"
#include "jostle/analysis/preconditioning.h"
#include "jostle/scenes/scene.h"

namespace jostle::sim {

struct InspectOptions {
    std::string body = "all";  // a name, a place in the scene, or "all"
    physics::ConstraintSystemOptions rows;
    linear_systems::SolverLimits limits;
};

// What hangs together.
struct InspectedGroup {
    std::vector<std::string> bodies;  // that move
    std::string unavailable_reason;   // why there is no more; empty: there is
    physics::ConstraintSystem system;
    linear_systems::Problem problem;  // rows by the names of joints and bodies
    linear_systems::Analysis analysis;
    // By all methods, and treated, where one group was asked for; else by projected sweeps alone.
    std::vector<linear_systems::Solution> solutions;
    std::vector<linear_systems::PreconditioningResult> evaluate_preconditioning;

    // Directions in which the bodies can go on as they like, of how many they would have alone.
    // None where rows give way or push one way.
    std::optional<int> free_motions() const;
    int motions() const;
    // That which keeps to the bounds; without bounds the shortest.
    const linear_systems::Solution* best() const;
};

struct Inspection {
    std::string scene;
    std::uint64_t step = 0;
    double time = 0;  // s
    std::vector<InspectedGroup> groups;
};

// An error when the body is none of the scene's, or nothing is solved for it.
physics::Result<Inspection> inspect(const scenes::SceneDescription& scene,
                                    const scenes::BuiltScene& built, const InspectOptions& options);

}  // namespace jostle::sim
