// SPDX-License-Identifier: MIT
//
// What debug views see: contacts, islands, boxes.
#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A tonne on four points: impulses are those of one sub-step, of eight at first, of four when it
// was seen to be flat and slow.
TEST(Inspect, resting_box_has_four_contact_points) {
    World world = make_world();
    const BodyId floor = add_floor(world);
    const BodyId box = add(world, {.position = {2, 0.5, 0}});
    run(world, 0.4);
    const auto awake = world.contacts();
    run(world, 2);
    const auto asleep = world.contacts();
    for (const auto& [contacts, substeps] : {std::pair{awake, 8}, {asleep, 4}}) {
        ASSERT_EQ(contacts.size(), 1u);
        const ContactInfo& c = contacts[0];
        EXPECT_EQ(c.body_a, box);
        EXPECT_EQ(c.body_b, floor);
        EXPECT_TRUE(near(c.normal, {0, -1, 0}, 1e-6));
        EXPECT_TRUE(c.touching);
        ASSERT_EQ(c.count, 4);
        double impulse = 0;
        for (int k = 0; k < 4; k++) {
            EXPECT_NEAR(absolute(c.point[k].x - 2), 0.5, 1e-3);
            EXPECT_NEAR(absolute(c.point[k].z), 0.5, 1e-3);
            EXPECT_NEAR(c.gap[k], 0, 1e-3);
            impulse += c.impulse[k];
        }
        EXPECT_NEAR(impulse, 9810.0 / 60 / substeps, 0.5);
    }
    EXPECT_FALSE(awake[0].asleep);
    EXPECT_TRUE(asleep[0].asleep);
}

TEST(Inspect, contacts_are_sorted_by_shape) {
    World world = make_world();
    add_floor(world);
    for (int k = 9; k >= 0; k--) add(world, {.position = {1.5 * k, 0.5, 0}});
    run(world, 0.2);
    const auto contacts = world.contacts();
    ASSERT_EQ(contacts.size(), 10u);
    for (std::size_t k = 1; k < contacts.size(); k++)
        EXPECT_LT(contacts[k - 1].shape_a, contacts[k].shape_a);
}

TEST(Inspect, islands_group_touching_bodies) {
    World world = make_world();
    add_floor(world);
    std::vector<BodyId> stack;
    for (int k = 0; k < 3; k++) stack.push_back(add(world, {.position = {0, 0.5 + k, 0}}));
    const BodyId alone = add(world, {.position = {5, 0.5, 0}});
    run(world, 0.2);
    auto islands = world.islands();
    ASSERT_EQ(islands.size(), 2u);
    if (islands[0].size() < islands[1].size()) std::swap(islands[0], islands[1]);
    EXPECT_EQ(islands[0], stack);
    EXPECT_EQ(islands[1], std::vector{alone});
}

// 1 m wide and 4 cm on each side.
TEST(Inspect, bounds_match_the_shape_and_its_fat_box) {
    World world = make_world({.gravity = {}});
    const BodyId box = add(world, {.position = {3, 0, 0}});
    const ShapeId shape = world.shapes_of(box)[0];
    EXPECT_EQ(must(world.bounds(shape)), (Aabb{{2.5, -0.5, -0.5}, {3.5, 0.5, 0.5}}));
    EXPECT_TRUE(near(must(world.fat_bounds(shape)).low, {2.46, -0.54, -0.54}, 1e-12));
    const ShapeId plane = world.shapes_of(add_floor(world))[0];
    EXPECT_FALSE(world.bounds(plane).ok());
    EXPECT_FALSE(world.fat_bounds(plane).ok());
    add(world, {.position = {9, 0, 0}});
    const auto cells = world.broad_phase_cells();
    ASSERT_EQ(cells.size(), 1u) << "the node over both";
    EXPECT_TRUE(contains(cells[0], must(world.bounds(shape))));
}

}  // namespace
}  // namespace jostle::test
