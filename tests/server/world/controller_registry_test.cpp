// SPDX-License-Identifier: MIT
//
// Who drives what, by way of a module that lets two of its balls be pushed about.
#include "server/world/controller_registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace jostle::server {
namespace {

using namespace physics;

// Pushes each of its balls to the right by the first axis, N.
class Rollers final : public Module {
public:
    std::string_view tag() const override { return "rollers"; }
    void visit(StateVisitor&) override {}
    bool is_controllable(BodyId body) const override {
        return std::ranges::any_of(balls, [&](const auto& ball) { return ball.first == body; });
    }
    void control(World&, BodyId body, const Controls& controls) override {
        for (auto& [ball, held] : balls)
            if (ball == body) held = controls;
    }
    void before_step(World& world, double) override {
        for (const auto& [ball, held] : balls)
            world.apply_force(ball, {held.axes[0], 0, 0}, world.body(ball)->center).expect();
    }

    std::vector<std::pair<BodyId, Controls>> balls;
};

class ControllerRegistryTest : public testing::Test {
protected:
    ControllerRegistryTest() {
        auto module = std::make_unique<Rollers>();
        rollers = module.get();
        for (int k = 0; k < 2; k++) rollers->balls.push_back({add(), {}});
        EXPECT_TRUE(world.add_module(std::move(module)).ok());
        one = rollers->balls[0].first;
        two = rollers->balls[1].first;
    }
    BodyId add() {
        const Vec3 at{0, 0, 5.0 * static_cast<double>(world.bodies().size())};
        return *world.create_body({.pose = {.position = at}}, {.geometry = Sphere{0.5}});
    }
    std::string complaint(ClientId client, BodyId body) {
        const Status status = controllers.possess(world, client, body);
        return status.ok() ? "" : status.error().message;
    }
    double held(BodyId body) const {
        for (const auto& [ball, controls] : rollers->balls)
            if (ball == body) return controls.axes[0];
        return -99;
    }

    World world = std::move(*World::create({.gravity = {}}));
    Rollers* rollers = nullptr;
    BodyId one, two;
    ControllerRegistry controllers;
};

constexpr Controls right{.axes = {1}}, half{.axes = {0.5}};

TEST_F(ControllerRegistryTest, forwards_controls_to_the_module) {
    EXPECT_FALSE(controllers.control(world, 1, right)) << "drives nothing yet";
    EXPECT_EQ(complaint(1, one), "");
    EXPECT_EQ(controllers.control(world, 1, right), one);
    EXPECT_EQ(held(one), 1);
    for (int k = 0; k < 60; k++) ASSERT_TRUE(world.step(1.0 / 60).ok());
    const double mass = world.body(one)->mass;
    EXPECT_NEAR(world.body(one)->linear_velocity.x, 1 / mass, 1e-6) << "1 N for a second";
    EXPECT_EQ(world.body(two)->linear_velocity.x, 0);
}

TEST_F(ControllerRegistryTest, one_client_drives_one_body_and_one_body_has_one_driver) {
    EXPECT_EQ(complaint(1, one), "");
    EXPECT_EQ(complaint(2, one), "another client controls the entity");
    EXPECT_EQ(complaint(1, one), "") << "again";
    EXPECT_EQ(controllers.control(world, 1, right), one);
    EXPECT_EQ(complaint(1, two), "");
    EXPECT_EQ(held(one), 0) << "let go of";
    EXPECT_EQ(complaint(2, one), "");
    EXPECT_EQ(controllers.control(world, 2, half), one);
    EXPECT_EQ(held(one), 0.5);
}

TEST_F(ControllerRegistryTest, rejects_uncontrollable_bodies) {
    const BodyId other = add();
    EXPECT_FALSE(is_controllable(world, other));
    EXPECT_TRUE(is_controllable(world, one));
    EXPECT_EQ(complaint(1, other), "the entity is not controllable");
}

TEST_F(ControllerRegistryTest, leaving_releases_control) {
    ASSERT_EQ(complaint(1, one), "");
    controllers.control(world, 1, right);
    controllers.release(world, 1);
    EXPECT_EQ(held(one), 0);
    EXPECT_FALSE(controllers.control(world, 1, right));
}

TEST_F(ControllerRegistryTest, removed_body_has_no_controller) {
    ASSERT_EQ(complaint(1, one), "");
    ASSERT_EQ(complaint(2, two), "");
    controllers.release_body(world, one);
    EXPECT_FALSE(controllers.control(world, 1, right));
    EXPECT_TRUE(controllers.control(world, 2, right));
    rollers->balls.clear();
    EXPECT_FALSE(controllers.control(world, 2, right)) << "the module let go of it";
}

}  // namespace
}  // namespace jostle::server
