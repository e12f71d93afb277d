// SPDX-License-Identifier: MIT
//
// Fat boxes, how long a shape stays in them, and who is told of a new one.
#include "physics/src/state/shape_proxy.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double radius = 0.5;

// A ball of 0.5 m at the origin that flies along x.
struct Ball {
    World world = make_world();
    WorldState& state = state_of(world);
    std::uint32_t body = 0, shape = 0;

    explicit Ball(double speed) {
        body = add(world, {.geometry = Sphere{radius}, .velocity = {speed, 0, 0}}).index;
    }
    BodyWarm& warm() { return warm_of(state, body); }
    ShapeRecord& record() { return state.shapes.shapes[shape]; }
    bool is_found_at(Vec3 point) const {
        std::vector<std::uint32_t> found;
        state.shapes.moving->query({point, point}, ~0u, found);
        return !found.empty();
    }
};

// 4 cm on each side, and three steps of 0.1 m ahead.
TEST(ShapeProxy, fat_box_extends_three_steps_ahead) {
    Ball ball(6);
    enlarge_aabb(ball.state.bodies, ball.state.shapes, ball.shape, ball.warm(), dt);
    EXPECT_TRUE(near(ball.record().fat.low, {-0.54, -0.54, -0.54}, 1e-12));
    EXPECT_TRUE(near(ball.record().fat.high, {0.84, 0.54, 0.54}, 1e-12));
}

// No further than two radii, but a step whatever it is: 1 m at 30 m/s, 2 m at 120.
TEST(ShapeProxy, fat_box_of_a_fast_ball_extends_two_radii_or_one_step) {
    for (const auto& [speed, ahead] : {std::pair{30.0, 1.0}, {120.0, 2.0}}) {
        Ball ball(speed);
        enlarge_aabb(ball.state.bodies, ball.state.shapes, ball.shape, ball.warm(), dt);
        EXPECT_NEAR(ball.record().fat.high.x, 0.54 + ahead, 1e-12);
    }
}

// What remains of the 4 cm when a centimetre is kept for manifolds that begin before they meet:
// 3 cm now, and less by what the next step takes.
TEST(ShapeProxy, margin_is_reported_now_and_after_a_step) {
    Ball ball(0);
    enlarge_aabb(ball.state.bodies, ball.state.shapes, ball.shape, ball.warm(), dt);
    ball.warm().v = {0, -1.5, 0};  // 2.5 cm a step
    const AabbMargin margin = margin_in_fat_aabb(ball.record(), ball.warm(), radius, dt);
    EXPECT_NEAR(margin.now, 0.03, 1e-12);
    EXPECT_NEAR(margin.next, 0.005, 1e-12);
    EXPECT_TRUE(fits_fat_aabb(ball.record(), ball.warm(), radius, dt));
    ball.warm().center.y = -0.006;
    EXPECT_FALSE(fits_fat_aabb(ball.record(), ball.warm(), radius, dt));
}

// Of a ball of 1 mm a fiftieth: its neighbours are near.
TEST(ShapeProxy, fat_box_of_a_small_shape_is_proportional) {
    World world = make_world();
    WorldState& state = state_of(world);
    const std::uint32_t body = add(world, {.geometry = Sphere{0.001}}).index;
    enlarge_aabb(state.bodies, state.shapes, 0, warm_of(state, body), dt);
    EXPECT_TRUE(near(state.shapes.shapes[0].fat.high, {0.0018, 0.0018, 0.0018}, 1e-12));
}

TEST(ShapeProxy, enlarged_proxy_is_found_and_queued_once) {
    Ball ball(0);
    must(ball.world.step(dt));
    ASSERT_TRUE(ball.state.shapes.moved.empty());
    ball.warm().center = {100, 0, 0};
    EXPECT_FALSE(ball.is_found_at({100, 0, 0}));
    enlarge_proxy(ball.state, ball.shape, ball.warm(), dt);
    enlarge_proxy(ball.state, ball.shape, ball.warm(), dt);
    EXPECT_TRUE(ball.is_found_at({100, 0, 0}));
    EXPECT_FALSE(ball.is_found_at({0, 0, 0}));
    EXPECT_EQ(ball.state.shapes.moved, std::vector{ball.shape});
}

// Planes are in no tree; triggers stand in a list of their own, and what was inside is told.
TEST(ShapeProxy, destroyed_proxy_is_in_no_list) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 1, 0}});
    must(world.create_shape(box, {.geometry = Sphere{2}, .trigger = true}));
    add(world, {.geometry = Sphere{0.1}, .position = {1.5, 1, 0}});
    WorldState& state = state_of(world);
    ASSERT_EQ(state.shapes.planes, std::vector<std::uint32_t>{0});
    ASSERT_EQ(state.shapes.triggers, std::vector<std::uint32_t>{2});
    must(world.step(dt));
    const auto inside = static_cast<std::size_t>(
        std::count_if(state.triggers.inside.begin(), state.triggers.inside.end(),
                      [](const Inside& pair) { return pair.trigger == 2 && pair.shape == 3; }));
    ASSERT_EQ(inside, 1u);
    buffer_move(state.shapes, state.triggers, 2);
    ASSERT_EQ(state.triggers.fresh, std::vector<std::uint32_t>{2});
    const std::size_t all = state.triggers.inside.size();
    std::vector<TriggerEvent> left;
    destroy_proxy(state, 2, left);
    destroy_proxy(state, 0, left);
    EXPECT_TRUE(state.shapes.planes.empty());
    EXPECT_TRUE(state.shapes.triggers.empty());
    EXPECT_TRUE(state.triggers.fresh.empty());
    EXPECT_TRUE(state.triggers.inside.empty());
    EXPECT_EQ(left.size(), all);
    EXPECT_EQ(state.shapes.shapes[2].leaf, -1);
    EXPECT_EQ(std::count(state.shapes.moved.begin(), state.shapes.moved.end(), 2u), 0);
    create_proxy(state, 2);
    create_proxy(state, 0);
    EXPECT_EQ(state.shapes.planes, std::vector<std::uint32_t>{0});
    EXPECT_GE(state.shapes.shapes[2].leaf, 0);
}

// A plane through (0, 1, 0) that leans by 45 degrees.
TEST(ShapeProxy, box_reaches_a_plane_with_its_lowest_corner) {
    World world = make_world();
    add_static(world, {.geometry = Plane{{1, 1, 0}}, .position = {0, 1, 0}});
    const WorldState& state = state_of(world);
    const auto reaches = [&](Vec3 low) {
        return reaches_plane(state, state.shapes.shapes[0], {low, low + Vec3{1, 1, 1}});
    };
    EXPECT_TRUE(reaches({0.49, 0.49, 5}));
    EXPECT_FALSE(reaches({0.51, 0.51, 5}));
    EXPECT_TRUE(reaches({-9, 9.99, 5}));
}

// Half as much again as its speed in a step and twice what gravity adds: at 6 m/s 0.15 m and 2.7
// mm.
TEST(ShapeProxy, motion_bound_allows_one_and_a_half_times_the_motion) {
    Ball ball(6);
    ball.state.bodies.motion[0].travel = 10;
    update_motion_bound(ball.state, 0, dt);
    EXPECT_NEAR(ball.state.bodies.motion[0].bound, 10 + 1.5 * 0.1 + 9.81 * dt * dt, 1e-12);
    ball.warm().w = {0, 4, 0};  // its surface moves by 2 m/s
    ball.state.bodies.cold[0].gravity_scale = -2;
    update_motion_bound(ball.state, 0, dt);
    EXPECT_NEAR(ball.state.bodies.motion[0].bound, 10 + 1.5 * 8 * dt + 2 * 9.81 * dt * dt, 1e-12);
}

// A shape a metre beside its body's centre, on a body that is turned by a right angle.
TEST(ShapeProxy, derived_pose_places_the_shape_relative_to_its_body) {
    BodyCold cold;
    cold.local_center = {0, 0.25, 0};
    ShapeRecord shape{.geometry = Box{}, .pose = {.position = {1, 0.25, 0}}};
    derive_shape_pose(cold, shape);
    EXPECT_EQ(shape.offset, (Vec3{1, 0, 0}));
    EXPECT_TRUE(shape.aligned);
    BodyWarm warm{.center = {5, 0, 0}};
    warm.axes = to_matrix(from_axis_angle({0, 0, 1}, pi / 2));
    EXPECT_TRUE(near(transformed_shape(shape, warm).position, {5, 1, 0}, 1e-12));
    shape.pose.rotation = from_axis_angle({0, 0, 1}, pi / 2);
    derive_shape_pose(cold, shape);
    EXPECT_FALSE(shape.aligned);
    EXPECT_TRUE(near(transformed_shape(shape, warm).axes.x, {-1, 0, 0}, 1e-12))
        << "half a turn in all";
}

}  // namespace
}  // namespace jostle::test
