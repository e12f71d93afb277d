// SPDX-License-Identifier: MIT
//
// What lies below a plane: closed forms, a sum over cells, and the two sides of a cut, which are
// the whole.
#include "physics/src/geometry/shape_measures.h"

#include <gtest/gtest.h>

#include "physics/src/geometry/mass_properties.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

std::vector<std::pair<const char*, Geometry>> solids() {
    const std::vector<Vec3> points{
        {-1, 0, 0}, {1, 0.2, 0}, {0, 1.5, 0.3}, {0.2, 0.4, 1}, {0, -1, -1}};
    return {{"sphere", Sphere{0.7}},
            {"capsule", Capsule{0.4, 0.9}},
            {"box", Box{{0.5, 0.8, 1.1}}},
            {"cylinder", Cylinder{0.6, 0.8}},
            {"cone", Cone{0.6, 0.8}},
            {"hull", Hull{must(build_hull(points))}},
            {"compound", Compound{must(build_compound({{Box{{0.3, 0.3, 0.3}}, {{1, 0, 0}, {}}},
                                                       {Sphere{0.4}, {{-1, 0.2, 0}, {}}}}))}}};
}

TEST(Displacement, half_ball_matches_the_closed_form) {
    const Displacement half = displacement(Sphere{2}, {0, 1, 0}, 0);
    EXPECT_NEAR(half.volume, 2.0 / 3 * pi * 8, 1e-12);
    EXPECT_TRUE(near(half.center, {0, -3.0 / 8 * 2, 0}, 1e-12));
}

TEST(Displacement, corner_of_a_box_is_a_pyramid) {
    // The corner at (1, 1, 1): cut at a distance of 1 along each edge.
    const Vec3 out = normalized(Vec3{-1, -1, -1});
    const Displacement corner = displacement(Box{{1, 1, 1}}, out, dot(out, {0, 1, 1}));
    EXPECT_NEAR(corner.volume, 1.0 / 6, 1e-12);
    EXPECT_TRUE(near(corner.center, {0.75, 0.75, 0.75}, 1e-12));
}

TEST(Displacement, tilted_cylinder_and_cone_match_the_closed_form) {
    // A plane through the axis takes half, whose centre is 4 r / 3 pi from it.
    const Displacement half = displacement(Cylinder{3, 2}, {0, 0, 1}, 0);
    EXPECT_NEAR(half.volume, pi * 9 * 2, 1e-5);
    EXPECT_TRUE(near(half.center, {0, 0, -4 * 3 / (3 * pi)}, 1e-5));
    // The tip above half the height is an eighth.
    const Displacement tip = displacement(Cone{2, 3}, {0, -1, 0}, 0);
    EXPECT_NEAR(tip.volume, pi * 4 * 6 / 3 / 8, 1e-9);
}

TEST(Displacement, both_sides_of_a_cut_add_up_to_the_solid) {
    for (const auto& [name, solid] : solids()) {
        const MassProperties whole = mass_of(solid, 1);
        for (const Vec3 n : {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, 2, -1}, Vec3{0.001, -1, 0}})
            for (const double offset : {-0.5, -0.13, 0.0, 0.2, 0.61}) {
                const Vec3 normal = normalized(n);
                const Displacement low = displacement(solid, normal, offset),
                                   high = displacement(solid, -normal, -offset);
                EXPECT_NEAR(low.volume + high.volume, whole.mass, 2e-6 * whole.mass) << name;
                EXPECT_TRUE(near(low.center * low.volume + high.center * high.volume,
                                 whole.center * whole.mass, 1e-5))
                    << name << " cut at " << offset;
            }
    }
}

// 200 slices across the axis, each a segment of a disc or none: an oracle of another kind, cells.
TEST(Displacement, matches_a_sum_over_cells) {
    const Vec3 normal = normalized(Vec3{0.4, 0.8, -0.3});
    const double offset = 0.17;
    const Capsule capsule{0.4, 0.9};
    const double step = 0.01;
    double volume = 0;
    Vec3 moment;
    for (double x = -0.4 + step / 2; x < 0.4; x += step)
        for (double y = -1.3 + step / 2; y < 1.3; y += step)
            for (double z = -0.4 + step / 2; z < 0.4; z += step) {
                const double up = absolute(y) > 0.9 ? absolute(y) - 0.9 : 0;
                const Vec3 p{x, y, z};
                if (x * x + z * z + up * up > 0.16 || dot(normal, p) > offset) continue;
                volume += step * step * step;
                moment += p * (step * step * step);
            }
    const Displacement found = displacement(capsule, normal, offset);
    EXPECT_NEAR(found.volume / volume, 1, 2e-3);
    EXPECT_TRUE(near(found.center, moment / volume, 2e-3));
}

TEST(Displacement, surfaces_have_none) {
    EXPECT_EQ(displacement(Plane{}, {0, 1, 0}, 5).volume, 0);
}

}  // namespace
}  // namespace jostle::test
