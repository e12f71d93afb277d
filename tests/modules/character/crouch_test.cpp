// SPDX-License-Identifier: MIT
//
// Crouching under low obstacles.
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

class Crouch : public testing::TestWithParam<CharacterKind> {};

TEST_P(Crouch, crouches_under_a_beam_and_does_not_stand_up_there) {
    Stage stage;
    test::add_floor(stage.world);
    test::add_static(stage.world, {.geometry = Box{{1, 0.5, 2}}, .position = {3, 1.8, 0}});
    const CharacterId hero = stage.add({.kind = GetParam(), .feet = {0, 0, 0}});
    stage.walk(hero, {2, 0, 0});
    stage.run(2);
    EXPECT_LT(stage.of(hero).feet.x, 1.75) << "too tall";
    stage.steer(hero, {.walk = {2, 0, 0}, .crouch = true});
    stage.run(0.7);
    EXPECT_TRUE(stage.of(hero).crouched);
    stage.steer(hero, {});
    stage.run(0.5);
    EXPECT_NEAR(stage.of(hero).feet.x, 3, 0.5);
    EXPECT_TRUE(stage.of(hero).crouched) << "there is no room to stand";
    EXPECT_NEAR(stage.of(hero).feet.y, 0, 0.003);
    stage.walk(hero, {2, 0, 0});
    stage.run(2);
    EXPECT_FALSE(stage.of(hero).crouched);
    EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground);
    EXPECT_NEAR(stage.of(hero).feet.y, 0, 0.003);
}

TEST_P(Crouch, body_height_matches_crouch_state) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.kind = GetParam(), .feet = {0, 0, 0}});
    const auto top = [&] {
        const auto hit = test::must(stage.world.queries().cast_ray({{0, 5, 0}, {0, -10, 0}}));
        return hit->point.y;
    };
    stage.run(0.5);
    EXPECT_NEAR(top(), 1.8, 0.025);
    const double mass = test::state_of(stage.world, stage.of(hero).body).mass;
    stage.steer(hero, {.crouch = true});
    stage.run(0.1);
    EXPECT_NEAR(top(), 1.1, 0.025);
    EXPECT_NEAR(test::state_of(stage.world, stage.of(hero).body).mass, mass, 1e-9);
    stage.steer(hero, {});
    stage.run(0.1);
    EXPECT_NEAR(top(), 1.8, 0.025);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Crouch,
                         testing::Values(CharacterKind::sweeping, CharacterKind::rigid));

}  // namespace
}  // namespace jostle::modules
