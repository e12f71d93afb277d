// SPDX-License-Identifier: MIT
//
// A bounce begins a contact and ends it with the next step.
#include "physics/src/stages/continuous/bounce_events.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(BounceEvents, each_bounce_of_a_slow_ball_reports_begin_and_end) {
    World world = make_world();
    const BodyId floor = add_floor(world, 0, 1);
    const BodyId ball = add(
        world, {.geometry = Sphere{0.5}, .position = {0, 0.6, 0}, .friction = 0, .restitution = 1});
    int open = 0, begun = 0;
    for (int step = 0; step < 120; step++) {
        must(world.step(1.0 / 60));
        for (const ContactEnd& c : world.events().contacts_ended) {
            EXPECT_EQ(c.body_a, ball);
            open--;
        }
        for (const ContactBegin& c : world.events().contacts_began) {
            EXPECT_EQ(c.body_a, ball);
            EXPECT_EQ(c.body_b, floor);
            EXPECT_TRUE(near(c.normal, {0, -1, 0}, 1e-9));
            EXPECT_TRUE(near(c.point, {0, 0, 0}, 1e-3));
            EXPECT_NEAR(c.approach_speed, square_root(2 * 9.81 * 0.1), 5e-3);
            begun++, open++;
        }
        EXPECT_GE(open, 0);
        EXPECT_LE(open, 1);
    }
    EXPECT_EQ(begun, 7);  // 0.143 s down, then every 0.286 s
}

// Of several bounces of one pair the first; in the order of their shapes.
TEST(BounceEvents, reports_each_bounce_once_in_order) {
    EventStore events;
    const ShapeId one{1, 1}, two{2, 1}, three{3, 1};
    std::vector<ContactBegin> bounces(3);
    bounces[0].shape_a = two, bounces[0].shape_b = three;
    bounces[1].shape_a = one, bounces[1].shape_b = three, bounces[1].approach_speed = 5;
    bounces[2].shape_a = one, bounces[2].shape_b = three, bounces[2].approach_speed = 7;
    report_bounces(events, bounces);
    ASSERT_EQ(events.contacts_began.size(), 2u);
    EXPECT_EQ(events.contacts_began[0].shape_a, one);
    EXPECT_EQ(events.contacts_began[0].approach_speed, 5);
    EXPECT_EQ(events.contacts_began[1].shape_a, two);
    EXPECT_TRUE(events.contacts_ended.empty()) << "with the next step";
    events.begin_step();
    EXPECT_EQ(events.contacts_ended.size(), 2u);
    EXPECT_TRUE(bounces.empty());
}

}  // namespace
}  // namespace jostle::test
