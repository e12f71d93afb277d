// SPDX-License-Identifier: MIT
//
// A pair as it will be later in the step, and its gaps counted back to the start.
#include "physics/src/stages/contacts/predicted_pair.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_graph.h"
#include "physics/src/state/world_access.h"
#include "tests/support/near.h"
#include "tests/support/step_time.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// Something at a height over the floor, and their contact.
struct OverFloor {
    World world = make_world();
    WorldState& state = state_of(world);
    std::uint32_t body = 0;
    std::uint32_t index = 0;

    OverFloor(const Geometry& geometry, double height, Vec3 velocity) {
        add_floor(world);
        body = add(world, {.geometry = geometry, .position = {0, height, 0}, .velocity = velocity})
                   .index;
        index = create_contact(state, 1, 0);
    }
    Contact& contact() { return state.contacts.contacts[index]; }
};

// 10 cm above the floor at 12 m/s: there after 1/120 s, less the tenth of a millimetre that is
// kept.
TEST(PredictedPair, ball_reaches_the_floor_once_its_gap_closes) {
    OverFloor ball(Sphere{0.5}, 0.6, {0, -12, 0});
    const auto time = time_to_contact(ball.state, ball.contact(), dt);
    ASSERT_TRUE(time);
    EXPECT_NEAR(*time, 1.0 / 120, 2e-5);
    OverFloor slow(Sphere{0.5}, 0.6, {0, -5, 0});
    EXPECT_FALSE(time_to_contact(slow.state, slow.contact(), dt)) << "8 cm in this step";
    OverFloor touching(Sphere{0.5}, 0.5, {0, -5, 0});
    EXPECT_EQ(time_to_contact(touching.state, touching.contact(), dt), 0);
}

// n sub-steps push at their beginnings: in the mean (n - 1) / 2n of a step after its start.
TEST(PredictedPair, force_midpoint_is_before_the_step_midpoint) {
    OverFloor box(Box{}, 0.5, {1, 0, 0});
    EXPECT_EQ(midpoint_time(box.state, box.contact(), 0.01, dt), 0) << "it does not touch yet";
    box.contact().touching = true;
    EXPECT_NEAR(midpoint_time(box.state, box.contact(), 0.01, dt), dt * 7 / 16, 1e-12);
    EXPECT_EQ(midpoint_time(box.state, box.contact(), 5e-5, dt), 0) << "it hardly moves";
    // No further than half its thickness: 0.25 m of 2 m.
    EXPECT_NEAR(midpoint_time(box.state, box.contact(), 2, dt), dt / 8, 1e-12);
}

TEST(PredictedPair, shapes_are_extrapolated_by_their_velocities) {
    OverFloor box(Box{}, 2, {6, -12, 0});
    warm_of(box.state, box.body).w = {0, 0, pi};
    const PredictedPair pair(box.state, box.contact(), 0.5);
    EXPECT_TRUE(near(pair.shape_a().position, {3, -4, 0}, 1e-12));
    EXPECT_TRUE(near(pair.shape_a().axes.x, {0, 1, 0}, 1e-12)) << "a quarter turn";
    EXPECT_EQ(pair.shape_b().position, Vec3{});
}

// A gap of 0 in 1/120 s at 12 m/s is one of 10 cm now. The point goes along with the box, whose
// centre is followed: what is not pushed need not be thought of.
TEST(PredictedPair, rewound_gap_equals_the_current_gap) {
    OverFloor box(Box{}, 0.6, {3, -12, 0});
    const double time = 1.0 / 120;
    const PredictedPair pair(box.state, box.contact(), time);
    Manifold m{.count = 1, .normal = {0, -1, 0}};
    m.point[0] = {3 * time, 0, 0};
    pair.rewind_manifold(m, 1);
    EXPECT_NEAR(m.gap[0], 0.1, 1e-12);
    EXPECT_NEAR(m.distance, 0.1, 1e-12);
    EXPECT_TRUE(near(m.point[0], {0, 12 * time, 0}, 1e-12));
    Manifold apart{.normal = {0, -1, 0}, .distance = 0.5};
    pair.rewind_manifold(apart, 0.2);
    EXPECT_NEAR(apart.distance, 0.3, 1e-12) << "nearer by all that they may move";
    const PredictedPair now(box.state, box.contact(), 0);
    now.rewind_manifold(apart, 0.2);
    EXPECT_NEAR(apart.distance, 0.3, 1e-12) << "now is now";
}

TEST(PredictedPair, smallest_gap_is_the_deepest_point_or_the_distance) {
    Manifold m{.count = 3, .distance = 9};
    m.gap[0] = 0.1;
    m.gap[1] = -0.2;
    m.gap[3] = -5;  // no point
    EXPECT_EQ(smallest_gap(m), -0.2);
    m.count = 0;
    EXPECT_EQ(smallest_gap(m), 9);
}

}  // namespace
}  // namespace jostle::test
