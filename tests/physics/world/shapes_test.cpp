// SPDX-License-Identifier: MIT
//
// Shapes are replaced, carry the user's data, and come in batches with their bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "jostle/physics/physics.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/step_time.h"

namespace jostle::physics {
namespace {

using test::dt;

TEST(SetShapes, cube_replaced_by_two_balls_rests_on_them) {
    World world;
    ASSERT_TRUE(world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).ok());
    const BodyId body =
        *world.create_body({.pose = {.position = {0, 0.5, 0}}}, {.geometry = Box{{0.5, 0.5, 0.5}}});
    for (int n = 0; n < 120; n++) ASSERT_TRUE(world.step(dt).ok());
    const ShapeId before = world.shapes_of(body)[0];
    const ShapeDef balls[] = {{.geometry = Sphere{0.25}, .pose = {.position = {-1, 0, 0}}},
                              {.geometry = Sphere{0.25}, .pose = {.position = {1, 0, 0}}}};
    const auto made = world.set_shapes(body, balls);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(world.shapes_of(body), *made);
    EXPECT_FALSE(world.contains(before));
    EXPECT_NEAR(world.body(body)->mass, 2 * 1000 * 4.0 / 3 * pi * 0.25 * 0.25 * 0.25, 1e-9);
    for (int n = 0; n < 120; n++) {
        ASSERT_TRUE(world.step(dt).ok());
        const auto fault = find_fault(state_of(world));
        ASSERT_FALSE(fault) << *fault;
    }
    EXPECT_NEAR(world.body(body)->center.y, 0.25, 0.005);
}

double seconds_to_make(std::size_t count) {
    std::vector<ShapeDef> shapes(count, {.geometry = Sphere{0.1}});
    for (std::size_t k = 0; k < count; k++)
        shapes[k].pose.position = {0.2 * static_cast<double>(k), 0, 0};
    double best = 1e9;
    for (int trial = 0; trial < 5; trial++) {
        World world;
        const std::clock_t start = std::clock();
        EXPECT_TRUE(world.create_body({}, shapes).ok());
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

// Four times as many shapes take four times as long, not sixteen.
TEST(CreateBody, creation_time_is_linear_in_the_shapes) {
    const double ratio = seconds_to_make(8000) / seconds_to_make(2000);
    RecordProperty("ratio", std::to_string(ratio));
    EXPECT_LT(ratio, 8);
}

// One after the other or all at once: the same body.
TEST(CreateBody, creating_with_all_shapes_equals_adding_them_one_by_one) {
    World world;
    const BodyDef def{
        .pose = {.position = {3, 1, -2}, .rotation = from_rotation_vector({1, 2, 0})}};
    const ShapeDef shapes[] = {{.geometry = Sphere{0.5}},
                               {.geometry = Box{{0.5, 1, 0.2}}, .pose = {.position = {1, 0, 0}}}};
    const BodyId at_once = *world.create_body(def, shapes);
    const BodyId after = *world.create_body(def, shapes[0]);
    ASSERT_TRUE(world.create_shape(after, shapes[1]).ok());
    EXPECT_NEAR(world.body(at_once)->mass, world.body(after)->mass, 1e-9);
    EXPECT_LT(length(world.body(at_once)->center - world.body(after)->center), 1e-12);
    EXPECT_EQ(world.shapes_of(at_once).size(), 2u);
    const auto fault = find_fault(state_of(world));
    EXPECT_FALSE(fault) << *fault;
}

TEST(SetShapes, invalid_shape_changes_nothing_and_is_named) {
    World world;
    const BodyId body = *world.create_body({}, {.geometry = Sphere{0.5}});
    const ShapeDef shapes[] = {{.geometry = Sphere{0.25}}, {.geometry = Sphere{-1}}};
    const auto made = world.set_shapes(body, shapes);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().message.find("shapes[1]: "), 0u) << made.error().message;
    EXPECT_EQ(world.shapes_of(body).size(), 1u);
    EXPECT_FALSE(world.set_shapes(body, {}).ok()) << "a dynamic body needs a mass";
}

TEST(CreateBodies, creates_all_or_none) {
    World world;
    const BodyAndShapes good{{.pose = {.position = {0, 1, 0}}}, {{.geometry = Sphere{0.5}}}};
    BodyAndShapes bad = good;
    bad.shapes[0].density = -1;
    const BodyAndShapes some[] = {good, good, bad};
    const auto refused = world.create_bodies(some);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message.find("bodies[2]: density"), 0u) << refused.error().message;
    EXPECT_EQ(world.bodies().size(), 0u);
    const auto made = world.create_bodies(std::span(some, 2));
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(world.bodies(), *made);
}

TEST(DestroyBodies, rejects_duplicate_ids_and_destroys_none) {
    World world;
    std::vector<BodyId> balls;
    for (int k = 0; k < 3; k++)
        balls.push_back(
            *world.create_body({.pose = {.position = {3.0 * k, 0, 0}}}, {.geometry = Sphere{0.5}}));
    const BodyId twice[] = {balls[0], balls[1], balls[0]};
    EXPECT_FALSE(world.destroy_bodies(twice).ok());
    EXPECT_EQ(world.bodies().size(), 3u);
    EXPECT_TRUE(world.destroy_bodies(balls).ok());
    EXPECT_TRUE(world.bodies().empty());
}

TEST(UserData, is_saved_and_returned_for_bodies_shapes_and_joints) {
    World world;
    const BodyId a =
        *world.create_body({.user_data = 1}, {.geometry = Sphere{0.5}, .user_data = 2});
    const BodyId b =
        *world.create_body({.pose = {.position = {3, 0, 0}}}, {.geometry = Sphere{0.5}});
    const JointId joint = *world.create_joint({.body_a = a, .body_b = b, .user_data = 3});
    ASSERT_TRUE(world.set_user_data(b, 4).ok());
    ASSERT_TRUE(world.set_user_data(joint, 5).ok());
    const World loaded = std::move(*load(save(world)));
    EXPECT_EQ(loaded.body(a)->user_data, 1u);
    EXPECT_EQ(loaded.shape(loaded.shapes_of(a)[0])->user_data, 2u);
    EXPECT_EQ(loaded.body(b)->user_data, 4u);
    EXPECT_EQ(loaded.joint(joint)->def.user_data, 5u);
    EXPECT_EQ(state_hash(loaded), state_hash(world));
    ASSERT_TRUE(world.set_user_data(world.shapes_of(a)[0], 6).ok());
    EXPECT_NE(state_hash(loaded), state_hash(world));
}

TEST(ContactsOf, cube_between_two_reports_both_contacts_awake_and_asleep) {
    World world;
    const BodyId floor = *world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}});
    std::vector<BodyId> stack;
    for (int k = 0; k < 3; k++)
        stack.push_back(*world.create_body({.pose = {.position = {0, 0.5 + k, 0}}},
                                           {.geometry = Box{{0.5, 0.5, 0.5}}}));
    for (const bool asleep : {false, true}) {
        for (int n = 0; n < (asleep ? 120 : 5); n++) ASSERT_TRUE(world.step(dt).ok());
        ASSERT_EQ(world.body(stack[1])->awake, !asleep);
        const auto contacts = world.contacts_of(stack[1]);
        ASSERT_TRUE(contacts.ok());
        ASSERT_EQ(contacts->size(), 2u);
        for (const ContactInfo& contact : *contacts) {
            EXPECT_EQ(contact.asleep, asleep);
            EXPECT_EQ(contact.count, 4);
            EXPECT_TRUE(contact.body_a == stack[1] || contact.body_b == stack[1]);
        }
        EXPECT_EQ(*world.touching_bodies(stack[1]), (std::vector{stack[0], stack[2]}));
        EXPECT_EQ(*world.touching_bodies(floor), (std::vector{stack[0]}));
    }
}

}  // namespace
}  // namespace jostle::physics
