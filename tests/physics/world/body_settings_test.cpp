// SPDX-License-Identifier: MIT
//
// What a body is may change while the world runs: its type, mass, sleep, and the world's gravity.
#include <gtest/gtest.h>

#include "jostle/physics/physics.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/step_time.h"

namespace jostle::physics {
namespace {

using test::dt;

void expect_sound(const World& world) {
    const auto fault = find_fault(state_of(world));
    EXPECT_FALSE(fault) << *fault;
}

void run(World& world, int steps) {
    for (int n = 0; n < steps; n++) {
        ASSERT_TRUE(world.step(dt).ok());
        expect_sound(world);
    }
}

struct Floor {
    World world;
    BodyId ground = *world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}});

    BodyId cube(Vec3 at) {
        return *world.create_body({.pose = {.position = at}}, {.geometry = Box{{0.5, 0.5, 0.5}}});
    }
    double height(BodyId body) const { return world.body(body)->center.y; }
};

TEST(SetType, shelf_made_dynamic_falls_with_its_load) {
    Floor f;
    const BodyId shelf =
        *f.world.create_body({.type = BodyType::static_body, .pose = {.position = {0, 3, 0}}},
                             {.geometry = Box{{1, 0.1, 1}}});
    const BodyId cube = f.cube({0, 3.6, 0});
    run(f.world, 120);
    ASSERT_FALSE(f.world.body(cube)->awake) << "it sleeps on the shelf";
    ASSERT_TRUE(f.world.set_type(shelf, BodyType::dynamic).ok());
    EXPECT_EQ(f.world.body(shelf)->type, BodyType::dynamic);
    EXPECT_NEAR(f.world.body(shelf)->mass, 1000 * 2 * 0.2 * 2, 1e-9);
    run(f.world, 120);
    EXPECT_NEAR(f.height(shelf), 0.1, 0.01);
    EXPECT_NEAR(f.height(cube), 0.7, 0.01);
}

TEST(SetType, crate_made_static_stays_in_the_air) {
    Floor f;
    const BodyId cube = f.cube({0, 2, 0});
    run(f.world, 10);
    const double height = f.height(cube);
    ASSERT_TRUE(f.world.set_type(cube, BodyType::static_body).ok());
    EXPECT_EQ(f.world.body(cube)->linear_velocity, (Vec3{}));
    EXPECT_EQ(f.world.body(cube)->mass, 0);
    run(f.world, 30);
    EXPECT_EQ(f.height(cube), height);
}

TEST(SetType, kinematic_body_moves_jointed_bodies) {
    Floor f;
    const BodyId a = f.cube({0, 5, 0}), b = f.cube({0, 3.5, 0});
    ASSERT_TRUE(f.world
                    .create_joint({.body_a = a,
                                   .body_b = b,
                                   .frame_a = {.position = {0, -0.75, 0}},
                                   .frame_b = {.position = {0, 0.75, 0}}})
                    .ok());
    ASSERT_TRUE(f.world.set_type(a, BodyType::kinematic).ok());
    ASSERT_TRUE(f.world.set_linear_velocity(a, {0, 1, 0}).ok());
    run(f.world, 60);
    EXPECT_NEAR(f.height(a), 6, 1e-9);
    EXPECT_NEAR(f.height(b), 4.5, 0.02);
    const Status status = f.world.set_type(b, BodyType::static_body);
    ASSERT_FALSE(status.ok());
    EXPECT_NE(status.error().message.find("joint {0, "), std::string::npos)
        << status.error().message;
}

TEST(SetType, rejects_moving_planes) {
    Floor f;
    const Status status = f.world.set_type(f.ground, BodyType::dynamic);
    ASSERT_FALSE(status.ok());
    EXPECT_NE(status.error().message.find("a plane is infinite"), std::string::npos);
    EXPECT_EQ(f.world.body(f.ground)->type, BodyType::static_body);
}

TEST(SetMass, doubling_the_mass_halves_the_acceleration) {
    World world{{.gravity = {}}};
    const BodyId ball = *world.create_body({}, {.geometry = Sphere{0.5}, .mass = 2});
    const double spin = world.body(ball)->inertia.x.x;
    ASSERT_TRUE(world.set_mass(ball, 4).ok());
    EXPECT_EQ(world.body(ball)->mass, 4);
    EXPECT_NEAR(world.body(ball)->inertia.x.x, 2 * spin, 1e-12);
    ASSERT_TRUE(world.apply_impulse(ball, {8, 0, 0}, {}).ok());
    EXPECT_NEAR(world.body(ball)->linear_velocity.x, 2, 1e-12);
    ASSERT_TRUE(world.set_mass(ball, 0).ok());
    EXPECT_EQ(world.body(ball)->mass, 2) << "back to what its shape gives";
}

TEST(SetAwake, puts_a_touching_pair_to_sleep_and_reports_it) {
    Floor f;
    const BodyId low = f.cube({0, 0.5, 0}), high = f.cube({0, 1.5, 0}), far = f.cube({9, 0.5, 0});
    run(f.world, 3);
    ASSERT_TRUE(f.world.set_awake(high, false).ok());
    expect_sound(f.world);
    EXPECT_FALSE(f.world.body(low)->awake) << "it is of the same island";
    EXPECT_FALSE(f.world.body(high)->awake);
    EXPECT_TRUE(f.world.body(far)->awake);
    run(f.world, 1);
    ASSERT_EQ(f.world.events().fell_asleep.size(), 2u);
    EXPECT_EQ(f.world.events().fell_asleep[0], low);
    ASSERT_TRUE(f.world.set_awake(low, true).ok());
    EXPECT_TRUE(f.world.body(high)->awake);
}

TEST(SetAwake, is_rejected_if_sleeping_is_disabled) {
    World world{{.sleeping = false}};
    const BodyId ball = *world.create_body({}, {.geometry = Sphere{0.5}});
    const Status status = world.set_awake(ball, false);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::failed_precondition);
}

TEST(SetSleepAllowed, body_that_may_not_sleep_stays_awake_for_five_seconds) {
    Floor f;
    const BodyId cube = f.cube({0, 0.5, 0});
    EXPECT_TRUE(f.world.body(cube)->sleep_allowed);
    ASSERT_TRUE(f.world.set_sleep_allowed(cube, false).ok());
    run(f.world, 300);
    EXPECT_TRUE(f.world.body(cube)->awake);
    ASSERT_TRUE(f.world.set_sleep_allowed(cube, true).ok());
    run(f.world, 60);
    EXPECT_FALSE(f.world.body(cube)->awake);
}

TEST(SetGravity, sleeping_body_wakes_and_falls_upwards) {
    Floor f;
    const BodyId cube = f.cube({0, 0.5, 0});
    run(f.world, 120);
    ASSERT_FALSE(f.world.body(cube)->awake);
    ASSERT_TRUE(f.world.set_gravity({0, 2, 0}).ok());
    EXPECT_EQ(f.world.gravity(), (Vec3{0, 2, 0}));
    run(f.world, 60);
    EXPECT_NEAR(f.height(cube), 0.5 + 0.5 * 2 * 1, 0.02);  // g t^2 / 2
    EXPECT_FALSE(f.world.set_gravity({0, 1e9, 0}).ok());
    EXPECT_EQ(f.world.gravity(), (Vec3{0, 2, 0})) << "refused and unchanged";
}

}  // namespace
}  // namespace jostle::physics
