// SPDX-License-Identifier: MIT
//
// Force fields are created, read, changed and destroyed. What they do:
// behaviour/force_fields_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

std::string error_of(World& world, const FieldDef& def) {
    const auto made = world.create_field(def);
    return made.ok() ? "" : made.error().message;
}

TEST(FieldCalls, round_trips_a_field) {
    World world;
    const FieldDef def{.force = RadialField{.center = {1, 2, 3}, .strength = -5},
                       .region = Aabb{{-1, -1, -1}, {1, 1, 1}},
                       .mask = 6,
                       .user_data = 9};
    const FieldId id = must(world.create_field(def));
    const FieldDef read = must(world.field(id));
    EXPECT_EQ(std::get<RadialField>(read.force), std::get<RadialField>(def.force));
    EXPECT_EQ(read.region, def.region);
    EXPECT_EQ(read.mask, 6u);
    EXPECT_EQ(read.user_data, 9u);
    EXPECT_EQ(world.fields(), std::vector{id});
    must(world.destroy_field(id));
    EXPECT_FALSE(world.contains(id));
    EXPECT_THAT(world.field(id).error().message, HasSubstr("no force field has the id {0, 1}"));
    EXPECT_TRUE(world.fields().empty());
}

TEST(FieldCalls, samples_fields_at_a_point) {
    const FieldSample wind = sample({.force = UniformWind{.velocity = {3, 0, 0},
                                                          .gust = {0, 2, 0},
                                                          .gust_period = 4,
                                                          .density = 1.5,
                                                          .drag = 0.5}},
                                    {7, 8, 9}, 1);
    EXPECT_LT(length(wind.flow - Vec3{3, 2, 0}), 1e-9);  // a quarter of the period
    EXPECT_EQ(wind.density, 1.5);
    EXPECT_EQ(wind.drag, 0.5);
    const FieldDef pull{.force = RadialField{.center = {1, 0, 0}, .strength = -8, .per_mass = true},
                        .region = Aabb{{-9, -9, -9}, {9, 9, 9}}};
    EXPECT_LT(length(sample(pull, {3, 0, 0}, 0).acceleration - Vec3{-2, 0, 0}), 1e-12);
    EXPECT_EQ(sample(pull, {30, 0, 0}, 0).acceleration, Vec3{});  // outside
    const FieldSample vortex =
        sample({.force = VortexField{.strength = 6, .pull = 3, .lift = 9}}, {0, 5, 3}, 0);
    EXPECT_LT(length(vortex.force - Vec3{2, 3, -1}), 1e-12);
    const FieldDef water{.force = BuoyancyField{.offset = 2, .density = 1000, .flow = {1, 0, 0}}};
    EXPECT_EQ(sample(water, {0, 1, 0}, 0).density, 1000);
    EXPECT_EQ(sample(water, {0, 3, 0}, 0).density, 0);
}

TEST(FieldCalls, errors_name_the_field) {
    World world;
    EXPECT_THAT(error_of(world, {.force = UniformWind{.drag = -1}}), HasSubstr("wind.drag is -1"));
    EXPECT_THAT(error_of(world, {.force = VortexField{.axis = {0, 2, 0}}}),
                HasSubstr("vortex.axis has length 2; it must be a unit vector"));
    EXPECT_THAT(error_of(world, {.force = RadialField{.falloff = 5}}),
                HasSubstr("radial.falloff is 5"));
    EXPECT_THAT(error_of(world, {.force = BuoyancyField{.density = 0.0 / 0.0}}),
                HasSubstr("buoyancy.density"));
    EXPECT_THAT(error_of(world, {.region = Aabb{{1, 0, 0}, {0, 0, 0}}}),
                HasSubstr("region.low is above region.high"));
    EXPECT_TRUE(world.fields().empty()) << "a refused call changes nothing";
    World flat = make_world({.planar = true});
    EXPECT_THAT(error_of(flat, {.force = BuoyancyField{}}), HasSubstr("planar"));
    EXPECT_EQ(error_of(flat, {.force = VortexField{.axis = {0, 0, 1}}}), "");
}

}  // namespace
}  // namespace jostle::test
