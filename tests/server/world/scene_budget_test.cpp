// SPDX-License-Identifier: MIT
#include "server/world/scene_budget.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"
#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"

namespace jostle::server {
namespace {

scenes::SceneDescription boxes(int count, physics::Vec3 apart) {
    scenes::SceneDescription scene{.name = "boxes"};
    for (int i = 0; i < count; i++) {
        scenes::SceneBody body;
        body.body.pose.position = apart * i;
        body.shapes.push_back({.geometry = physics::Box{}});
        scene.bodies.push_back(body);
    }
    return scene;
}

std::string refusal_of(const scenes::SceneDescription& scene, const SceneBudget& budget = {}) {
    const auto hosted = HostedWorld::create(scene, {.scene = budget}, 1);
    if (hosted.ok()) return "";
    EXPECT_EQ(hosted.error().code, ErrorCode::resource_exhausted);
    return hosted.error().message;
}

TEST(SceneBudget, rejects_900_overlapping_boxes_with_64_substeps) {
    scenes::SceneDescription scene = boxes(900, {});
    scene.world.substeps = 64;
    const std::string why = refusal_of(scene);
    EXPECT_NE(why.find("60 Hz x 64 sub-steps x (900 moving bodies"), std::string::npos) << why;
    EXPECT_NE(why.find("scene.work_per_second_max allows 2e+08"), std::string::npos) << why;
    EXPECT_EQ(refusal_of([] {
                  scenes::SceneDescription side_by_side = boxes(900, {2, 0, 0});
                  side_by_side.world.substeps = 64;
                  return side_by_side;
              }()),
              "");
}

TEST(SceneBudget, rejects_20000_overlapping_bodies_quickly) {
    const auto began = std::chrono::steady_clock::now();
    EXPECT_NE(refusal_of(boxes(20'000, {})), "");
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(5));
}

TEST(SceneBudget, accepts_every_catalogue_scene) {
    for (const scenes::CatalogEntry& entry : scenes::catalog()) {
        const scenes::SceneDescription scene = *scenes::find_scene(entry.name);
        if (scene.bodies.size() > 3000) continue;  // benchmarks: built slowly, and alike
        EXPECT_EQ(refusal_of(scene), "") << entry.name;
    }
}

TEST(SceneBudget, rejects_60000_joints_on_one_body_pair) {
    scenes::SceneDescription scene = boxes(2, {1, 0, 0});
    for (int i = 0; i < 100; i++) scene.joints.push_back({.name = "pin", .body_b = 1});
    EXPECT_EQ(refusal_of(scene),
              "joint \"pin\": more than 64 joints connect the same two bodies; "
              "scene.joints_per_pair_max allows 64");
    scene.joints.resize(60'000, scene.joints[0]);
    EXPECT_EQ(refusal_of(scene), "the scene has 60000 joints; scene.joints_max allows 20000");
}

TEST(SceneBudget, counts_shared_geometry_once_and_small_shapes_per_body) {
    std::vector<physics::Vec3> points;
    for (int i = 0; i < 200; i++)
        points.push_back({std::cos(i * 0.7), i / 100.0 - 1, std::sin(i * 0.7)});
    const physics::Geometry hull = physics::Hull{physics::build_hull(points).value()};
    scenes::SceneDescription scene = boxes(500, {3, 0, 0});
    for (scenes::SceneBody& body : scene.bodies) body.shapes[0].geometry = hull;
    EXPECT_EQ(refusal_of(scene, {.geometry_bytes_max = 10'000}), "");
    scene.bodies[7].name = "city";
    scene.bodies[7].shapes.assign(5000, {.geometry = physics::Box{}});
    const std::string why = refusal_of(scene);
    EXPECT_TRUE(why.starts_with("bodies[7] \"city\" has ")) << why;
}

// One pair as the broad phase sees it, a million as the narrow phase does.
TEST(SceneBudget, first_step_time_catches_underestimated_scenes) {
    std::vector<physics::CompoundChild> children;
    for (int i = 0; i < 1000; i++) children.push_back({physics::Box{}, {{i * 1e-3, 0, 0}, {}}});
    const physics::Geometry cluster = physics::Compound{physics::build_compound(children).value()};
    scenes::SceneDescription scene = boxes(2, {0.1, 0, 0});
    for (scenes::SceneBody& body : scene.bodies) body.shapes[0].geometry = cluster;
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(refusal_of(scene, {.first_step_seconds_max = 0.1}),
              "the first step of the scene takes longer than 0.1 s; scene.first_step_seconds_max "
              "allows 0.1 s");
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(5));
}

}  // namespace
}  // namespace jostle::server
