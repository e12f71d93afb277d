// SPDX-License-Identifier: MIT
//
// What a module tells clients, as it is written.
#include <gtest/gtest.h>

#include <array>
#include <vector>

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

TEST(ChannelWriter, passes_point_objects_of_due_kinds_and_known_bodies) {
    std::vector<std::array<std::uint32_t, 3>> passed;
    ChannelWriter told(known_below_ten, {true, false},
                       [&](std::uint32_t kind, std::uint32_t entity, const PointObject& object) {
                           passed.push_back({kind, entity, object.key});
                       });
    EXPECT_TRUE(told.wants_points(0));
    EXPECT_TRUE(told.points(0, {.key = 7}));
    EXPECT_TRUE(told.points(0, {.key = 8, .body = {2, 1}}));
    EXPECT_FALSE(told.points(0, {.key = 9, .body = {10, 1}})) << "an unknown body";
    EXPECT_FALSE(told.wants_points(1));
    EXPECT_FALSE(told.points(1, {.key = 10})) << "not due";
    const std::vector<std::array<std::uint32_t, 3>> expected{{0, 0, 7}, {0, 102, 8}};
    EXPECT_EQ(passed, expected);
    EXPECT_FALSE(ChannelWriter(known_below_ten).points(0, {})) << "nobody listens";
}

}  // namespace
}  // namespace jostle::test
