// SPDX-License-Identifier: MIT
//
// How far a pair that is apart may move before it is looked at again.
#include "state/separation_bounds.h"

#include <gtest/gtest.h>

#include "state/contact_graph.h"
#include "state/world_access.h"
#include "support/near.h"
#include "support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Centres 5 m apart along (3, 4, 0), bodies that have turned by 0.1 and 0.2 m so far.
const MotionBound turned_a{.travel = 1, .turned = 0.1}, turned_b{.travel = 2, .turned = 0.2};

TEST(SeparationBound, by_length_counts_from_where_the_centres_were) {
    SeparationBound bound;
    set_separation_bound(bound, {3, 4, 0}, {}, 0.5, turned_a, turned_b);
    EXPECT_FALSE(bound.directed);
    EXPECT_EQ(direction_of(bound), (Vec3{3, 4, 0}));
    EXPECT_NEAR(bound.budget, 0.5 + 0.3, 1e-12);
}

// Along a direction what is left is budget + direction . apart - turned: the slack, at first.
TEST(SeparationBound, along_a_direction_counts_from_the_distance_along_it) {
    SeparationBound bound;
    set_separation_bound(bound, {3, 4, 0}, {0, 1, 0}, 0.5, turned_a, turned_b);
    EXPECT_TRUE(bound.directed);
    EXPECT_NEAR(bound.budget, 0.5 + 0.3 - 4, 1e-12);
    const double left = bound.budget + dot(direction_of(bound), Vec3{3, 4, 0}) - 0.3;
    EXPECT_NEAR(left, 0.5, 1e-12);
}

struct TwoBalls {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);
    std::uint32_t contact = 0;

    explicit TwoBalls(double apart = 10) {
        for (const double x : {0.0, apart})
            add(world, {.geometry = Sphere{0.5}, .position = {x, 0, 0}});
        state.bodies.motion[0].travel = 2;
        state.bodies.motion[1].travel = 3;
        contact = create_contact(state, 0, 1);
        state.contacts.bounds.clear();
        state.contacts.contacts[contact].has_bound = false;
    }
};

TEST(SeparationBound, of_a_pair_holds_until_both_have_moved_by_its_slack) {
    TwoBalls balls;
    add_separation_bound(balls.state, balls.contact, 0.75);
    ASSERT_EQ(balls.state.contacts.bounds.size(), 1u);
    const SeparationBound& bound = balls.state.contacts.bounds[0];
    EXPECT_EQ(bound.limit, 2 + 3 + 0.75);
    EXPECT_EQ(balls.state.contacts.contacts[balls.contact].limit, bound.limit);
    EXPECT_EQ(direction_of(bound), (Vec3{10, 0, 0}));
    EXPECT_NEAR(bound.budget, 0.75 - 1e-4, 1e-12) << "less what floats are off by";
}

// Within a kilometre floats know a place to 0.06 mm; what is further apart, or due at once, is not
// measured.
TEST(SeparationBound, is_not_measured_beyond_a_kilometre_nor_when_it_is_due) {
    for (const auto& [apart, slack, measured] :
         {std::tuple{999.0, 1.0, true}, {1001.0, 1.0, false}, {10.0, -1.0, false}}) {
        TwoBalls balls(apart);
        add_separation_bound(balls.state, balls.contact, slack);
        EXPECT_EQ(balls.state.contacts.bounds[0].budget != SeparationBound::not_measured, measured)
            << apart << " m apart";
    }
}

TEST(SeparationBound, of_a_dormant_pair_goes_on_where_it_was) {
    TwoBalls balls;
    add_separation_bound(balls.state, balls.contact, 0.75);
    Contact& contact = balls.state.contacts.contacts[balls.contact];
    contact.dormant = true;
    add_separation_bound(balls.state, balls.contact, 100);
    EXPECT_EQ(balls.state.contacts.bounds.size(), 1u) << "it still had its place";
    EXPECT_EQ(balls.state.contacts.bounds[0].limit, 5.75);
    EXPECT_FALSE(contact.dormant);
    // It lost its place while it was dormant.
    balls.state.contacts.bounds.clear();
    contact.has_bound = false;
    contact.dormant = true;
    resume_separation_bound(balls.state, balls.contact);
    ASSERT_EQ(balls.state.contacts.bounds.size(), 1u);
    EXPECT_EQ(balls.state.contacts.bounds[0].limit, 5.75);
    EXPECT_FALSE(contact.dormant);
    EXPECT_TRUE(contact.has_bound);
}

}  // namespace
}  // namespace jostle::test
