// SPDX-License-Identifier: MIT
//
// What is asked wrongly is refused with a sentence that names the argument, and the world is as it
// was.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

class BadInput : public testing::Test {
protected:
    void SetUp() override {
        floor_ = add_floor(world_);
        box_ = add(world_, {.position = {0, 0.6, 0}});
        platform_ = add(world_, {.position = {5, 1, 0}, .type = BodyType::kinematic});
        const BodyId gone = add(world_, {.position = {9, 9, 9}});
        stale_shape_ = world_.shapes_of(gone)[0];
        must(world_.destroy_body(gone));
        stale_ = gone;
        run(world_, 0.1);
        hash_ = state_hash(world_);
        bytes_ = save(world_);
    }

    // The outcome is an error whose message has `word`, and nothing changed.
    template <class Outcome>
    void refuses(const Outcome& outcome, const char* word,
                 ErrorCode code = ErrorCode::invalid_argument) {
        ASSERT_FALSE(outcome.ok()) << "accepted; expected a complaint about " << word;
        EXPECT_THAT(outcome.error().message, HasSubstr(word));
        EXPECT_EQ(outcome.error().code, code) << outcome.error().message;
        EXPECT_EQ(state_hash(world_), hash_) << outcome.error().message;
        EXPECT_EQ(save(world_), bytes_) << outcome.error().message;
    }
    void refuses_body(const BodyDef& def, const char* word) {
        refuses(world_.create_body(def), word);
        refuses(world_.create_body(def, ShapeDef{}), word);
    }
    void refuses_shape(const ShapeDef& def, const char* word, BodyType type = BodyType::dynamic) {
        refuses(world_.create_body({.type = type}, def), word);
        refuses(world_.create_shape(type == BodyType::dynamic ? box_ : floor_, def), word);
    }

    World world_ = make_world();
    BodyId floor_, box_, platform_, stale_;
    ShapeId stale_shape_;
    std::uint64_t hash_ = 0;
    std::vector<std::byte> bytes_;
};

TEST_F(BadInput, rejects_invalid_world_defs) {
    const auto refused = [](const WorldDef& def, const char* word) {
        const auto world = World::create(def);
        ASSERT_FALSE(world.ok()) << word;
        EXPECT_THAT(world.error().message, HasSubstr(word));
    };
    refused({.gravity = {0, nan, 0}}, "gravity");
    refused({.gravity = {0, -inf, 0}}, "gravity");
    refused({.gravity = {1e9, 0, 0}}, "gravity");
    refused({.tolerance = -1e-3}, "tolerance");
    refused({.tolerance = 1e-10}, "tolerance");
    refused({.tolerance = 1e-3, .substep_budget = -1}, "substep_budget");
    refused({.step_budget = -1}, "step_budget");
    refused({.tolerance = 1e-3, .step_budget = 1000}, "set one of them to 0");
    refused({.substeps = 0}, "substeps");
    refused({.substeps = 65}, "substeps");
    refused({.joint_solver = static_cast<JointSolver>(3)},
            "joint_solver is 3; it must be automatic (0), iterative (1) or direct (2)");
    refused({.threads = 0}, "threads");
    refused({.threads = 65}, "threads");
    refused({.threads = -1}, "threads");
}

TEST_F(BadInput, rejects_invalid_body_defs) {
    refuses_body({.pose = {{nan, 0, 0}, {}}}, "position");
    refuses_body({.pose = {{0, inf, 0}, {}}}, "position");
    refuses_body({.pose = {{0, 0, 1e8}, {}}}, "position");
    refuses_body({.pose = {{}, {0, 0, 0, 0}}}, "rotation");
    refuses_body({.pose = {{}, {nan, 0, 0, 1}}}, "rotation");
    refuses_body({.linear_velocity = {nan, 0, 0}}, "linear_velocity");
    refuses_body({.linear_velocity = {0, 0, 1e5}}, "linear_velocity");
    refuses_body({.angular_velocity = {0, -inf, 0}}, "angular_velocity");
    refuses_body({.linear_damping = -1}, "linear_damping");
    refuses_body({.linear_damping = nan}, "linear_damping");
    refuses_body({.angular_damping = -0.1}, "angular_damping");
    refuses_body({.gravity_scale = inf}, "gravity_scale");
    refuses(world_.create_body({.type = BodyType::static_body, .linear_velocity = {1, 0, 0}}),
            "velocity");
}

TEST_F(BadInput, rejects_invalid_shape_defs) {
    for (const double size : {0.0, -1.0, nan, inf, 1e-9, 1e9}) {
        refuses_shape({.geometry = Sphere{size}}, "radius");
        refuses_shape({.geometry = Capsule{size, 1}}, "radius");
        refuses_shape({.geometry = Capsule{1, size}}, "half_length");
        refuses_shape({.geometry = Box{{size, 1, 1}}}, "half_extents.x");
        refuses_shape({.geometry = Box{{1, size, 1}}}, "half_extents.y");
        refuses_shape({.geometry = Box{{1, 1, size}}}, "half_extents.z");
    }
    refuses_shape({.geometry = Plane{{0, 0, 0}}}, "normal", BodyType::static_body);
    refuses_shape({.geometry = Plane{{0, nan, 0}}}, "normal", BodyType::static_body);
    refuses_shape({.pose = {{nan, 0, 0}, {}}}, "position");
    refuses_shape({.pose = {{}, {0, 0, 0, 0}}}, "rotation");
    refuses_shape({.material = {.friction = -0.5}}, "friction");
    refuses_shape({.material = {.friction = nan}}, "friction");
    refuses_shape({.material = {.restitution = 1.5}}, "restitution");
    refuses_shape({.material = {.restitution = -0.1}}, "restitution");
    for (const double density : {0.0, -1000.0, nan, inf, 1e12})
        refuses_shape({.density = density}, "density");
}

TEST_F(BadInput, rejects_planes_on_moving_bodies) {
    refuses(world_.create_body({}, {.geometry = Plane{}}), "plane");
    refuses(world_.create_body({.type = BodyType::kinematic}, {.geometry = Plane{}}), "plane");
    refuses(world_.create_shape(box_, {.geometry = Plane{}}), "plane");
}

TEST_F(BadInput, rejects_invalid_ids) {
    for (const BodyId id : {BodyId{}, BodyId{1000, 0}, stale_, BodyId{box_.index, 77}}) {
        const auto not_found = ErrorCode::not_found;
        EXPECT_FALSE(world_.contains(id));
        EXPECT_TRUE(world_.shapes_of(id).empty());
        refuses(world_.body(id), "body", not_found);
        refuses(world_.create_shape(id, {}), "body", not_found);
        refuses(world_.destroy_body(id), "body", not_found);
        refuses(world_.set_pose(id, {}), "body", not_found);
        refuses(world_.set_velocity(id, {}, {}), "body", not_found);
        refuses(world_.apply_impulse(id, {}, {}), "body", not_found);
        refuses(world_.apply_angular_impulse(id, {}), "body", not_found);
        refuses(world_.apply_force(id, {}, {}), "body", not_found);
        refuses(world_.apply_torque(id, {}), "body", not_found);
        refuses(world_.wake(id), "body", not_found);
    }
    for (const ShapeId id : {ShapeId{}, ShapeId{1000, 0}, stale_shape_}) {
        EXPECT_FALSE(world_.contains(id));
        refuses(world_.shape(id), "shape", ErrorCode::not_found);
        refuses(world_.destroy_shape(id), "shape", ErrorCode::not_found);
    }
}

TEST_F(BadInput, new_body_does_not_match_the_old_id) {
    const BodyId fresh = add(world_, {.position = {20, 1, 0}});
    EXPECT_EQ(fresh.index, stale_.index);
    EXPECT_NE(fresh.generation, stale_.generation);
    EXPECT_FALSE(world_.contains(stale_));
    EXPECT_TRUE(world_.contains(fresh));
}

TEST_F(BadInput, rejects_invalid_impulses_and_forces) {
    const auto precondition = ErrorCode::failed_precondition;
    refuses(world_.apply_impulse(box_, {nan, 0, 0}, {}), "impulse");
    refuses(world_.apply_impulse(box_, {1, 0, 0}, {0, inf, 0}), "point");
    refuses(world_.apply_angular_impulse(box_, {0, nan, 0}), "impulse");
    refuses(world_.apply_force(box_, {0, 0, nan}, {}), "force");
    refuses(world_.apply_force(box_, {}, {nan, 0, 0}), "point");
    refuses(world_.apply_torque(box_, {inf, 0, 0}), "torque");
    refuses(world_.set_velocity(box_, {nan, 0, 0}, {}), "linear");
    refuses(world_.set_velocity(box_, {}, {0, 0, 1e6}), "angular");
    refuses(world_.set_pose(box_, {{0, nan, 0}, {}}), "position");
    refuses(world_.set_pose(box_, {{0, 2e7, 0}, {}}), "position");
    refuses(world_.set_pose(box_, {{}, {0, 0, 0, 0}}), "rotation");
    for (const BodyId id : {floor_, platform_}) {
        refuses(world_.apply_impulse(id, {1, 0, 0}, {}), "dynamic", precondition);
        refuses(world_.apply_force(id, {1, 0, 0}, {}), "dynamic", precondition);
        refuses(world_.apply_torque(id, {1, 0, 0}), "dynamic", precondition);
        refuses(world_.apply_angular_impulse(id, {1, 0, 0}), "dynamic", precondition);
    }
    refuses(world_.set_velocity(floor_, {1, 0, 0}, {}), "static", precondition);
    refuses(world_.destroy_shape(world_.shapes_of(box_)[0]), "last shape", precondition);
}

TEST_F(BadInput, rejects_invalid_steps_and_threads) {
    for (const double dt : {0.0, -1.0 / 60, 1e-9, 1.0, nan, inf}) refuses(world_.step(dt), "dt");
    for (const int threads : {0, -3, 65}) refuses(world_.set_threads(threads), "threads");
    EXPECT_EQ(world_.step_count(), 6u);
}

TEST_F(BadInput, rejects_invalid_queries) {
    refuses(world_.queries().cast_ray({{nan, 0, 0}, {1, 0, 0}}), "origin");
    refuses(world_.queries().cast_ray({{0, 0, 0}, {inf, 0, 0}}), "motion");
    refuses(world_.queries().cast_ray({{0, 0, 0}, {0, 0, 0}}), "motion");
    refuses(world_.queries().overlap_box({{nan, 0, 0}, {1, 1, 1}}), "box");
    refuses(world_.queries().overlap_box({{1, 1, 1}, {0, 2, 2}}), "box");
    refuses(world_.queries().overlap_shape(Sphere{-1}, {}), "radius");
    refuses(world_.queries().overlap_shape(Plane{}, {}), "plane");
    refuses(world_.queries().overlap_shape(Sphere{}, {{nan, 0, 0}, {}}), "position");
}

// A quaternion of any length but zero is a rotation: it is stored as a unit one.
TEST_F(BadInput, normalizes_quaternions) {
    const BodyId turned = must(world_.create_body({.pose = {{0, 9, 0}, {0, 3, 0, 4}}}, ShapeDef{}));
    const Quat q = state_of(world_, turned).pose.rotation;
    EXPECT_NEAR(q.y, 0.6, 1e-15);
    EXPECT_NEAR(q.w, 0.8, 1e-15);
}

}  // namespace
}  // namespace jostle::test
