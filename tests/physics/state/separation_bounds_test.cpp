// SPDX-License-Identifier: MIT
//
// How far a pair that is apart may move before it is looked at again, and when that is.
#include "physics/src/state/separation_bounds.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_graph.h"
#include "physics/src/state/shape_proxy.h"
#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Centres 5 m apart along (3, 4, 0), bodies that have turned by 0.1 and 0.2 m so far.
const MotionBound turned_a{.travel = 1, .turned = 0.1}, turned_b{.travel = 2, .turned = 0.2};

TEST(SeparationBound, undirected_bound_measures_from_the_initial_centres) {
    SeparationBound bound;
    set_separation_bound(bound, {3, 4, 0}, {}, 0.5, turned_a, turned_b);
    EXPECT_FALSE(bound.directed);
    EXPECT_EQ(direction_of(bound), (Vec3{3, 4, 0}));
    EXPECT_NEAR(bound.budget, 0.5 + 0.3, 1e-12);
}

// Along a direction what is left is budget + direction . apart - turned: the slack, at first.
TEST(SeparationBound, directed_bound_measures_along_its_direction) {
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

TEST(SeparationBound, holds_until_both_bodies_use_up_the_slack) {
    TwoBalls balls;
    add_separation_bound(balls.state, balls.state.contacts, balls.contact, 0.75);
    ASSERT_EQ(balls.state.contacts.bounds.size(), 1u);
    const SeparationBound& bound = balls.state.contacts.bounds[0];
    EXPECT_EQ(bound.limit, 2 + 3 + 0.75);
    EXPECT_EQ(balls.state.contacts.contacts[balls.contact].limit, bound.limit);
    EXPECT_EQ(direction_of(bound), (Vec3{10, 0, 0}));
    EXPECT_NEAR(bound.budget, 0.75 - 1e-4, 1e-12) << "less what floats are off by";
}

// Within a kilometre floats know a place to 0.06 mm; what is further apart, or due at once, is not
// measured.
TEST(SeparationBound, is_not_measured_beyond_1_km_or_when_due) {
    for (const auto& [apart, slack, measured] :
         {std::tuple{999.0, 1.0, true}, {1001.0, 1.0, false}, {10.0, -1.0, false}}) {
        TwoBalls balls(apart);
        add_separation_bound(balls.state, balls.state.contacts, balls.contact, slack);
        EXPECT_EQ(balls.state.contacts.bounds[0].budget != SeparationBound::not_measured, measured)
            << apart << " m apart";
    }
}

// 10 m apart with a slack of 0.75 m. Along the line from one to the other the distance counts, at
// the beginning and the end of the step; a turn counts whichever way it goes.
TEST(SeparationBound, reports_pairs_that_stayed_separated_during_a_step) {
    for (const bool directed : {true, false}) {
        TwoBalls balls;
        add_separation_bound(balls.state, balls.state.contacts, balls.contact, 0.75,
                             directed ? Vec3{1, 0, 0} : Vec3{});
        const SeparationBound& bound = balls.state.contacts.bounds[0];
        const auto stayed = [&](Vec3 before, Vec3 now) {
            return stayed_apart(balls.state.bodies, bound, before, now);
        };
        EXPECT_TRUE(stayed({10, 0, 0}, {9, 0, 0})) << "neither has travelled";
        balls.state.bodies.motion[0].travel += 100;
        EXPECT_TRUE(stayed({10, 0, 0}, {9.3, 0, 0}));
        EXPECT_FALSE(stayed({10, 0, 0}, {9.2, 0, 0}));
        EXPECT_FALSE(stayed({9.2, 0, 0}, {10, 0, 0})) << "nearest at the beginning";
        EXPECT_EQ(stayed({10, 0, 0}, {10, 8, 0}), directed) << "past each other";
        balls.state.bodies.motion[1].turned += 0.5;
        EXPECT_TRUE(stayed({10, 0, 0}, {9.8, 0, 0}));
        EXPECT_FALSE(stayed({10, 0, 0}, {9.7, 0, 0}));
    }
}

TEST(SeparationBound, dormant_pair_resumes_its_bound) {
    TwoBalls balls;
    add_separation_bound(balls.state, balls.state.contacts, balls.contact, 0.75);
    Contact& contact = balls.state.contacts.contacts[balls.contact];
    contact.dormant = true;
    add_separation_bound(balls.state, balls.state.contacts, balls.contact, 100);
    EXPECT_EQ(balls.state.contacts.bounds.size(), 1u) << "it still had its place";
    EXPECT_EQ(balls.state.contacts.bounds[0].limit, 5.75);
    EXPECT_FALSE(contact.dormant);
    // It lost its place while it was dormant.
    balls.state.contacts.bounds.clear();
    contact.has_bound = false;
    contact.dormant = true;
    resume_separation_bound(balls.state.contacts, balls.contact);
    ASSERT_EQ(balls.state.contacts.bounds.size(), 1u);
    EXPECT_EQ(balls.state.contacts.bounds[0].limit, 5.75);
    EXPECT_FALSE(contact.dormant);
    EXPECT_TRUE(contact.has_bound);
}

// Two balls of 0.5 m, `gap` between them along x, without gravity.
struct InFlight {
    World world = make_world({.gravity = {}});
    WorldState& state = state_of(world);

    InFlight(double gap, Vec3 velocity_a, Vec3 velocity_b) {
        add(world, {.geometry = Sphere{0.5}, .velocity = velocity_a});
        add(world, {.geometry = Sphere{0.5}, .position = {1 + gap, 0, 0}, .velocity = velocity_b});
        create_contact(state, 0, 1);
    }
    SeparationBound& bound() { return state.contacts.bounds[0]; }
    // Waits with so much slack, along x or by length.
    void wait(double slack, Vec3 direction) {
        state.contacts.bounds.clear();
        state.contacts.contacts[0].has_bound = false;
        add_separation_bound(state, state.contacts, 0, slack, direction);
    }
    // As finalize does for one step.
    void move() {
        for (BodyWarm& warm : state.bodies.awake) {
            warm.center += warm.v * dt;
            state.bodies.motion[warm.body].travel += length(warm.v) * dt;
            update_motion_bound(state, warm.body, dt);
        }
    }
    int steps_until_due() {
        int steps = 0;
        while (!is_due(state, state.def, bound(), dt) && steps < 1000) {
            move();
            steps++;
        }
        return steps;
    }
};

// A metre apart, 6 m/s: 0.1 m a step. Along x it is asked for in the step that may use the rest.
TEST(SeparationBound, closing_pair_is_due_once_the_slack_is_used) {
    InFlight balls(1, {6, 0, 0}, {});
    balls.wait(1, {1, 0, 0});
    EXPECT_EQ(balls.steps_until_due(), 9);
}

// Both fly at 50 m/s, and nothing changes between them.
TEST(SeparationBound, pair_with_equal_velocities_is_never_due) {
    InFlight balls(1, {50, 20, 0}, {50, 20, 0});
    balls.wait(1, {1, 0, 0});
    EXPECT_EQ(balls.steps_until_due(), 1000);
    balls.wait(1, {});
    EXPECT_EQ(balls.steps_until_due(), 1000);
}

// Two balls 20 cm apart whose slack is used up: measured again along x, the gap less the margin of
// 2 cm and the reserve of 0.1 mm is left.
TEST(SeparationBound, due_pair_that_is_still_apart_gets_a_new_bound) {
    InFlight balls(0.2, {6, 0, 0}, {});
    balls.wait(0.05, {1, 0, 0});
    EXPECT_TRUE(is_due(balls.state, balls.state.def, balls.bound(), dt)) << "0.1 m in this step";
    EXPECT_TRUE(renew_separation_bound(balls.state, balls.bound(), dt));
    EXPECT_NEAR(balls.bound().budget + 1.2, 0.2 - 0.0201, 1e-6) << "centres 1.2 m apart";
    EXPECT_FALSE(is_due(balls.state, balls.state.def, balls.bound(), dt));
    InFlight near(0.1, {6, 0, 0}, {}), far(2, {6, 0, 0}, {});
    near.wait(0.05, {1, 0, 0});
    EXPECT_FALSE(renew_separation_bound(near.state, near.bound(), dt)) << "8 cm are left";
    near.wait(0.05, {});
    EXPECT_FALSE(renew_separation_bound(near.state, near.bound(), dt)) << "no direction";
    far.wait(0.05, {1, 0, 0});
    EXPECT_FALSE(renew_separation_bound(far.state, far.bound(), dt)) << "their boxes are apart";
}

// One passes the other at a distance: along the direction in which they are apart nothing closes,
// by the length of the motion it does.
TEST(SeparationBound, directed_bound_accepts_passing_bodies) {
    InFlight balls(1, {0, 6, 0}, {});
    balls.wait(1, {1, 0, 0});
    EXPECT_EQ(balls.steps_until_due(), 1000);
    InFlight by_length(1, {0, 6, 0}, {});
    by_length.wait(1, {});
    EXPECT_LT(by_length.steps_until_due(), 10);
}

// What was never looked at waits by the balls around both bodies, without a look.
TEST(SeparationBound, new_pair_starts_with_a_bounding_sphere_distance) {
    InFlight far(1, {6, 0, 0}, {}), near(0.05, {6, 0, 0}, {});
    EXPECT_FALSE(is_due(far.state, far.state.def, far.bound(), dt));
    EXPECT_TRUE(far.bound().directed);
    EXPECT_NE(far.bound().budget, SeparationBound::not_measured);
    EXPECT_TRUE(is_due(near.state, near.state.def, near.bound(), dt)) << "they meet in this step";
}

// A turn moves the surface: both balls spin, and the slack is used up without any motion.
TEST(SeparationBound, includes_rotation) {
    InFlight balls(1, {}, {});
    balls.wait(0.05, {1, 0, 0});
    EXPECT_FALSE(is_due(balls.state, balls.state.def, balls.bound(), dt));
    warm_of(balls.state, 0).w = {0, 0, 12};  // 0.1 m a step
    update_motion_bound(balls.state, 0, dt);
    EXPECT_TRUE(is_due(balls.state, balls.state.def, balls.bound(), dt));
}

}  // namespace
}  // namespace jostle::test
