// SPDX-License-Identifier: MIT
//
// Ways of fast bodies through a step: where they begin, turn and end.
#include "physics/src/stages/continuous/toi_body.h"

#include <gtest/gtest.h>

#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// One body in flight through one step of gravity.
struct Flight {
    World world = make_world();
    WorldState& state = state_of(world);
    BodyWarm before;
    ToiBody toi;

    Flight(const Geometry& geometry, Vec3 velocity, Vec3 spin) {
        add(world, {.geometry = geometry, .velocity = velocity, .spin = spin});
        before = state.bodies.awake[0];
        must(world.step(dt));
        toi.body = 0;
        toi.fast = true;
        begin_toi(state, toi, before, dt);
    }
    const BodyWarm& now() const { return state.bodies.awake[0]; }
};

// Contacts that do nothing do not hold it: its velocity is that of the moment.
TEST(ToiBody, body_passing_an_obstacle_is_in_free_flight) {
    Flight flight(Sphere{0.1}, {0, -3, 0}, {});
    EXPECT_FALSE(flight.toi.held);
    EXPECT_NEAR(flight.toi.velocity.y, -3, 1e-12);
    EXPECT_NEAR(flight.toi.gain.y, -9.81 * dt, 1e-12);
    EXPECT_NEAR(speed_at(flight.state, flight.toi, 0.5, dt).v.y, -3 - 0.5 * 9.81 * dt, 1e-12);
}

// However often it went round: of all even turns that end there the one most like its spin.
TEST(ToiBody, even_sweep_ends_at_the_body_pose) {
    for (const double turns : {0.1, 0.9, 1.4, 5.3}) {
        BodyWarm from, to;
        from.center = {1, 2, 3};
        to.center = {4, 6, 3};
        to.rotation = from_axis_angle({0, 0, 1}, turns * 2 * pi);
        to.w = {0, 0, turns * 2 * pi / dt};
        const Sweep sweep = even_sweep(from, to, dt);
        EXPECT_EQ(sweep.translation, (Vec3{3, 4, 0}));
        EXPECT_TRUE(near(sweep.rotation_vector, {0, 0, turns * 2 * pi}, 1e-9)) << turns;
        EXPECT_TRUE(
            near(rotate(rotation_at(sweep, 1), {1, 0, 0}), rotate(to.rotation, {1, 0, 0}), 1e-9));
    }
}

TEST(ToiBody, velocity_grows_linearly_in_flight) {
    Flight flight(Sphere{0.1}, {60, 0, 0}, {});
    EXPECT_TRUE(near(speed_at(flight.state, flight.toi, 0, dt).v, {60, 0, 0}, 1e-12));
    EXPECT_TRUE(
        near(speed_at(flight.state, flight.toi, 0.5, dt).v, {60, -9.81 * dt / 2, 0}, 1e-12));
    EXPECT_TRUE(near(speed_at(flight.state, flight.toi, 1, dt).v, flight.now().v, 1e-12));
    EXPECT_TRUE(near(center_at(flight.toi.sweep, 1), flight.now().center, 1e-12));
}

// A thin rod that tumbles does not turn evenly: its way is cut into legs whose ends are where it
// really is.
TEST(ToiBody, gyroscopic_body_is_swept_in_legs) {
    Flight flight(Box{{0.5, 0.02, 0.05}}, {}, {60, 40, 90});
    ASSERT_LT(flight.toi.sweep.until, 1);
    int legs = 1;
    while (flight.toi.sweep.until < 1) {
        next_leg(flight.state, flight.toi, dt);
        legs++;
    }
    EXPECT_GE(legs, 2);
    EXPECT_LE(legs, 60);
    EXPECT_TRUE(
        near(rotate(rotation_at(flight.toi.sweep, 1), {1, 0, 0}), flight.now().axes.x, 1e-6));
    EXPECT_TRUE(near(center_at(flight.toi.sweep, 1), flight.now().center, 1e-12));
}

// However wild the spin: at an inertia that no mass has, legs without length never came to an end.
TEST(ToiBody, leg_count_is_bounded) {
    for (const double wild : {1e6, 1e200}) {
        Flight flight(Box{{0.5, 0.02, 0.05}}, {}, {60, 40, 90});
        flight.state.bodies.cold[0].inverse_inertia.y *= wild;
        ToiBody toi;
        toi.body = 0;
        toi.fast = true;
        begin_toi(flight.state, toi, flight.before, dt);
        int legs = 1;
        for (; toi.sweep.until < 1 && legs < 2000; legs++) next_leg(flight.state, toi, dt);
        EXPECT_EQ(legs, 1001) << wild;
    }
}

// Half way it bounces back: the other half is lived with the new velocity.
TEST(ToiBody, simulates_the_rest_of_the_step_after_an_impact) {
    Flight flight(Sphere{0.1}, {60, 0, 0}, {});
    const Vec3 there = center_at(flight.toi.sweep, 0.5);
    const Vec3 back{-30, -9.81 * dt / 2, 0};
    depart(flight.state, flight.toi, 0.5, {there, {}, back, {}}, dt);
    EXPECT_TRUE(flight.toi.changed);
    const double travel = flight.state.bodies.motion[0].travel;
    finish_toi(flight.state, flight.toi, dt);
    EXPECT_NEAR(flight.now().center.x, 0.5 - 0.25, 1e-9);
    EXPECT_NEAR(flight.now().v.x, -30, 1e-12);
    EXPECT_NEAR(flight.now().v.y, -9.81 * dt, 1e-12) << "gravity goes on";
    EXPECT_GE(flight.state.bodies.motion[0].travel, travel + 0.75) << "who waits for it must know";
}

// After sixteen impacts it stays where it is until the next step.
TEST(ToiBody, exhausted_body_stops) {
    Flight flight(Sphere{0.1}, {60, 0, 0}, {});
    flight.toi.impacts = 15;
    EXPECT_FALSE(is_exhausted(flight.toi));
    flight.toi.impacts = 16;
    EXPECT_TRUE(is_exhausted(flight.toi));
    const Vec3 there = center_at(flight.toi.sweep, 0.25);
    depart(flight.state, flight.toi, 0.25, {there, {}, {-30, 0, 0}, {}}, dt);
    finish_toi(flight.state, flight.toi, dt);
    EXPECT_TRUE(near(flight.now().center, there, 1e-12));
    EXPECT_NEAR(flight.now().v.x, -30, 1e-12);
}

}  // namespace
}  // namespace jostle::test
