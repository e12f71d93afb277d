// SPDX-License-Identifier: MIT
#include "server/world/grabs.h"

#include <gtest/gtest.h>

#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using namespace physics;

using test::dt;

class GrabsTest : public testing::Test {
protected:
    BodyId add(double x) {
        return *world.create_body({.pose = {.position = {x, 0, 0}}}, {.geometry = Sphere{0.5}});
    }
    void grab(ClientId client, BodyId body) {
        EXPECT_TRUE(
            grabs.grab(world, client, *world.body(body), world.body(body)->pose.position).ok());
    }
    double x_after(BodyId body, int ticks) {
        for (int i = 0; i < ticks; i++) {
            EXPECT_TRUE(world.step(dt).ok());
        }
        return world.body(body)->pose.position.x;
    }

    World world = std::move(*World::create({.gravity = {}}));
    Grabs grabs;
};

TEST_F(GrabsTest, what_is_held_stays_until_it_is_dragged) {
    const BodyId ball = add(0);
    grab(1, ball);
    EXPECT_NEAR(x_after(ball, 60), 0, 1e-9);
    EXPECT_EQ(grabs.drag(world, 1, {3, 0, 0}), ball);
    EXPECT_NEAR(x_after(ball, 120), 3, 0.01);
}

TEST_F(GrabsTest, a_client_holds_one_body_and_several_may_hold_the_same) {
    const BodyId one = add(0), two = add(5);
    grab(1, one);
    grab(1, two);
    EXPECT_EQ(grabs.drag(world, 1, {5, 0, 0}), two);
    grab(2, two);
    EXPECT_EQ(grabs.drag(world, 2, {5, 0, 0}), two);
    grabs.release(world, 1);
    EXPECT_FALSE(grabs.drag(world, 1, {}));
    EXPECT_TRUE(grabs.drag(world, 2, {5, 0, 0}));
}

TEST_F(GrabsTest, a_body_that_is_gone_is_held_by_nobody) {
    const BodyId one = add(0), two = add(5);
    grab(1, one);
    grab(2, one);
    grab(3, two);
    grabs.release_body(world, one);
    EXPECT_FALSE(grabs.drag(world, 1, {}));
    EXPECT_FALSE(grabs.drag(world, 2, {}));
    // One that the world no longer has is let go of when somebody pulls at it.
    ASSERT_TRUE(world.destroy_body(two).ok());
    EXPECT_FALSE(grabs.drag(world, 3, {}));
}

TEST_F(GrabsTest, what_is_held_is_part_of_the_state) {
    const BodyId ball = add(0);
    grab(1, ball);
    ASSERT_EQ(world.joints().size(), 1u);
    grabs.release(world, 1);
    EXPECT_TRUE(world.joints().empty());
}

// A hand of 200 m/s^2 at most.
TEST_F(GrabsTest, a_hand_pulls_no_harder_than_its_strength) {
    const BodyId ball = add(0);
    grab(1, ball);
    EXPECT_TRUE(grabs.drag(world, 1, {9000, 0, 0}));
    ASSERT_TRUE(world.step(dt).ok());
    EXPECT_NEAR(world.body(ball)->linear_velocity.x, 200 * dt, 0.01);
}

}  // namespace
}  // namespace jostle::server
