// SPDX-License-Identifier: MIT
//
// Convex children to a compound: its bounds, its thinnest child, and what is refused.
#include "jostle/physics/compound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "physics/src/geometry/bvh.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using testing::HasSubstr;

TEST(Compound, error_names_the_invalid_child) {
    const auto error_of = [](std::vector<CompoundChild> children) {
        return build_compound(std::move(children)).error().message;
    };
    EXPECT_EQ(error_of({}), "compound: it has no children");
    EXPECT_THAT(error_of({{Sphere{}, {}}, {Plane{}, {}}}), HasSubstr("children[1] is a plane"));
    EXPECT_THAT(error_of({{Sphere{-1}, {}}}), HasSubstr("children[0].radius is -1"));
    EXPECT_THAT(error_of({{Sphere{}, {.position = {1e5, 0, 0}}}}), HasSubstr("children[0].pose"));
    EXPECT_THAT(error_of({{Sphere{}, {.rotation = {0, 0, 0, 0}}}}), HasSubstr("non-zero rotation"));
}

// A dumbbell: two balls of 0.5 m at both ends of a rod of 0.1 m, which lies along x.
TEST(Compound, dumbbell_has_the_bounds_of_its_balls_and_the_inner_radius_of_its_rod) {
    const Quat lying = from_axis_angle({0, 0, 1}, pi / 2);
    const auto dumbbell = must(build_compound({{Sphere{0.5}, {.position = {-1, 0, 0}}},
                                               {Capsule{0.1, 1}, {.rotation = lying}},
                                               {Sphere{0.5}, {.position = {1, 0, 0}}}}));
    EXPECT_TRUE(near(dumbbell->bounds.low, {-1.5, -0.5, -0.5}, 1e-12));
    EXPECT_TRUE(near(dumbbell->bounds.high, {1.5, 0.5, 0.5}, 1e-12));
    EXPECT_EQ(dumbbell->inner_radius, 0.1);
    int met = 0;
    dumbbell->tree->query(dumbbell->bounds, [&](std::uint32_t) { met++; });
    EXPECT_EQ(met, 3);
}

TEST(Compound, compares_by_content) {
    const auto hash_of = [](double radius, double x) {
        return must(build_compound({{Sphere{radius}, {.position = {x, 0, 0}}}}))->content_hash;
    };
    EXPECT_EQ(hash_of(0.5, 1), hash_of(0.5, 1));
    EXPECT_NE(hash_of(0.5, 1), hash_of(0.6, 1));
    EXPECT_NE(hash_of(0.5, 1), hash_of(0.5, 2));
}

}  // namespace
}  // namespace jostle::test
