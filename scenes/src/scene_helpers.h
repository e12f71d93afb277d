// SPDX-License-Identifier: MIT
//
// Building blocks of the scenes in the catalogue. Deterministic: they use a generator of their own
// instead of the distributions of the standard library.
#pragma once

#include "jostle/scenes/scene.h"

namespace jostle::scenes {

// Linear congruential generator (Press et al., "Numerical Recipes"): the same numbers on every
// machine.
class Random {
public:
    explicit Random(std::uint32_t seed = 12345) : state_(seed) {}
    double in(double low, double high) {
        state_ = state_ * 1664525u + 1013904223u;
        return low + (high - low) * (state_ >> 8) / 16777216.0;
    }

private:
    std::uint32_t state_;
};

// Solid ground, 400 m wide, whose top is at height 0.
SceneBody ground();
SceneBody fixed_box(std::string name, physics::Vec3 center, physics::Vec3 half_extents,
                    physics::Quat rotation = {});
// A dynamic body with one shape.
SceneBody dynamic_body(std::string name, physics::Vec3 position, physics::Geometry geometry,
                       physics::Quat rotation = {});
// A convex stone with 14 corners and about the given radius.
physics::Geometry stone(Random& random, double radius);
SceneBody colored(SceneBody body, std::uint32_t color);
// Joins the bodies a and b at a frame in the world, given in their initial poses.
void join(SceneDescription& scene, const char* name, std::size_t a, std::size_t b,
          const physics::Transform& frame, const physics::JointKind& kind);

// The scenes, one function each; the catalogue contains their names and descriptions.
SceneDescription sandbox();
SceneDescription stack();
SceneDescription pyramid();
SceneDescription wall();
SceneDescription dominoes();
SceneDescription pile();
SceneDescription rain();
SceneDescription billiards();
SceneDescription incline();
SceneDescription free_space();
SceneDescription shapes();
SceneDescription terrain();
SceneDescription ragdolls();
SceneDescription bridge();
SceneDescription workshop();
SceneDescription machines();
SceneDescription conveyor();
SceneDescription gates();
SceneDescription bullets();
SceneDescription locked();
SceneDescription flatland();
SceneDescription hovercraft();
SceneDescription ragdoll_stairs();
SceneDescription fountain();
SceneDescription harbour();
SceneDescription parkour();
SceneDescription race_track();
SceneDescription demolition();
SceneDescription stampede();
SceneDescription stadium();
SceneDescription rope_bridge();
SceneDescription swings();
SceneDescription flag();
SceneDescription curtain();
SceneDescription katamari();
SceneDescription asteroids();
SceneDescription asteroids_1000();
SceneDescription asteroids_10000();
SceneDescription bench_pyramid_465();
SceneDescription bench_pyramid_5050();
SceneDescription bench_boxes_1000();
SceneDescription bench_pile_5000();
SceneDescription bench_player_901();
SceneDescription bench_ragdolls_40();
SceneDescription bench_joint_grid_10000();
SceneDescription bench_asleep_10000();
SceneDescription bench_bullets_1000();
SceneDescription bench_trees();
SceneDescription bench_convex_pile();
SceneDescription bench_washer();
SceneDescription bench_hull_terrain();
SceneDescription bench_chain();
SceneDescription bench_rain();
SceneDescription bench_vehicles();
SceneDescription bench_rods();
SceneDescription bench_box_shot();
SceneDescription bench_brick_wall();
SceneDescription bench_l_shapes();
SceneDescription bench_junkyard();

}  // namespace jostle::scenes
