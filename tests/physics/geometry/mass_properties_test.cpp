// SPDX-License-Identifier: MIT
//
// Solids from the textbook, and two halves that are a whole. Against a sum over cells:
// world/mass_test.cpp.
#include "physics/src/geometry/mass_properties.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

void expect_same(const MassProperties& a, const MassProperties& b, double tolerance) {
    EXPECT_NEAR(a.mass, b.mass, tolerance);
    EXPECT_TRUE(near(a.center, b.center, tolerance));
    EXPECT_TRUE(near(a.inertia.x, b.inertia.x, tolerance));
    EXPECT_TRUE(near(a.inertia.y, b.inertia.y, tolerance));
    EXPECT_TRUE(near(a.inertia.z, b.inertia.z, tolerance));
}

TEST(MassProperties, cylinder_and_cone_match_the_closed_form) {
    // Radius 2, height 6, density 5.
    const MassProperties cylinder = mass_of(Cylinder{2, 3}, 5);
    EXPECT_NEAR(cylinder.mass, 5 * pi * 4 * 6, 1e-9);
    EXPECT_NEAR(cylinder.inertia.y.y, cylinder.mass * 4 / 2, 1e-9);
    EXPECT_NEAR(cylinder.inertia.x.x, cylinder.mass * (3 * 4 + 36) / 12, 1e-9);
    const MassProperties cone = mass_of(Cone{2, 3}, 5);
    EXPECT_NEAR(cone.mass, cylinder.mass / 3, 1e-9);
    EXPECT_TRUE(near(cone.center, {0, -1.5, 0}, 1e-12)) << "a quarter of its height from the base";
    EXPECT_NEAR(cone.inertia.y.y, 0.3 * cone.mass * 4, 1e-9);
    EXPECT_NEAR(cone.inertia.z.z, cone.mass * (3.0 / 20 * 4 + 3.0 / 80 * 36), 1e-9);
}

TEST(MassProperties, surfaces_have_none) {
    EXPECT_EQ(mass_of(Plane{}, 1000).mass, 0);
    const Vec3 corners[] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const std::array<std::uint32_t, 3> triangles[] = {{0, 1, 2}};
    EXPECT_EQ(mass_of(Mesh{must(build_mesh(corners, triangles))}, 1000).mass, 0);
}

// A bar of 1 x 1 x 4 m as two of 1 x 1 x 2 m, in any pose of the whole.
TEST(MassProperties, two_halves_add_up_to_the_solid) {
    const MassProperties half = mass_of(Box{{0.5, 0.5, 1}}, 700);
    const MassProperties bar =
        combined(moved(half, {{0, 0, -1}, {}}), moved(half, {{0, 0, 1}, {}}));
    expect_same(bar, mass_of(Box{{0.5, 0.5, 2}}, 700), 1e-9);
    const Transform pose{{3, -2, 1}, from_axis_angle({1, 2, 3}, 0.7)};
    const auto posed = [&](double z) { return compose(pose, {{0, 0, z}, {}}); };
    expect_same(combined(moved(half, posed(-1)), moved(half, posed(1))), moved(bar, pose), 1e-9);
}

TEST(MassProperties, compound_is_the_sum_of_its_children) {
    const Quat turn = from_axis_angle({0, 1, 1}, 1.2);
    const auto compound = must(build_compound(
        {{Sphere{0.5}, {.position = {1, 0, 0}}}, {Box{{1, 2, 3}}, {{0, 4, 0}, turn}}}));
    expect_same(mass_of(Compound{compound}, 900),
                combined(moved(mass_of(Sphere{0.5}, 900), {{1, 0, 0}, {}}),
                         moved(mass_of(Box{{1, 2, 3}}, 900), {{0, 4, 0}, turn})),
                1e-9);
}

// A cube whose shape is moved but not turned stays a multiple of the identity, so that its body
// needs no gyroscopic term.
TEST(MassProperties, axis_aligned_cube_has_exact_zeros) {
    const Mat3 inertia = moved(mass_of(Box{}, 1000), {{0.3, -0.7, 0.1}, {}}).inertia;
    EXPECT_EQ(inertia, diagonal(Vec3{1, 1, 1} * inertia.x.x));
}

}  // namespace
}  // namespace jostle::test
