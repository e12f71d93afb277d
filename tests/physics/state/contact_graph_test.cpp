// SPDX-License-Identifier: MIT
//
// Contacts come and go with their edges, pairs, islands and events.
#include "physics/src/state/contact_graph.h"

#include <gtest/gtest.h>

#include "physics/src/state/partial_sleep.h"
#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Balls and a wall in empty space, far from each other: no step makes a contact of its own.
struct Balls {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);
    std::vector<ContactEnd> ended;

    std::uint32_t ball(double x, double density = 1000) {
        return add(world, {.geometry = Sphere{0.5}, .position = {x, 0, 0}, .density = density})
            .index;
    }
    std::uint32_t shape(std::uint32_t body) const { return state.bodies.cold[body].first_shape; }
    std::uint32_t island(std::uint32_t body) const { return state.bodies.cold[body].island; }
    const Contact& contact(std::uint32_t index) const { return state.contacts.contacts[index]; }
    std::uint32_t create(std::uint32_t a, std::uint32_t b) {
        return create_contact(state, shape(a), shape(b));
    }
    std::vector<std::uint32_t> contacts_of(std::uint32_t body) const {
        std::vector<std::uint32_t> found;
        for_each_contact(state.contacts, state.bodies.cold[body],
                         [&](std::uint32_t index) { found.push_back(index); });
        return found;
    }
    std::string fault() const { return find_fault(state).value_or(""); }
};

TEST(ContactGraph, new_contact_is_in_both_body_lists_and_due) {
    Balls balls;
    const std::uint32_t a = balls.ball(0), b = balls.ball(10), c = balls.ball(20);
    const std::uint32_t ab = balls.create(a, b), bc = balls.create(b, c);
    EXPECT_EQ(balls.contacts_of(b), (std::vector{bc, ab})) << "the latest first";
    EXPECT_EQ(balls.contacts_of(a), std::vector{ab});
    EXPECT_TRUE(balls.state.contacts.pairs.contains(pair_key(balls.shape(b), balls.shape(a))));
    ASSERT_EQ(balls.state.contacts.bounds.size(), 2u);
    EXPECT_LT(balls.contact(ab).limit, 0) << "looked at in the next step";
    EXPECT_LT(balls.contact(ab).colour, 0);
    EXPECT_EQ(balls.fault(), "");
}

TEST(ContactGraph, side_a_is_dynamic_in_either_order) {
    Balls balls;
    const std::uint32_t wall = add_static(balls.world, {.position = {5, 0, 0}}).index;
    const std::uint32_t ball = balls.ball(0);
    const Contact& contact = balls.contact(balls.create(wall, ball));
    EXPECT_EQ(contact.body_a, ball);
    EXPECT_EQ(contact.body_b, wall);
    EXPECT_EQ(balls.fault(), "");
}

TEST(ContactGraph, destroyed_contact_is_fully_removed) {
    Balls balls;
    const std::uint32_t a = balls.ball(0), b = balls.ball(10), c = balls.ball(20);
    const std::uint32_t ab = balls.create(a, b), bc = balls.create(b, c), ac = balls.create(a, c);
    destroy_contact(balls.state, bc, balls.ended);
    EXPECT_EQ(balls.contacts_of(b), std::vector{ab});
    EXPECT_EQ(balls.contacts_of(c), std::vector{ac});
    EXPECT_FALSE(balls.state.contacts.pairs.contains(pair_key(balls.shape(b), balls.shape(c))));
    EXPECT_EQ(balls.state.contacts.bounds.size(), 2u);
    EXPECT_TRUE(balls.ended.empty()) << "it never touched";
    EXPECT_EQ(balls.create(b, c), bc) << "its index is free again";
    destroy_contacts_of(balls.state, a, balls.ended);
    EXPECT_EQ(balls.contacts_of(a), std::vector<std::uint32_t>{});
    EXPECT_EQ(balls.contacts_of(c), std::vector{bc});
    EXPECT_EQ(balls.fault(), "");
}

TEST(ContactGraph, touch_merges_islands_and_its_end_marks_them_for_splitting) {
    Balls balls;
    const std::uint32_t a = balls.ball(0), b = balls.ball(10);
    const std::uint32_t contact = balls.create(a, b);
    ASSERT_NE(balls.island(a), balls.island(b));
    begin_touch(balls.state, balls.state.joints, contact);
    ASSERT_EQ(balls.island(a), balls.island(b));
    const Island& island = balls.state.islands.islands[balls.island(a)];
    EXPECT_EQ(island.bodies, 2u);
    EXPECT_FALSE(island.may_be_split);
    EXPECT_FALSE(island.uneven);
    end_touch(balls.state, contact);
    EXPECT_EQ(balls.island(a), balls.island(b)) << "cut when something in it rests";
    EXPECT_TRUE(island.may_be_split);
    EXPECT_EQ(balls.fault(), "");
}

TEST(ContactGraph, destroying_a_touching_contact_reports_an_end_with_both_ids) {
    Balls balls;
    const std::uint32_t a = balls.ball(0), b = balls.ball(10);
    const std::uint32_t contact = balls.create(a, b);
    begin_touch(balls.state, balls.state.joints, contact);
    destroy_contacts_between(balls.state, a, b, balls.ended);
    ASSERT_EQ(balls.ended.size(), 1u);
    EXPECT_EQ(balls.ended[0].body_a, body_id(balls.state.bodies, a));
    EXPECT_EQ(balls.ended[0].shape_b, shape_id(balls.state.shapes, balls.shape(b)));
    EXPECT_EQ(balls.fault(), "");
}

// A hundred times its mass is where a body takes more sub-steps than others.
TEST(ContactGraph, large_mass_ratio_marks_the_island_uneven) {
    for (const double density : {99000.0, 101000.0}) {
        Balls balls;
        const std::uint32_t a = balls.ball(0), b = balls.ball(10, density);
        begin_touch(balls.state, balls.state.joints, balls.create(a, b));
        EXPECT_EQ(balls.state.islands.islands[balls.island(a)].uneven, density > 100000);
    }
}

TEST(ContactGraph, partially_sleeping_body_that_loses_a_touch_is_woken) {
    Balls balls;
    const std::uint32_t a = balls.ball(0), b = balls.ball(10);
    const std::uint32_t contact = balls.create(a, b);
    begin_touch(balls.state, balls.state.joints, contact);
    hold_still(balls.state.bodies, b);
    end_touch(balls.state, contact);
    ASSERT_EQ(balls.state.wake_requests.size(), 1u);
    EXPECT_EQ(balls.state.wake_requests[0].body, b);
    EXPECT_FALSE(balls.state.wake_requests[0].briefly);
}

// A ball and a dumbbell: a pair whose manifolds are contacts of their own.
struct Parts : Balls {
    std::uint32_t one = ball(0), dumbbell = 0, pair = 0;
    Parts() {
        const Geometry two = Compound{must(build_compound(
            {{Sphere{0.5}, {.position = {0, 0, 1}}}, {Sphere{0.5}, {.position = {0, 0, -1}}}}))};
        dumbbell = add(world, {.geometry = two, .position = {10, 0, 0}}).index;
        pair = create(one, dumbbell);
    }
};

TEST(ContactGraph, children_keep_their_creation_order) {
    Parts scene;
    ASSERT_TRUE(scene.contact(scene.pair).composite);
    const std::uint32_t first = create_child_contact(scene.state, scene.pair, 5);
    const std::uint32_t second = create_child_contact(scene.state, scene.pair, 3);
    const std::uint32_t third = create_child_contact(scene.state, scene.pair, 4);
    EXPECT_EQ(scene.contact(scene.pair).first_child, first);
    EXPECT_EQ(scene.contact(first).next_child, second);
    EXPECT_EQ(scene.contact(second).next_child, third);
    EXPECT_EQ(scene.contact(third).parent, scene.pair);
    destroy_contact(scene.state, second, scene.ended);
    EXPECT_EQ(scene.contact(first).next_child, third);
    destroy_contact(scene.state, scene.pair, scene.ended);
    EXPECT_EQ(scene.contacts_of(scene.one), std::vector<std::uint32_t>{}) << "parts go with it";
    EXPECT_EQ(scene.state.contacts.ids.alive_count(), 0u);
}

TEST(ContactGraph, composite_pair_ends_once_with_its_last_child) {
    Parts scene;
    const std::uint32_t first = create_child_contact(scene.state, scene.pair, 1);
    const std::uint32_t second = create_child_contact(scene.state, scene.pair, 2);
    begin_touch(scene.state, scene.state.joints, first);
    begin_touch(scene.state, scene.state.joints, second);
    scene.state.contacts.contacts[scene.pair].touching = true;  // as merge_islands reports it
    EXPECT_EQ(scene.contact(scene.pair).touching_children, 2u);
    std::vector<ContactEnd>& reported = scene.ended;
    end_touch(scene.state, first);
    end_touch_of_pair(scene.state, scene.pair, reported);
    EXPECT_TRUE(reported.empty()) << "the other still touches";
    end_touch(scene.state, second);
    end_touch_of_pair(scene.state, scene.pair, reported);
    end_touch_of_pair(scene.state, scene.pair, reported);
    EXPECT_EQ(reported.size(), 1u);
    EXPECT_FALSE(scene.contact(scene.pair).touching);
}

// The floor bore 1 + 3 balls; when three quarters of the mass are gone the impulses that it starts
// the next step with are to be a quarter.
TEST(ContactGraph, island_records_its_lost_load) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    const BodyId lower = add(world, {.position = {0, 0.5, 0}});
    const BodyId upper = add(world, {.position = {0, 1.5, 0}, .density = 3000});
    run(world, 0.5);
    WorldState& state = state_of(world);
    const std::uint32_t island = state.bodies.cold[lower.index].island;
    ASSERT_EQ(state.bodies.cold[upper.index].island, island);
    must(world.destroy_body(upper));
    EXPECT_NEAR(state.islands.islands[island].remaining_load, 0.25, 1e-12);
    EXPECT_TRUE(state.islands.some_lost);
}

}  // namespace
}  // namespace jostle::test
