// SPDX-License-Identifier: MIT
//
// Shapes near a deformable, against the queries of the world and closed forms.
#include "jostle/physics/nearby_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

World cluttered() {
    World world = make_world();
    add_floor(world);
    Random random(3);
    for (int k = 0; k < 60; k++)
        add(world, {.geometry = k % 3 == 0   ? Geometry(Sphere{0.4})
                                : k % 3 == 1 ? Geometry(Box{{0.3, 0.5, 0.2}})
                                             : Geometry(Capsule{0.2, 0.4}),
                    .position = random.vector(6) + Vec3{0, 6, 0},
                    .rotation = random.rotation()});
    return world;
}

TEST(NearbyShapes, finds_the_closest_points_that_the_world_finds) {
    const World world = cluttered();
    NearbyShapes shapes;
    shapes.collect(world, {{-4, -1, -4}, {4, 9, 4}}, 1.0 / 60);
    ASSERT_GT(shapes.size(), 20u);
    Random random(7);
    std::vector<Vec3> points;
    for (int k = 0; k < 300; k++) points.push_back(random.vector(3) + Vec3{0, 4, 0});
    std::vector<std::optional<ClosestPoint>> nearest(points.size());
    shapes.closest_points(points, 0.8, nearest);
    int found = 0;
    for (std::size_t k = 0; k < points.size(); k++) {
        const auto expected = must(world.queries().closest_point(points[k], 0.8));
        ASSERT_EQ(nearest[k].has_value(), expected.has_value()) << k;
        if (!expected) continue;
        found++;
        EXPECT_EQ(nearest[k]->shape, expected->shape);
        EXPECT_NEAR(nearest[k]->distance, expected->distance, 1e-9);
        EXPECT_LT(length(nearest[k]->normal - expected->normal), 1e-6);
    }
    EXPECT_GT(found, 50);
}

// Listeners may create and destroy bodies after the shapes were collected.
TEST(NearbyShapes, do_not_change_with_the_world) {
    World world = test::make_world({.gravity = {}});
    const BodyId ball = test::add(world, {.geometry = Sphere{0.5}, .position = {0, 1, 0}});
    NearbyShapes shapes;
    shapes.collect(world, {{-2, -2, -2}, {2, 2, 2}}, dt);
    test::must(world.destroy_body(ball));
    for (int k = 0; k < 2000; k++) test::add(world, {.position = {3.0 * k, 20, 0}});
    const Vec3 point{0, 2, 0};
    std::optional<ClosestPoint> nearest;
    shapes.closest_points({&point, 1}, 1, {&nearest, 1});
    ASSERT_TRUE(nearest);
    EXPECT_NEAR(nearest->distance, 0.5, 1e-12);
    EXPECT_EQ(nearest->body, ball);
}

TEST(NearbyShapes, includes_bodies_that_come_near_within_the_step) {
    World world = make_world({.gravity = {}});
    const BodyId fast = add(world, {.geometry = Sphere{0.1}, .position = {20, 0, 0}});
    const BodyId slow = add(world, {.geometry = Sphere{0.1}, .position = {20, 3, 0}});
    must(world.set_velocity(fast, {-1200, 0, 0}, {}));
    must(world.set_velocity(slow, {-600, 0, 0}, {}));
    NearbyShapes shapes;
    shapes.collect(world, {{-1, -1, -1}, {1, 4, 1}}, 1.0 / 60);
    ASSERT_EQ(shapes.size(), 1u);  // 20 m in 1/60 s; the other one moves 10 m
    EXPECT_EQ(shapes.bodies()[0].id, fast);
}

TEST(NearbyShapes, moves_kinematic_bodies_to_the_time_of_the_sub_step) {
    World world = make_world();
    const BodyId platform =
        must(world.create_body({.type = BodyType::kinematic, .pose = {{0, 1, 0}, {}}},
                               {.geometry = Box{{1, 0.5, 1}}, .pose = {{2, 0, 0}, {}}}));
    must(world.set_velocity(platform, {0, 3, 0}, {0, 2, 0}));
    NearbyShapes shapes;
    shapes.collect(world, {{-4, -1, -4}, {4, 4, 4}}, 0.1);
    shapes.move_to(0.05);
    // After 0.05 s the centre of the box is 2 m from its origin, turned by 0.1 rad, and 0.15 m up.
    std::optional<ClosestPoint> nearest[1];
    const Vec3 point[1] = {{2 * std::cos(0.1), 3, -2 * std::sin(0.1)}};
    shapes.closest_points(point, 2, nearest);
    ASSERT_TRUE(nearest[0]);
    EXPECT_NEAR(nearest[0]->distance, 3 - 1.65, 1e-9);
    EXPECT_LT(length(nearest[0]->normal - Vec3{0, 1, 0}), 1e-9);
}

TEST(NearbyShapes, touch_a_capsule_as_closed_forms_say) {
    World world = make_world();
    add_floor(world);
    add(world, {.geometry = Sphere{0.5}, .position = {5, 2, 0}, .type = BodyType::static_body});
    NearbyShapes shapes;
    shapes.collect(world, {{-10, -1, -2}, {10, 4, 2}}, 0.1);
    std::vector<CapsuleContact> contacts;
    // A rope of 2 cm lies 1 cm over the floor.
    shapes.capsule_contacts({-1, 0.03, 0}, {1, 0.03, 0}, 0.02, 0.05, contacts);
    ASSERT_EQ(contacts.size(), 2u);
    for (const CapsuleContact& contact : contacts) {
        EXPECT_NEAR(contact.gap, 0.01, 1e-9);
        EXPECT_NEAR(contact.normal.y, 1, 1e-9);
    }
    EXPECT_NEAR(std::abs(contacts[0].fraction - contacts[1].fraction), 1, 1e-6);
    // It touches the ball at a quarter of its length, 1 mm deep.
    contacts.clear();
    shapes.capsule_contacts({4, 2.519, 0}, {8, 2.519, 0}, 0.02, 0.05, contacts);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_NEAR(contacts[0].gap, -0.001, 1e-6);
    EXPECT_NEAR(contacts[0].fraction, 0.25, 1e-3);
    EXPECT_NEAR(contacts[0].normal.y, 1, 1e-6);
    // Too far away.
    contacts.clear();
    shapes.capsule_contacts({4, 2.6, 0}, {8, 2.6, 0}, 0.02, 0.05, contacts);
    EXPECT_TRUE(contacts.empty());
}

TEST(NearbyShapes, skip_shapes_of_other_categories_and_one_body) {
    World world = make_world();
    const BodyId a = add(world, {.geometry = Sphere{0.5}, .position = {0, 0, 0}});
    add(world, {.geometry = Sphere{0.5}, .position = {1, 0, 0}});
    NearbyShapes shapes;
    const Aabb box{{-2, -2, -2}, {2, 2, 2}};
    shapes.collect(world, box, 0.01, {.ignore = a});
    EXPECT_EQ(shapes.size(), 1u);
    EXPECT_NE(shapes.bodies()[shapes.body_of(0)].id, a);
    shapes.collect(world, box, 0.01, {.categories = 0});
    EXPECT_EQ(shapes.size(), 0u);
}

}  // namespace
}  // namespace jostle::test
