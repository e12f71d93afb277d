// SPDX-License-Identifier: MIT
//
// Pushes do what mechanics says, poses are jumps, and who is pushed wakes.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

using test::dt;

// A box of a tonne, 1 m, in empty space; 1000 / 6 kg m^2.
struct Space {
    World world = make_world({.gravity = {}});
    BodyId box = add(world, {});
    BodyState state() const { return state_of(world, box); }
};

TEST(BodyMotion, impulse_at_a_corner_changes_both_velocities) {
    Space space;
    must(space.world.apply_impulse(space.box, {0, 500, 0}, {0.5, 0, 0}));
    EXPECT_TRUE(near(space.state().linear_velocity, {0, 0.5, 0}, 1e-12));
    EXPECT_TRUE(near(space.state().angular_velocity, {0, 0, 250 * 6 / 1000.0}, 1e-12));
    must(space.world.apply_angular_impulse(space.box, {0, 0, -250}));
    EXPECT_TRUE(near(space.state().angular_velocity, {}, 1e-12));
}

TEST(BodyMotion, forces_accumulate_over_one_step) {
    Space space;
    must(space.world.apply_force(space.box, {600, 0, 0}, {0, 0.5, 0}));
    must(space.world.apply_force(space.box, {600, 0, 0}, {0, -0.5, 0}));
    must(space.world.apply_torque(space.box, {0, 1000, 0}));
    EXPECT_EQ(space.state().linear_velocity, Vec3{}) << "not yet";
    must(space.world.step(dt));
    EXPECT_TRUE(near(space.state().linear_velocity, {1.2 * dt, 0, 0}, 1e-12));
    EXPECT_TRUE(near(space.state().angular_velocity, {0, 6 * dt, 0}, 1e-9));
    must(space.world.step(dt));
    EXPECT_TRUE(near(space.state().linear_velocity, {1.2 * dt, 0, 0}, 1e-12)) << "and no longer";
}

TEST(BodyMotion, setting_one_velocity_keeps_the_other) {
    Space space;
    must(space.world.set_velocity(space.box, {1, 2, 3}, {4, 5, 6}));
    must(space.world.set_linear_velocity(space.box, {7, 0, 0}));
    EXPECT_EQ(space.state().angular_velocity, (Vec3{4, 5, 6}));
    must(space.world.set_angular_velocity(space.box, {0, 8, 0}));
    EXPECT_EQ(space.state().linear_velocity, (Vec3{7, 0, 0}));
    EXPECT_EQ(space.state().angular_velocity, (Vec3{0, 8, 0}));
}

// A step later it is there, however it was turned: the shorter way round.
TEST(BodyMotion, move_to_reaches_the_pose_within_a_step) {
    World world = make_world();
    const Quat start = from_axis_angle({0, 0, 1}, 3), end = from_axis_angle({0, 0, 1}, -3);
    const BodyId platform = must(world.create_body(
        {.type = BodyType::kinematic, .pose = {{1, 0, 0}, start}}, {.geometry = Box{{2, 1, 1}}}));
    must(world.move_to(platform, {{1, 0.5, 0}, end}, dt));
    EXPECT_NEAR(state_of(world, platform).angular_velocity.z, (2 * pi - 6) / dt, 1e-9);
    must(world.step(dt));
    EXPECT_TRUE(near(position_of(world, platform), {1, 0.5, 0}, 1e-12));
    EXPECT_TRUE(near(rotate(state_of(world, platform).pose.rotation, {1, 0, 0}),
                     rotate(end, {1, 0, 0}), 1e-9));
}

// A jump takes what touched it by surprise: no velocity comes of it, and the other wakes.
TEST(BodyMotion, set_pose_teleports) {
    World world = make_world();
    add_floor(world);
    const BodyId lower = add(world, {.position = {0, 0.5, 0}}),
                 upper = add(world, {.position = {0, 1.5, 0}});
    run(world, 2);
    ASSERT_FALSE(state_of(world, upper).awake);
    must(world.set_pose(lower, {{10, 0.5, 0}, {}}));
    EXPECT_TRUE(state_of(world, upper).awake);
    EXPECT_EQ(velocity_of(world, lower), Vec3{});
    EXPECT_TRUE(must(world.touching_bodies(lower)).empty());
    run(world, 2);
    EXPECT_NEAR(position_of(world, upper).y, 0.5, 0.01) << "it fell";
    EXPECT_NEAR(position_of(world, lower).x, 10, 1e-3);
}

TEST(BodyMotion, every_impulse_and_force_wakes) {
    const auto woken_by = [](auto&& push) {
        World world = make_world();
        add_floor(world);
        const BodyId box = add(world, {.position = {0, 0.5, 0}});
        run(world, 2);
        EXPECT_FALSE(state_of(world, box).awake);
        must(push(world, box));
        return state_of(world, box).awake;
    };
    EXPECT_TRUE(woken_by([](World& w, BodyId b) { return w.apply_impulse(b, {1, 0, 0}, {}); }));
    EXPECT_TRUE(woken_by([](World& w, BodyId b) { return w.apply_angular_impulse(b, {1, 0, 0}); }));
    EXPECT_TRUE(woken_by([](World& w, BodyId b) { return w.apply_force(b, {1, 0, 0}, {}); }));
    EXPECT_TRUE(woken_by([](World& w, BodyId b) { return w.apply_torque(b, {1, 0, 0}); }));
    EXPECT_TRUE(woken_by([](World& w, BodyId b) { return w.set_velocity(b, {}, {}); }));
    EXPECT_TRUE(woken_by([](World& w, BodyId b) { return w.set_pose(b, {{0, 0.5, 0}, {}}); }));
}

}  // namespace
}  // namespace jostle::test
