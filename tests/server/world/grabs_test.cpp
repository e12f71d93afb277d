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

TEST_F(GrabsTest, grabbed_body_stays_until_dragged) {
    const BodyId ball = add(0);
    grab(1, ball);
    EXPECT_NEAR(x_after(ball, 60), 0, 1e-9);
    EXPECT_EQ(grabs.drag(world, 1, {3, 0, 0}), ball);
    EXPECT_NEAR(x_after(ball, 120), 3, 0.01);
}

TEST_F(GrabsTest, one_grab_per_client_and_many_per_body) {
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

TEST_F(GrabsTest, removing_a_body_releases_its_grabs) {
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

TEST_F(GrabsTest, grabs_are_part_of_the_state) {
    const BodyId ball = add(0);
    grab(1, ball);
    ASSERT_EQ(world.joints().size(), 1u);
    grabs.release(world, 1);
    EXPECT_TRUE(world.joints().empty());
}

// A hand of 200 m/s^2 at most.
TEST_F(GrabsTest, limits_grab_force) {
    const BodyId ball = add(0);
    grab(1, ball);
    EXPECT_TRUE(grabs.drag(world, 1, {9000, 0, 0}));
    ASSERT_TRUE(world.step(dt).ok());
    EXPECT_NEAR(world.body(ball)->linear_velocity.x, 200 * dt, 0.01);
}

}  // namespace
}  // namespace jostle::server
