// SPDX-License-Identifier: MIT
//
// When two worlds differ, the first differing field is named with both values.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::AllOf;
using testing::HasSubstr;

// What first_difference says after the change, which must also change the hash.
template <class Change>
std::string difference_after(Change&& change) {
    World a = yard_scene(), b = yard_scene();
    run(a, 0.5);
    run(b, 0.5);
    EXPECT_FALSE(first_difference(a, b));
    change(b);
    EXPECT_NE(state_hash(a), state_hash(b));
    return first_difference(a, b).value_or("nothing");
}

BodyId some_ball(const World& world) {
    for (const BodyId body : world.bodies())
        if (state_of(world, body).awake && state_of(world, body).type == BodyType::dynamic)
            return body;
    return {};
}

TEST(FirstDifference, is_empty_after_identical_calls) {
    for (const TestScene& scene : test_scenes()) {
        World a = scene.make(1), b = scene.make(1);
        for (int step = 0; step < 150; step++) {
            must(a.step(1.0 / 60));
            must(b.step(1.0 / 60));
        }
        EXPECT_EQ(save(a), save(b)) << scene.name;
        EXPECT_FALSE(first_difference(a, b)) << scene.name;
    }
}

TEST(FirstDifference, reports_the_velocity_field_and_both_values) {
    EXPECT_THAT(
        difference_after([](World& w) {
            const BodyState s = state_of(w, some_ball(w));
            must(w.set_velocity(s.id, s.linear_velocity + Vec3{0.5, 0, 0}, s.angular_velocity));
        }),
        AllOf(HasSubstr("bodies"), HasSubstr("against")));
    EXPECT_THAT(difference_after([](World& w) {
                    must(w.apply_torque(some_ball(w), {0, 7, 0}));
                }),
                AllOf(HasSubstr("torque.y"), HasSubstr("0 against 7")));
}

TEST(FirstDifference, reports_user_data_counts_and_gravity) {
    World a = make_world(), b = make_world({.gravity = {0, -9, 0}});
    EXPECT_THAT(first_difference(a, b).value_or(""),
                AllOf(HasSubstr("gravity.y"), HasSubstr("-9.81"), HasSubstr("against -9")));
    World c = make_world(), d = make_world();
    must(c.create_body({.user_data = 1}, ShapeDef{}));
    must(d.create_body({.user_data = 2}, ShapeDef{}));
    EXPECT_THAT(first_difference(c, d).value_or(""),
                AllOf(HasSubstr("user_data"), HasSubstr("1 against 2")));
    add(c, {});
    EXPECT_TRUE(first_difference(c, d).has_value());
    EXPECT_TRUE(first_difference(d, c).has_value());
}

TEST(FirstDifference, detects_the_last_bit) {
    World a = make_world(), b = make_world();
    add(a, {.position = {1, 0, 0}});
    add(b, {.position = {1 + 0x1p-52, 0, 0}});
    EXPECT_THAT(first_difference(a, b).value_or(""), HasSubstr("1.0000000000000002"));
}

}  // namespace
}  // namespace jostle::test
