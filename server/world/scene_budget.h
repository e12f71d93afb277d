// SPDX-License-Identifier: MIT
//
// Decides whether a server hosts a scene. A scene file of a few bytes can describe a world whose
// steps take minutes, or whose geometry is a gigabyte for each client. Pure functions; any thread.
#pragma once

#include <cstddef>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::server {

struct SceneBudget {
    int bodies_max = 20000;
    int joints_max = 20000;
    int joints_per_pair_max = 64;         // between the same two bodies; solved sequentially
    double geometry_bytes_max = 32e6;     // encoded geometry for a client; shared geometry once
    int body_geometry_bytes_max = 65536;  // encoded inline geometry of one body
    // Constraint visits of the solver per second: rate x sub-steps x (moving bodies + joints +
    // pairs of shapes with overlapping bounding boxes). One core performs some 10 million.
    double work_per_second_max = 2e8;
    // physics::WorldDef::max_pairs_per_shape. Limits what a running world adds to the estimate.
    int pairs_per_shape_max = 16;
    // Limits the costs that the estimate lacks: overlapping meshes and compounds, and joint groups
    // that a direct solver solves.
    double first_step_seconds_max = 0.5;
};

// Checks the description before the world is built. Errors name the value, the limit and its
// setting.
Status check_description(const scenes::SceneDescription& scene, const SceneBudget& budget);
// Estimates the constraint visits per second of the built world, before its first step. Errors as
// above.
Result<double> estimate_work(const scenes::SceneDescription& scene, const physics::World& world,
                             const SceneBudget& budget);
// Measures one step of a temporary world. Errors as above.
Status check_first_step(const scenes::SceneDescription& scene, physics::World world,
                        const SceneBudget& budget);

}  // namespace jostle::server
