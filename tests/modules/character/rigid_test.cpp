// SPDX-License-Identifier: MIT
//
// Rigid characters: dynamic bodies with controls.
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

TEST(Rigid, walks_at_the_requested_speed_and_stays_upright) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.kind = CharacterKind::rigid, .feet = {0, 0, 0}});
    stage.walk(hero, {3, 0, -4});
    stage.run(1);
    const Vec3 start = stage.of(hero).feet;
    stage.run(4);
    EXPECT_TRUE(test::near(stage.of(hero).feet - start, {12, 0, -16}, 0.02));
    EXPECT_EQ(test::state_of(stage.world, stage.of(hero).body).pose.rotation, Quat{});
    stage.walk(hero, {});
    stage.run(1);
    EXPECT_TRUE(test::near(stage.of(hero).velocity, {}, 1e-3)) << "and stops";
}

TEST(Rigid, walks_below_its_slope_limit_and_slides_above) {
    for (const double degrees : {20.0, 40.0, 49.0, 51.0, 60.0}) {
        const double angle = radians(degrees);
        Stage stage;
        add_slope(stage.world, angle);
        const CharacterId hero = stage.add({.kind = CharacterKind::rigid,
                                            .feet = feet_on_slope(angle, 0.3, 0),
                                            .abilities = {.slope_limit = radians(50)}});
        stage.run(1);
        const Vec3 start = stage.of(hero).feet;
        if (degrees > 50) {
            const double before = length(stage.of(hero).velocity);
            stage.run(1);
            const double a = length(stage.of(hero).velocity) - before;
            EXPECT_NEAR(a / (9.81 * sin_cos(angle).sin), 1, 0.02) << degrees;
            continue;
        }
        stage.run(2);
        EXPECT_TRUE(test::near(stage.of(hero).feet, start, 0.01)) << degrees;
        stage.walk(hero, {2, 0, 0});
        stage.run(2);
        EXPECT_NEAR(stage.of(hero).feet.x - start.x, 4, 0.15) << degrees;
    }
}

// A ball that hits a rigid character accelerates it according to its mass. A standing sweeping
// character would not move.
TEST(Rigid, is_pushed_by_other_bodies) {
    Stage stage({.gravity = {}});
    const CharacterId hero = stage.add({.kind = CharacterKind::rigid, .feet = {0, 0, 0}});
    const BodyId ball = test::add(
        stage.world, {.geometry = Sphere{0.3}, .position = {-3, 0.9, 0}, .velocity = {8, 0, 0}});
    const double mass = test::state_of(stage.world, ball).mass;
    stage.run(1);
    const double sum =
        mass * test::velocity_of(stage.world, ball).x + 80 * stage.of(hero).velocity.x;
    EXPECT_GT(stage.of(hero).velocity.x, 1);
    EXPECT_NEAR(sum / (mass * 8), 1, 0.01);
}

TEST(Rigid, sleeps_when_idle_and_wakes_on_controls) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.kind = CharacterKind::rigid, .feet = {0, 0, 0}});
    stage.run(5);
    EXPECT_FALSE(test::state_of(stage.world, stage.of(hero).body).awake);
    stage.walk(hero, {2, 0, 0});
    stage.run(1);
    EXPECT_GT(stage.of(hero).feet.x, 1.8);
}

}  // namespace
}  // namespace jostle::modules
