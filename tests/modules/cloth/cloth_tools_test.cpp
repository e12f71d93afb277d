// SPDX-License-Identifier: MIT
//
// Tools of players on cloth: rays, grabs, pushes, cuts and explosions.
#include <gtest/gtest.h>

#include "jostle/modules/cloth.h"
#include "tests/modules/module_determinism.h"
#include "tests/support/error_of.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;
using test::error_of;

struct Scene {
    World world;
    Cloths& cloths;
    ClothKey cloth;
};

// A sheet of 1 m x 1 m and 0.2 kg with 11 x 11 vertices in the plane z = 0, held by nothing.
Scene loose_sheet(Vec3 gravity = {}) {
    World world = test::make_world({.gravity = gravity});
    test::must(world.add_module(std::make_unique<Cloths>()));
    Cloths& cloths = dynamic_cast<Cloths&>(*world.module("cloth"));
    const ClothKey cloth = test::must(
        cloths.add(world, {.grid = {.rows = 11, .columns = 11}, .damping = 0, .drag = 0}));
    return {std::move(world), cloths, cloth};
}

Vec3 momentum_of(const Scene& scene) {
    Vec3 sum;
    const auto velocities = scene.cloths.velocities(scene.cloth);
    const auto masses = scene.cloths.masses(scene.cloth);
    for (std::size_t k = 0; k < velocities.size(); k++) sum += velocities[k] * masses[k];
    return sum;
}

TEST(ClothTools, ray_hits_both_sides) {
    const Scene scene = loose_sheet();
    for (const double side : {-1.0, 1.0}) {
        const auto hit =
            scene.cloths.cast_ray({.origin = {0.32, -0.41, 2 * side}, .motion = {0, 0, -4 * side}});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->at, (DeformablePoint{scene.cloth.number, 4 * 11 + 3}));
        EXPECT_NEAR(hit->fraction, 0.5, 1e-6);
        EXPECT_NEAR(hit->position.z, 0, 1e-6);
    }
    EXPECT_FALSE(scene.cloths.cast_ray({.origin = {0.3, 0.01, 2}, .motion = {0, 0, -4}}));
    EXPECT_FALSE(scene.cloths.cast_ray({.origin = {0.3, -0.4, 2}, .motion = {0, 0, -1.9}}));
}

TEST(ClothTools, push_gives_its_momentum_and_limits_the_speed) {
    Scene scene = loose_sheet();
    test::must(scene.cloths.push(scene.world, {scene.cloth.number, 60}, {0, 0, 0.02}));
    EXPECT_NEAR(momentum_of(scene).z, 0.02, 1e-8);
    test::must(scene.cloths.push(scene.world, {scene.cloth.number, 60}, {100, 0, 0}));
    EXPECT_NEAR(scene.cloths.velocities(scene.cloth)[60].x, 20, 1e-5);
}

TEST(ClothTools, grab_lifts_a_sheet) {
    Scene scene = loose_sheet({0, -9.81, 0});
    test::must(scene.cloths.grab(scene.world, 7, {scene.cloth.number, 0}));
    test::run(scene.world, 4);
    // The spring of 5 Hz at a grab as heavy as the sheet gives way by g / w^2.
    EXPECT_NEAR(scene.cloths.positions(scene.cloth)[0].y, -9.81 / 986.96, 0.01);
    scene.cloths.release(7);
    test::run(scene.world, 0.5);
    EXPECT_LT(scene.cloths.positions(scene.cloth)[0].y, -0.5);
    EXPECT_FALSE(scene.cloths.drag(7, {}));
}

TEST(ClothTools, refusals_name_what_is_wrong) {
    Scene scene = loose_sheet();
    test::must(scene.cloths.attach(scene.world, scene.cloth, {.vertex = 3}));
    EXPECT_EQ(error_of(scene.cloths.grab(scene.world, 7, {scene.cloth.number, 3})).code,
              ErrorCode::failed_precondition);
    EXPECT_EQ(error_of(scene.cloths.grab(scene.world, 7, {9, 3})).code, ErrorCode::not_found);
    EXPECT_EQ(error_of(scene.cloths.grab(scene.world, 7, {scene.cloth.number, 121})).code,
              ErrorCode::not_found);
    EXPECT_EQ(error_of(scene.cloths.cut_at(scene.world, 9, {})).code, ErrorCode::not_found);
}

TEST(ClothTools, cut_tears_the_threads_of_the_nearest_vertex_once) {
    Scene scene = loose_sheet();
    const std::size_t before = scene.cloths.triangles(scene.cloth).size();
    test::must(scene.cloths.cut_at(scene.world, scene.cloth.number, {0.52, -0.5, 0.3}));
    EXPECT_EQ(scene.cloths.events().back().threads, 4u);
    EXPECT_LT(scene.cloths.triangles(scene.cloth).size(), before);
    EXPECT_EQ(
        error_of(scene.cloths.cut_at(scene.world, scene.cloth.number, {0.52, -0.5, 0.3})).code,
        ErrorCode::failed_precondition);
}

// Pressure of 2 N s/m^2 on 1 m^2 along z; along x the sheet has no area.
TEST(ClothTools, pulse_pushes_the_area_that_faces_it) {
    Scene scene = loose_sheet();
    const auto pulse = [&](Vec3 center, Vec3 pressure) {
        apply_pulse(scene.world, {.center = center,
                                  .radius = 2000,
                                  .max_speed = 100,
                                  .impulse_per_area = [=](Vec3) { return pressure; }});
    };
    pulse({0.5, -0.5, -1000}, {0, 0, 2});
    EXPECT_NEAR(momentum_of(scene).z, 2, 1e-4);
    pulse({-1000, -0.5, 0}, {2, 0, 0});
    EXPECT_NEAR(momentum_of(scene).x, 0, 1e-6);
}

TEST(ClothTools, held_sheet_continues_bit_identically) {
    register_cloths();
    const auto held = [](int) {
        Scene scene = loose_sheet({0, -9.81, 0});
        test::must(scene.cloths.grab(scene.world, 7, {scene.cloth.number, 60}));
        EXPECT_TRUE(scene.cloths.drag(7, {2, 2, 1}));
        return std::move(scene.world);
    };
    test::expect_continues(held, 0.3, 0.5);
}

}  // namespace
}  // namespace jostle::modules
