// SPDX-License-Identifier: MIT
//
// What a module tells clients, as it is written.
#include <gtest/gtest.h>

#include <limits>

#include "jostle/physics/channels.h"

namespace jostle::test {
namespace {
using namespace physics;

std::uint32_t known_below_ten(BodyId body) {
    return body.index < 10 ? body.index + 100 : 0;
}

TEST(ChannelWriter, numbers_are_quantized_and_clamped) {
    ChannelWriter told(known_below_ten);
    ASSERT_TRUE(told.begin(0, {2, 1}));
    told.value(-5);
    told.f32(1);
    told.body({3, 1});
    told.body({30, 1});
    told.quantized(0.5, 0, 1, 8);
    told.quantized(7, 0, 1, 16);
    told.quantized(-7, 0, 1, 16);
    told.quantized(std::numeric_limits<double>::quiet_NaN(), 0, 1, 8);
    told.quantized(1, -1, 1, 31);
    ASSERT_EQ(told.channels().size(), 1u);
    EXPECT_EQ(told.channels()[0].entity, 102u);
    const std::vector<std::int32_t> expected{-5, 0x3f800000, 103, 0, 128, 65535, 0, 0, 0x7fffffff};
    EXPECT_EQ(told.channels()[0].values, expected);
}

TEST(ChannelWriter, skips_channels_that_are_not_due_and_unknown_bodies) {
    ChannelWriter told(known_below_ten, {true, false});
    EXPECT_FALSE(told.begin(1));
    told.value(1);
    EXPECT_FALSE(told.begin(0, {10, 1}));
    told.value(2);
    EXPECT_TRUE(told.begin(0));
    told.value(3);
    ASSERT_EQ(told.channels().size(), 1u);
    EXPECT_EQ(told.channels()[0].entity, 0u) << "the module itself";
    EXPECT_EQ(told.channels()[0].values, std::vector<std::int32_t>{3});
}

TEST(ChannelWriter, points_and_fields_include_their_units) {
    ChannelWriter told(known_below_ten);
    told.begin(0);
    const Vec3 points[] = {{1, -0.5, 0.001}, {1e30, -1e30, 0}};
    told.points(1000, points);
    told.begin(1);
    const double heights[] = {0.25, 0.5, -0.25, 1, 2, 3};
    told.field(4, 3, heights);
    const std::int32_t most = std::numeric_limits<std::int32_t>::max();
    EXPECT_EQ(told.channels()[0].values,
              (std::vector<std::int32_t>{1000, 1000, -500, 1, most, -most, 0}));
    EXPECT_EQ(told.channels()[1].values, (std::vector<std::int32_t>{3, 2, 4, 1, 2, -1, 4, 8, 12}));
}

}  // namespace
}  // namespace jostle::test
