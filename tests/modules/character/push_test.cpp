// SPDX-License-Identifier: MIT
//
// Pushes of a character: momentum is conserved, and effort is limited.
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

Vec3 momentum(const Stage& stage, BodyId body, CharacterId hero, double mass) {
    const BodyState crate = test::state_of(stage.world, body);
    return crate.linear_velocity * crate.mass + stage.of(hero).velocity * mass;
}

// Without gravity, central and off centre: the momentum that one loses, the other gains.
TEST(PushState, impact_conserves_momentum) {
    double worst = 0;
    for (const double speed : {1.0, 5.0, 20.0})
        for (const double height : {0.0, 0.7})
            for (const double mass : {5.0, 40.0, 400.0}) {
                Stage stage({.gravity = {}});
                const BodyId crate = test::add(stage.world, {.geometry = Box{{0.4, 0.4, 0.4}},
                                                             .position = {2, 0.9 + height, 0},
                                                             .density = mass / 0.512});
                const CharacterId hero = stage.add(
                    {.feet = {0, 0, 0}, .velocity = {speed, 0, 0}, .abilities = {.mass = 80}});
                const double before = momentum(stage, crate, hero, 80).x;
                stage.run(3 / speed);
                EXPECT_GT(test::velocity_of(stage.world, crate).x, 0);
                const double off = momentum(stage, crate, hero, 80).x / before - 1;
                worst = maximum(worst, absolute(off));
                if (height == 0) {
                    EXPECT_NEAR(stage.of(hero).velocity.x, speed * 80 / (80 + mass), 0.01 * speed)
                        << "a perfectly inelastic impact";
                }
            }
    record("impact_momentum_relative_error", worst);
    EXPECT_LE(worst, 0.01);
}

// On level ground without friction, the crate has the momentum applied to it, in each step.
TEST(PushState, crate_momentum_equals_the_applied_impulse) {
    Stage stage;
    test::add_floor(stage.world, 0);
    const BodyId crate = test::add(stage.world, {.geometry = Box{{0.5, 0.5, 0.5}},
                                                 .position = {1.5, 0.5, 0},
                                                 .friction = 0,
                                                 .density = 60});
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.walk(hero, {3, 0, 0});
    double given = 0, worst = 0;
    for (int k = 0; k < 240; k++) {
        stage.run(1 / hz);
        given += stage.of(hero).applied_impulse.x;
        const double has = 60 * test::velocity_of(stage.world, crate).x;
        if (given > 0) worst = maximum(worst, absolute(has / given - 1));
    }
    record("pushed_momentum_relative_error", worst);
    EXPECT_LE(worst, 0.01);
    EXPECT_NEAR(test::velocity_of(stage.world, crate).x, 3, 0.03) << "the walking speed";
    EXPECT_NEAR(stage.of(hero).velocity.x, 3, 0.03);
}

// Against friction: a character moves a crate only if its strength exceeds friction.
TEST(PushState, push_force_matches_strength) {
    const double weight = 200 * 9.81, friction = 0.5;
    for (const double strength : {0.8 * friction * weight, 1.3 * friction * weight}) {
        Stage stage;
        test::add_floor(stage.world, friction);
        const BodyId crate = test::add(stage.world, {.geometry = Box{{0.5, 0.5, 0.5}},
                                                     .position = {1.5, 0.5, 0},
                                                     .friction = friction,
                                                     .density = 200});
        const CharacterId hero =
            stage.add({.feet = {0.65, 0, 0}, .abilities = {.strength = strength}});
        stage.walk(hero, {0.5, 0, 0});
        stage.run(6);
        const double distance = test::position_of(stage.world, crate).x - 1.5;
        if (strength < friction * weight)
            EXPECT_LT(distance, 0.02);
        else
            EXPECT_GT(distance, 1.5);
        EXPECT_LT(stage.of(hero).feet.x + 0.3, test::position_of(stage.world, crate).x - 0.49)
            << "the character does not penetrate the crate";
    }
}

TEST(PushState, raft_receives_the_walking_recoil) {
    Stage stage({.gravity = {0, -9.81, 0}});
    test::add_floor(stage.world, 0);
    const BodyId raft = test::add(
        stage.world,
        {.geometry = Box{{5, 0.25, 2}}, .position = {0, 0.25, 0}, .friction = 0, .density = 80});
    const CharacterId hero = stage.add({.feet = {0, 0.5, 0}});
    stage.run(1);
    stage.walk(hero, {2, 0, 0});
    stage.run(0.5);
    const double mass = test::state_of(stage.world, raft).mass;
    EXPECT_NEAR(momentum(stage, raft, hero, 80).x, 0, 0.01 * 80 * 2);
    EXPECT_NEAR(test::velocity_of(stage.world, raft).x, -2 * 80 / (80 + mass), 0.01);
}

TEST(PushState, hit_cart_is_slowed_by_the_standing_character) {
    Stage stage;
    test::add_floor(stage.world, 0);
    const BodyId cart = test::add(
        stage.world,
        {.geometry = Box{{2, 0.25, 1}}, .position = {0, 0.25, 0}, .friction = 0, .density = 50});
    const CharacterId hero = stage.add({.feet = {0, 0.5, 0}});
    stage.run(1);
    test::must(stage.world.apply_impulse(cart, {300, 0, 0}, {0, 0.25, 0}));
    stage.run(1);
    const double mass = test::state_of(stage.world, cart).mass;
    EXPECT_NEAR(momentum(stage, cart, hero, 80).x, 300, 3);
    EXPECT_NEAR(stage.of(hero).velocity.x, 300 / (80 + mass), 0.01);
    EXPECT_NEAR(stage.of(hero).feet.x, test::position_of(stage.world, cart).x, 0.03);
}

TEST(PushState, seesaw_tilts_under_its_weight) {
    Stage stage;
    test::add_floor(stage.world);
    const BodyId plank = test::add(
        stage.world, {.geometry = Box{{3, 0.05, 0.5}}, .position = {0, 1, 0}, .density = 200});
    const BodyId post =
        test::add_static(stage.world, {.geometry = Box{{0.05, 0.4, 0.5}}, .position = {0, 0.4, 0}});
    test::must(stage.world.create_joint({.body_a = post,
                                         .body_b = plank,
                                         .frame_a = {{0, 0.6, 0}, {}},
                                         .frame_b = {{0, 0, 0}, {}},
                                         .kind = HingeJoint{}}));
    const CharacterId hero = stage.add({.feet = {2.5, 1.06, 0}});
    stage.run(2);
    EXPECT_LT(apply(test::state_of(stage.world, plank).pose, {3, 0, 0}).y, 0.4);
    EXPECT_LT(stage.of(hero).feet.y, 0.6);
}

TEST(PushState, two_characters_do_not_walk_through_each_other) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId left = stage.add({.feet = {-2, 0, 0}}),
                      right = stage.add({.feet = {2, 0, 0}});
    stage.walk(left, {3, 0, 0});
    stage.walk(right, {-3, 0, 0});
    stage.run(3);
    const double apart = stage.of(right).feet.x - stage.of(left).feet.x;
    EXPECT_GE(apart, 0.56 - 1e-6) << "the two bodies do not overlap";
    EXPECT_LE(apart, 0.63);
}

}  // namespace
}  // namespace jostle::modules
