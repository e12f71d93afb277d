// SPDX-License-Identifier: MIT
//
// jostle-sim --inspect: the constraint systems that the next step solves for the bodies of a scene,
// analysed and solved with several methods.
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
    std::string body = "all";  // a name, an index in the scene, or "all"
    physics::ConstraintSystemOptions rows;
    analysis::SolverLimits limits;
};

// Bodies connected by joints and touching contacts.
struct InspectedGroup {
    std::vector<std::string> bodies;  // that move
    std::string unavailable_reason;   // why there is no system; empty: there is one
    physics::ConstraintSystem system;
    analysis::Problem problem;  // rows named after joints and bodies
    analysis::Analysis analysis;
    // Of all methods, with preconditioning, if there is one group; otherwise of projected
    // Gauss-Seidel only.
    std::vector<analysis::Solution> solutions;
    std::vector<analysis::PreconditioningResult> preconditioning;

    // Remaining degrees of freedom of the bodies. Nothing if rows are soft or unilateral.
    std::optional<int> free_motions() const;
    int motions() const;
    // The solution that respects the bounds; without bounds the one of minimum norm.
    const analysis::Solution* best() const;
};

struct Inspection {
    std::string scene;
    std::uint64_t step = 0;
    double time = 0;  // s
    std::vector<InspectedGroup> groups;
};

// Returns an error if the scene has no such body or no system is solved for it.
physics::Result<Inspection> inspect(const scenes::SceneDescription& scene,
                                    const scenes::BuiltScene& built, const InspectOptions& options);

}  // namespace jostle::sim
