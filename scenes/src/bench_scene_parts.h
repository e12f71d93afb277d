// SPDX-License-Identifier: MIT
//
// Parts shared by benchmark scenes.
#pragma once

#include <functional>

#include "jostle/scenes/scene.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

// Sets the world parameters of all benchmark scenes explicitly, independent of the defaults.
SceneDescription with_bench_defaults(SceneDescription scene);

// Adds a floor whose top is at height 0.
void add_bench_floor(SceneDescription& scene, double half_width);
// Adds four walls, 1 m thick, around a square with this inner half width.
void add_bench_walls(SceneDescription& scene, double half_width, double height = 20);

physics::Quat random_turn(Random& random);

physics::Geometry hull_of(std::span<const physics::Vec3> points);
// Hulls of points in random directions. Bodies share a few of them, so that not every body has hull
// data of its own.
std::vector<physics::Geometry> round_stones(Random& random, int count, int corners, double radius);
// A prism with the given number of sides between two discs, whose radii may differ.
physics::Geometry prism(int sides, physics::Vec3 from, double radius_from, physics::Vec3 to,
                        double radius_to);
// A square of cells around the origin, as a mesh with two triangles per cell.
SceneBody mesh_ground(std::uint32_t cells, double spacing,
                      const std::function<double(double x, double z)>& height);

// The figure of the scene bench_ragdolls_40: eleven capsules and ten joints.

// Adds a figure that stands on `feet`, with its arms spread along the x axis of the pose and its
// face towards z.
void add_bench_ragdoll(SceneDescription& scene, const physics::Transform& feet);

}  // namespace jostle::scenes
