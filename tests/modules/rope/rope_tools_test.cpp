// SPDX-License-Identifier: MIT
//
// Tools of players on ropes: rays, grabs, pushes, cuts and explosions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/modules/rope.h"
#include "tests/modules/module_determinism.h"
#include "tests/support/error_of.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;
using test::error_of;
using testing::HasSubstr;

struct Scene {
    World world;
    Ropes& ropes;
    RopeKey rope;
};

// A rope of 1 m and 0.2 kg with 20 links along x, held by nothing.
Scene loose_rope(Vec3 gravity = {}) {
    World world = test::make_world({.gravity = gravity});
    test::must(world.add_module(std::make_unique<Ropes>()));
    Ropes& ropes = dynamic_cast<Ropes&>(*world.module("rope"));
    const RopeKey rope =
        test::must(ropes.add(world, {.points = {{0, 1, 0}, {1, 1, 0}}, .links = 20, .damping = 0}));
    return {std::move(world), ropes, rope};
}

Vec3 momentum_of(const Scene& scene) {
    Vec3 sum;
    const auto velocities = scene.ropes.velocities(scene.rope);
    for (std::size_t k = 0; k < velocities.size(); k++)
        sum += velocities[k] * (k == 0 || k + 1 == velocities.size() ? 0.005 : 0.01);
    return sum;
}

TEST(RopeTools, ray_hits_the_surface_of_a_link) {
    const Scene scene = loose_rope();
    const auto hit = scene.ropes.cast_ray({.origin = {0.52, 3, 0}, .motion = {0, -4, 0}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->at, (DeformablePoint{scene.rope.number, 10}));
    EXPECT_NEAR(hit->position.y, 1.02, 1e-9);  // the radius is 2 cm
    EXPECT_NEAR(hit->fraction, 1.98 / 4, 1e-9);
    EXPECT_FALSE(scene.ropes.cast_ray({.origin = {0.52, 3, 0.021}, .motion = {0, -4, 0}}));
    EXPECT_FALSE(scene.ropes.cast_ray({.origin = {0.52, 3, 0}, .motion = {0, -1.9, 0}}));
    EXPECT_TRUE(scene.ropes.cast_ray({.origin = {-1, 1, 0}, .motion = {5, 0, 0}}));  // along it
}

TEST(RopeTools, first_module_on_the_ray_counts) {
    Scene scene = loose_rope();
    const RopeKey upper =
        test::must(scene.ropes.add(scene.world, {.points = {{0, 2, 0}, {1, 2, 0}}}));
    const auto hit =
        cast_ray_at_deformables(scene.world, {.origin = {0.5, 3, 0}, .motion = {0, -4, 0}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->module, "rope");
    EXPECT_EQ(hit->at.object, upper.number);
}

TEST(RopeTools, push_gives_its_momentum_and_limits_the_speed) {
    Scene scene = loose_rope();
    test::must(scene.ropes.push(scene.world, {scene.rope.number, 10}, {0, 0.05, 0}));
    EXPECT_NEAR(momentum_of(scene).y, 0.05, 1e-12);
    test::must(scene.ropes.push(scene.world, {scene.rope.number, 10}, {0, 0, 100}));
    EXPECT_NEAR(scene.ropes.velocities(scene.rope)[10].z, 20, 1e-12);
}

TEST(RopeTools, grab_lifts_a_rope) {
    Scene scene = loose_rope({0, -9.81, 0});
    test::must(scene.ropes.grab(scene.world, 7, {scene.rope.number, 0}));
    for (int k = 0; k < 300; k++) {
        ASSERT_TRUE(scene.ropes.drag(7, {0, 1 + 0.01 * std::min(k, 100), 0}));
        test::run(scene.world, 1.0 / 60);
    }
    // The spring of 5 Hz at a grab as heavy as the rope gives way by g / w^2.
    EXPECT_NEAR(scene.ropes.positions(scene.rope)[0].y, 2 - 9.81 / 986.96, 0.01);
    scene.ropes.release(7);
    test::run(scene.world, 0.5);
    EXPECT_LT(scene.ropes.positions(scene.rope)[0].y, 1.2);
    EXPECT_TRUE(scene.ropes.attachments(scene.rope).empty());
    EXPECT_FALSE(scene.ropes.drag(7, {}));
}

// A grab pulls with at most 200 m/s^2 times the mass of the rope.
TEST(RopeTools, grab_cannot_pull_out_an_anchor) {
    Scene scene = loose_rope();
    test::must(scene.ropes.attach(scene.world, scene.rope, {.node = 0, .point = {0, 1, 0}}));
    test::must(scene.ropes.grab(scene.world, 7, {scene.rope.number, 20}));
    ASSERT_TRUE(scene.ropes.drag(7, {1000, 1, 0}));
    test::run(scene.world, 2);
    EXPECT_NEAR(scene.ropes.tension(scene.rope, 5), 200 * 0.2, 0.5);
}

TEST(RopeTools, refusals_name_what_is_wrong) {
    Scene scene = loose_rope();
    test::must(scene.ropes.attach(scene.world, scene.rope, {.node = 3}));
    EXPECT_EQ(error_of(scene.ropes.grab(scene.world, 7, {scene.rope.number, 3})).code,
              ErrorCode::failed_precondition);
    EXPECT_EQ(error_of(scene.ropes.grab(scene.world, 7, {9, 3})).code, ErrorCode::not_found);
    EXPECT_EQ(error_of(scene.ropes.grab(scene.world, 7, {scene.rope.number, 21})).code,
              ErrorCode::not_found);
    EXPECT_EQ(error_of(scene.ropes.grab(scene.world, 0, {scene.rope.number, 4})).code,
              ErrorCode::invalid_argument);
    EXPECT_THAT(
        error_of(scene.ropes.attach(scene.world, scene.rope, {.node = 4, .holder = 7})).message,
        HasSubstr("use grab()"));
}

TEST(RopeTools, nearest_prefers_free_nodes) {
    Scene scene = loose_rope();
    EXPECT_EQ(scene.ropes.nearest(scene.rope.number, {0.11, 1, 0})->element, 2u);
    test::must(scene.ropes.attach(scene.world, scene.rope, {.node = 2, .point = {0.1, 1, 0}}));
    EXPECT_EQ(scene.ropes.nearest(scene.rope.number, {0.11, 1, 0})->element, 3u);
    EXPECT_FALSE(scene.ropes.nearest(scene.rope.number, {0, std::nan(""), 0}));
    EXPECT_FALSE(scene.ropes.nearest(99, {}));
}

TEST(RopeTools, grab_stays_with_its_part_of_a_cut_rope) {
    Scene scene = loose_rope();
    test::must(scene.ropes.grab(scene.world, 7, {scene.rope.number, 15}));
    test::must(scene.ropes.cut_at(scene.world, scene.rope.number, {0.5, 1, 0}));
    ASSERT_EQ(scene.ropes.ropes().size(), 2u);
    const RopeKey rest = scene.ropes.ropes()[1];
    ASSERT_EQ(scene.ropes.attachments(rest).size(), 1u);
    EXPECT_EQ(scene.ropes.attachments(rest)[0].node, 5u);
    EXPECT_TRUE(scene.ropes.attachments(scene.rope).empty());
    ASSERT_TRUE(scene.ropes.drag(7, {2, 1, 0}));
    test::run(scene.world, 1);
    EXPECT_NEAR(scene.ropes.positions(rest)[5].x, 2, 0.01);
    test::must(scene.ropes.cut_at(scene.world, rest.number, {0, 9, 0}));
    EXPECT_EQ(scene.ropes.ropes().size(), 3u);
}

TEST(RopeTools, attaching_a_held_node_releases_the_grab) {
    Scene scene = loose_rope();
    test::must(scene.ropes.grab(scene.world, 7, {scene.rope.number, 0}));
    test::must(scene.ropes.attach(scene.world, scene.rope, {.node = 0, .point = {0, 1, 0}}));
    test::run(scene.world, 0.1);
    EXPECT_FALSE(scene.ropes.drag(7, {}));
}

// The impulse is the pressure times the area 2 r L of the rope, away from the center.
TEST(RopeTools, pulse_pushes_the_diameter) {
    Scene scene = loose_rope();
    apply_pulse(
        scene.world,
        {.center = {0.5, 0, 0}, .radius = 5, .max_speed = 100, .impulse_per_area = [](Vec3) {
             return Vec3{0, 2, 0};
         }});
    EXPECT_NEAR(momentum_of(scene).y, 2 * 2 * 0.02 * 1, 1e-12);
    apply_pulse(scene.world,
                {.center = {0.5, 0, 0}, .radius = 5, .max_speed = 3, .impulse_per_area = [](Vec3) {
                     return Vec3{0, 0, 1e6};
                 }});
    EXPECT_NEAR(scene.ropes.velocities(scene.rope)[4].z, 3, 1e-12);
}

TEST(RopeTools, held_rope_continues_bit_identically) {
    register_ropes();
    const auto held = [](int) {
        Scene scene = loose_rope({0, -9.81, 0});
        test::must(scene.ropes.grab(scene.world, 7, {scene.rope.number, 6}));
        EXPECT_TRUE(scene.ropes.drag(7, {2, 2, 1}));
        return std::move(scene.world);
    };
    test::expect_continues(held, 0.3, 0.5);
}

}  // namespace
}  // namespace jostle::modules
