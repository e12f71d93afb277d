// SPDX-License-Identifier: MIT
//
// Each touch begins once and ends once, in order of ids, with a normal from a to b.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(ContactEvents, landing_and_lifting_a_ball_reports_begin_and_end) {
    World world = make_world();
    const BodyId floor = add_floor(world);
    const BodyId ball = add(world, {.geometry = Sphere{0.5}, .position = {2, 1.5, 3}});
    int begun = 0, ended = 0;
    for (int i = 0; i < 120; i++) {
        must(world.step(1.0 / 60));
        for (const ContactBegin& c : world.events().contacts_began) {
            begun++;
            const bool ball_first = c.body_a == ball;
            EXPECT_EQ(ball_first ? c.body_b : c.body_a, floor);
            EXPECT_TRUE(near(c.normal, {0, ball_first ? -1.0 : 1.0, 0}, 1e-6));
            EXPECT_TRUE(near(c.point, {2, 0, 3}, 0.1));
            EXPECT_NEAR(c.approach_speed, square_root(2 * 9.81 * 1.0), 0.3);  // fell 1 m
            EXPECT_EQ(must(world.shape(c.shape_a)).body, c.body_a);
        }
        ended += static_cast<int>(world.events().contacts_ended.size());
    }
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 0);
    must(world.set_velocity(ball, {0, 5, 0}, {}));
    for (int i = 0; i < 20; i++) {
        must(world.step(1.0 / 60));
        ended += static_cast<int>(world.events().contacts_ended.size());
        begun += static_cast<int>(world.events().contacts_began.size());
    }
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 1);
}

TEST(ContactEvents, falling_asleep_reports_no_end) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    int begun = 0, ended = 0;
    const auto count = [&](double seconds) {
        for (int i = 0; i < 60 * seconds; i++) {
            must(world.step(1.0 / 60));
            begun += static_cast<int>(world.events().contacts_began.size());
            ended += static_cast<int>(world.events().contacts_ended.size());
        }
    };
    count(3);
    EXPECT_FALSE(state_of(world, box).awake);
    must(world.wake(box));
    count(0.2);
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 0);
}

TEST(ContactEvents, destroying_a_body_ends_its_contacts_in_the_next_step) {
    World world = make_world();
    add_floor(world);
    const BodyId low = add(world, {.position = {0, 0.5, 0}});
    add(world, {.position = {0, 1.5, 0}});
    run(world, 0.2);
    must(world.destroy_body(low));
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.events().contacts_ended.size(), 2u);
}

TEST(ContactEvents, events_of_a_pile_are_sorted_and_alternate) {
    World world = make_world();
    add_floor(world);
    Random random(3);
    for (int i = 0; i < 40; i++)
        add(world, {.geometry = i % 2 == 0 ? Geometry{Box{{0.3, 0.2, 0.2}}} : Geometry{Sphere{0.3}},
                    .position = {random.in(-1, 1), 1 + 0.5 * i, random.in(-1, 1)},
                    .rotation = random.rotation(),
                    .restitution = 0.4});
    std::map<std::pair<ShapeId, ShapeId>, int> open;
    int begun = 0;
    for (int step = 0; step < 600; step++) {
        must(world.step(1.0 / 60));
        const Events events = world.events();
        for (std::size_t i = 0; i < events.contacts_ended.size(); i++) {
            const ContactEnd& c = events.contacts_ended[i];
            const auto key = std::pair(c.shape_a, c.shape_b);
            if (i > 0) {
                const ContactEnd& before = events.contacts_ended[i - 1];
                ASSERT_LT(std::pair(before.shape_a, before.shape_b), key);
            }
            ASSERT_EQ(open[key]--, 1);
        }
        for (std::size_t i = 0; i < events.contacts_began.size(); i++) {
            const ContactBegin& c = events.contacts_began[i];
            const auto key = std::pair(c.shape_a, c.shape_b);
            if (i > 0) {
                const ContactBegin& before = events.contacts_began[i - 1];
                ASSERT_LT(std::pair(before.shape_a, before.shape_b), key);
            }
            ASSERT_EQ(open[key]++, 0);
            ASSERT_NEAR(length(c.normal), 1, 1e-6);
            ASSERT_GE(c.approach_speed, 0);
            const Vec3 a = position_of(world, c.body_a), b = position_of(world, c.body_b);
            if (kind_of(must(world.shape(c.shape_a)).geometry) == ShapeKind::sphere &&
                kind_of(must(world.shape(c.shape_b)).geometry) == ShapeKind::sphere) {
                // The normal is of the start of the step, the poses are of its end.
                ASSERT_GT(dot(c.normal, normalized(b - a)), 0.7);
            }
            begun++;
        }
    }
    int still_open = 0;
    for (const auto& [key, count] : open) still_open += count;
    EXPECT_GT(begun, 100);
    EXPECT_EQ(still_open, world.summary().contacts);
}

}  // namespace
}  // namespace jostle::test
