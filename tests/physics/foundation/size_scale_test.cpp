// SPDX-License-Identifier: MIT
//
// What is usual keeps the constants as they are, bit by bit; what is not takes them in proportion.
#include "physics/src/foundation/size_scale.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

constexpr Vec3 earth{0, -9.81, 0};

TEST(SizeScale, usual_sizes_have_scale_one) {
    for (const double size : {0.05, 0.1, 0.5, 1.0, 5.0}) {
        EXPECT_EQ(size_scale(size), 1) << size;
        EXPECT_EQ(speed_scale(size, gravity_ratio_squared(earth)), 1) << size;
        EXPECT_FALSE(is_unusual(size, gravity_ratio_squared(earth))) << size;
    }
}

TEST(SizeScale, other_sizes_scale_proportionally) {
    EXPECT_NEAR(size_scale(0.001), 0.02, 1e-12);
    EXPECT_NEAR(size_scale(100), 20, 1e-12);
    EXPECT_TRUE(is_unusual(0.001, 1));
    EXPECT_TRUE(is_unusual(100, 1));
}

// By the root of size and gravity: a scene of half the size takes 0.7 of the time.
TEST(SizeScale, speeds_scale_with_the_square_root_of_size_and_gravity) {
    const double g2 = gravity_ratio_squared(earth);
    EXPECT_NEAR(speed_scale(0.0005, g2), 0.1, 1e-12);
    EXPECT_NEAR(speed_scale(500, g2), 10, 1e-12);
    const double moon = gravity_ratio_squared(earth * 0.01);
    EXPECT_NEAR(speed_scale(0.05, moon), 0.1, 1e-12);
    EXPECT_EQ(speed_scale(6, moon), 1);
    EXPECT_TRUE(is_unusual(0.5, moon));
    EXPECT_NEAR(speed_scale(5, gravity_ratio_squared(earth * 100)), 10, 1e-12);
}

TEST(SizeScale, time_scale_follows_the_root_of_gravity_over_size) {
    EXPECT_NEAR(time_scale_ratio(0.05, 1), 1, 1e-12);
    EXPECT_NEAR(time_scale_ratio(0.0005, 1), 10, 1e-12);
    EXPECT_NEAR(time_scale_ratio(0.05, gravity_ratio_squared(earth * 100)), 10, 1e-12);
    EXPECT_FALSE(may_need_size_level(0.05, earth));
    EXPECT_TRUE(may_need_size_level(0.01, earth));
}

TEST(SizeScale, impacts_that_gravity_makes_in_two_steps_do_not_bounce) {
    EXPECT_EQ(bounce_speed(earth, 1.0 / 60), 0.3);
    EXPECT_EQ(bounce_speed(earth, 1.0 / 30), 0.3);
    EXPECT_EQ(bounce_speed({}, 1.0 / 60), 0.3);
    EXPECT_NEAR(bounce_speed(earth * 100, 1.0 / 60), 30, 1e-9);
    EXPECT_NEAR(bounce_speed(earth * 100, 1.0 / 240), 7.5, 1e-9);
}

TEST(SizeScale, zero_size_and_zero_gravity_have_scale_one) {
    EXPECT_EQ(size_scale(0), 1);
    EXPECT_EQ(speed_scale(0, 1), 1);
    EXPECT_EQ(gravity_ratio_squared({}), 1);
    EXPECT_FALSE(is_unusual(0.5, gravity_ratio_squared({})));
}

}  // namespace
}  // namespace jostle::test
