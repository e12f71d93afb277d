// SPDX-License-Identifier: MIT
//
// A ball of the inner radius fits inside, and no larger one at the same place.
#include "physics/src/geometry/shape_measures.h"

#include <gtest/gtest.h>

#include "physics/src/geometry/support.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(InnerRadius, matches_closed_forms) {
    EXPECT_EQ(inner_radius_of(Sphere{0.3}), 0.3);
    EXPECT_EQ(inner_radius_of(Capsule{0.1, 5}), 0.1);
    EXPECT_EQ(inner_radius_of(Box{{3, 0.02, 1}}), 0.02);
    EXPECT_EQ(inner_radius_of(Cylinder{0.1, 5}), 0.1);
    EXPECT_EQ(inner_radius_of(Cylinder{5, 0.1}), 0.1);
    EXPECT_NEAR(inner_radius_of(Cone{3, 2}), 3 * 4 / (3 + 5.0), 1e-12) << "of the triangle 3 4 5";
    EXPECT_EQ(inner_radius_of(Plane{}), 1e300);
}

TEST(InnerRadius, is_zero_for_surfaces_and_that_of_the_thinnest_child_for_compounds) {
    const auto field = must(build_height_field({.columns = 2, .rows = 2, .heights = {0, 0, 0, 0}}));
    EXPECT_EQ(inner_radius_of(HeightField{field}), 0);
    EXPECT_EQ(inner_radius_of(Compound{must(build_compound({{Sphere{2}, {}}, {Sphere{0.4}, {}}}))}),
              0.4);
}

// From the middle of that ball every tangent plane of the shape is at least so far away, and some
// plane is no further.
TEST(InnerRadius, inscribed_ball_touches_the_surface) {
    Random random(31);
    for (const ShapeKind kind : {ShapeKind::box, ShapeKind::cylinder, ShapeKind::cone}) {
        for (int round = 0; round < 20; round++) {
            const Geometry geometry = random_geometry(kind, random);
            const double radius = inner_radius_of(geometry);
            const Convex shape = convex_of(transformed_shape(geometry, {}), {});
            Vec3 middle;
            if (const auto* cone = std::get_if<Cone>(&geometry))
                middle.y = radius - cone->half_length;  // it lies on the base
            double nearest = 1e300;
            const auto look = [&](Vec3 d) {
                nearest = minimum(nearest, dot(support(shape, d) - middle, d));
            };
            for (int k = 0; k < 3000; k++) look(random.direction());
            for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
                look(axis);
                look(-axis);
            }
            EXPECT_NEAR(nearest, radius, 0.02 * radius) << kind_name(kind);
            EXPECT_GE(nearest, radius * (1 - 1e-12)) << kind_name(kind);
        }
    }
}

}  // namespace
}  // namespace jostle::test
