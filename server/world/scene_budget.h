// SPDX-License-Identifier: MIT
//
// May this scene be hosted? A few bytes can ask for a world that takes minutes for a step, or for
// one of which each client must be told a gigabyte. Pure functions; any thread.
#pragma once

#include <cstddef>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::server {

struct SceneBudget {
    int bodies_max = 20000;
    int joints_max = 20000;
    int joints_per_pair_max = 64;         // of the same two bodies: they are solved one by one
    double geometry_bytes_max = 32e6;     // of what clients are told about shapes, each kept once
    int body_geometry_bytes_max = 65536;  // of the small shapes of one body
    // Solver visits a second: rate x sub-steps x (moving bodies + joints + pairs of shapes whose
    // boxes overlap). A core makes some tens of millions.
    double work_per_second_max = 2e8;
    // What the estimate does not see (triangles and compounds in one place, a joint net that is
    // solved at once) shows in the first step.
    double first_step_seconds_max = 0.5;
};

// Of the description, before it is built. An error names the figure, the limit and its setting.
Status check_description(const scenes::SceneDescription& scene, const SceneBudget& budget);
// Of the world that was built of it, before its first step, whose time goes with the pairs. Solver
// visits a second.
Result<double> estimate_work(const scenes::SceneDescription& scene, const physics::World& world,
                             const SceneBudget& budget);
// Steps a world that is thrown away.
Status check_first_step(const scenes::SceneDescription& scene, physics::World world,
                        const SceneBudget& budget);

}  // namespace jostle::server
