// SPDX-License-Identifier: MIT
#include "jostle/modules/carried_bodies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/world_builder.h"

namespace jostle::modules {
namespace {

using namespace physics;
using test::add;
using test::must;

constexpr double dt = 1.0 / 60;

// Attaches to a body and pushes it at a point in each sub-step.
struct Pusher : StepListener {
    CarriedBodies bodies;
    NearbyShapes nearby;
    Vec3 impulse, point;

    StepHooks hooks() const override { return {.substeps = true, .concurrent = false}; }
    void before_substep(SubstepContext& substep) override {
        if (!bodies.ties().owned_by(substep)) return;
        bodies.read(&substep);
        CarriedBody& body = *bodies.attached(0);
        body.push(impulse, body.arm_to(point));
        bodies.move(substep.h());
        bodies.write(&substep);
    }
};

// A cube of 1 m and 1000 kg, pushed at its corner.
TEST(CarriedBodies, give_the_body_exactly_the_impulses) {
    World world = test::make_world({.gravity = {}});
    const BodyId cube = add(world, {.position = {0, 5, 0}});
    Pusher pusher;
    pusher.impulse = {1, 0, 0};
    pusher.point = {0, 0.5, 0};
    pusher.bodies.begin_step(world, {Support{cube}});
    pusher.bodies.tie(world);
    pusher.bodies.find(world, pusher.nearby);
    must(world.add_listener(pusher));
    must(world.step(dt));
    must(world.remove_listener(pusher));
    const double pushes = world.body(cube)->linear_velocity.x * 1000;
    EXPECT_NEAR(pushes, std::round(pushes), 1e-4);
    EXPECT_GE(pushes, 1);
    // Impulse times arm over the moment of inertia, m a^2 / 6.
    EXPECT_NEAR(world.body(cube)->angular_velocity.z, -pushes * 0.5 / (1000.0 / 6), 1e-4 * pushes);
    EXPECT_TRUE(pusher.bodies.finish_step(world)) << "slower than 5 cm/s";
}

TEST(CarriedBodies, follow_pushes_within_a_sub_step) {
    World world = test::make_world({.gravity = {0, -10, 0}});
    const BodyId cube = add(world, {.position = {0, 5, 0}, .velocity = {2, 0, 0}});
    CarriedBodies bodies;
    NearbyShapes nearby;
    bodies.begin_step(world, {Support{cube}, Support{}});
    bodies.find(world, nearby);
    ASSERT_EQ(bodies.all().size(), 1u);
    EXPECT_EQ(bodies.attached(1), nullptr) << "the world";
    EXPECT_EQ(bodies.attached(2), nullptr);
    CarriedBody& body = *bodies.attached(0);
    EXPECT_TRUE(body.is_pushed());
    EXPECT_NEAR(length(body.travel_of({}, 0.1) - Vec3{0.2, -0.1, 0}), 0, 1e-12);
    body.push({0, 500, 0}, {});
    EXPECT_NEAR(body.velocity.y, 0.5, 1e-9);
    bodies.move(0.1);
    EXPECT_NEAR(length(body.center - Vec3{0.2, 5 - 0.05, 0}), 0, 1e-9);
    EXPECT_NEAR(bodies.greatest_speed(), length(Vec3{2, -0.5, 0}), 1e-9);
}

TEST(CarriedBodies, wake_sleeping_bodies_by_large_impulses_only) {
    for (const double impulse : {10.0, 30.0}) {  // 1 and 3 cm/s
        World world = test::make_world();
        test::add_floor(world);
        const BodyId cube = add(world, {.position = {0, 0.5, 0}});
        for (int k = 0; k < 120 && world.body(cube)->awake; k++) must(world.step(dt));
        ASSERT_FALSE(world.body(cube)->awake);
        CarriedBodies bodies;
        NearbyShapes nearby;
        bodies.begin_step(world, {Support{cube}});
        bodies.find(world, nearby);
        EXPECT_FALSE(bodies.attached(0)->is_pushed()) << "it sleeps";
        bodies.attached(0)->push({impulse, 0, 0}, {});
        EXPECT_TRUE(bodies.finish_step(world));
        EXPECT_EQ(world.body(cube)->awake, impulse > 20) << impulse;
    }
}

TEST(CarriedBodies, stay_tied_for_ten_steps_after_a_contact) {
    World world = test::make_world();
    const BodyId cube = add(world, {.position = {0, 5, 0}});
    CarriedBodies bodies;
    EXPECT_TRUE(bodies.touch(cube));
    EXPECT_FALSE(bodies.touch(cube));
    int steps = 0;
    for (; steps < 20 && bodies.was_touched(cube); steps++) {
        bodies.begin_step(world, {});
        bodies.forget_old_contacts();
        bodies.tie(world);
        EXPECT_EQ(bodies.ties().bodies().size(), bodies.was_touched(cube) ? 1u : 0u);
    }
    EXPECT_EQ(steps, 11);
    EXPECT_TRUE(bodies.touch(cube));
    must(world.destroy_body(cube));
    bodies.begin_step(world, {});
    EXPECT_FALSE(bodies.was_touched(cube));
}

}  // namespace
}  // namespace jostle::modules
