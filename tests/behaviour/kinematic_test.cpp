// SPDX-License-Identifier: MIT
//
// Kinematic bodies move by their velocity alone, carry by friction and push without giving way.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId add_platform(World& world, Vec3 velocity, Vec3 spin = {}) {
    return add(world, {.geometry = Box{{10, 0.5, 10}},
                       .position = {0, -0.5, 0},
                       .velocity = velocity,
                       .spin = spin,
                       .type = BodyType::kinematic});
}

TEST(Kinematic, moves_by_its_velocity_alone) {
    World world = make_world();
    const BodyId platform = add_platform(world, {1, 2, -0.5});
    run(world, 3);
    EXPECT_TRUE(near(position_of(world, platform), {3, 5.5, -1.5}, 1e-9));
    EXPECT_EQ(velocity_of(world, platform), (Vec3{1, 2, -0.5}));
}

// The box slips until mu g t has reached the platform's speed: it stays behind by v^2 / (2 mu g).
TEST(Kinematic, platform_carries_a_box_by_friction) {
    World world = make_world();
    const Vec3 v{0.8, 0, 0.6};
    const BodyId platform = add_platform(world, v);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 4);
    EXPECT_TRUE(near(velocity_of(world, box), v, 1e-3));
    const Vec3 behind = position_of(world, platform) - position_of(world, box);
    const double lag = 1 / (2 * 0.5 * 9.81);
    RecordProperty("lag_m", std::to_string(length({behind.x, 0, behind.z})));
    EXPECT_NEAR(length({behind.x, 0, behind.z}), lag, 0.02 * lag + 0.005);
    EXPECT_TRUE(state_of(world, box).awake);  // what is carried does not sleep
}

TEST(Kinematic, lift_carries_a_stack) {
    World world = make_world();
    add_platform(world, {0, 1, 0});
    const BodyId low = add(world, {.position = {0, 0.5, 0}, .velocity = {0, 1, 0}});
    const BodyId high = add(world, {.position = {0, 1.5, 0}, .velocity = {0, 1, 0}});
    run(world, 4);
    EXPECT_TRUE(near(position_of(world, low), {0, 4.5, 0}, 0.01));
    EXPECT_TRUE(near(position_of(world, high), {0, 5.5, 0}, 0.01));
}

TEST(Kinematic, turntable_carries_a_box) {
    World world = make_world();
    add_platform(world, {}, {0, 0.5, 0});  // mu g / r w^2 = 10: holds
    const BodyId box = add(world, {.position = {2, 0.5, 0}, .velocity = {0, 0, -1}});
    run(world, 4);
    const Vec3 p = position_of(world, box);
    // Each step the box goes along a tangent: the radius grows by r w^2 dt / 2 a second at least.
    EXPECT_NEAR(length({p.x, 0, p.z}), 2, 0.05);
    const SinCos turned = sin_cos(0.5 * 4);
    EXPECT_TRUE(near({p.x, 0, p.z}, {2 * turned.cos, 0, -2 * turned.sin}, 0.1));
}

TEST(Kinematic, wall_pushes_a_box) {
    World world = make_world();
    add_floor(world);
    const BodyId wall = add(world, {.geometry = Box{{0.1, 1, 1}},
                                    .position = {-1, 1.01, 0},
                                    .velocity = {1, 0, 0},
                                    .type = BodyType::kinematic});
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 4);
    EXPECT_NEAR(position_of(world, wall).x, 3, 1e-9);
    EXPECT_TRUE(near(position_of(world, box), {3.6, 0.5, 0}, 0.01));
    EXPECT_TRUE(near(velocity_of(world, box), {1, 0, 0}, 0.01));
}

TEST(Kinematic, is_not_moved_by_any_impact) {
    World world = make_world();
    const BodyId platform = add_platform(world, {0.25, 0, 0});
    add(world, {.position = {0, 3, 0}, .velocity = {0, -30, 0}, .density = 1e5});
    run(world, 2);
    EXPECT_TRUE(near(position_of(world, platform), {0.5, -0.5, 0}, 1e-9));
}

TEST(Kinematic, starting_to_move_wakes_resting_bodies) {
    World world = make_world();
    const BodyId platform = add_platform(world, {});
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 3);
    ASSERT_FALSE(state_of(world, box).awake);
    must(world.set_velocity(platform, {1, 0, 0}, {}));
    run(world, 3);
    EXPECT_TRUE(near(velocity_of(world, box), {1, 0, 0}, 1e-3));
}

}  // namespace
}  // namespace jostle::test
