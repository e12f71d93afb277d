// SPDX-License-Identifier: MIT
//
// A geometry that is refused says which number is wrong and what it must be.
#include "physics/src/geometry/geometry_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "jostle/physics/hull.h"

namespace jostle::test {
namespace {
using namespace physics;

std::string error_of(const Geometry& geometry) {
    const Status status = check_geometry("shape", geometry);
    return status.ok() ? "" : status.error().message;
}

TEST(GeometryChecks, errors_name_the_field_value_and_range) {
    EXPECT_EQ(error_of(Sphere{0}), "shape.radius is 0; it must be from 0.0001 to 10000");
    EXPECT_EQ(error_of(Capsule{0.5, -1}),
              "shape.half_length is -1; it must be from 0.0001 to 10000");
    EXPECT_EQ(error_of(Box{{1, 1e5, 1}}),
              "shape.half_extents.y is 100000; it must be from 0.0001 to 10000");
    EXPECT_EQ(error_of(Cylinder{std::nan(""), 1}).substr(0, 16), "shape.radius is ");
    EXPECT_EQ(error_of(Cone{1, INFINITY}),
              "shape.half_length is inf; it must be from 0.0001 to 10000");
    EXPECT_EQ(error_of(Plane{{0, 0, 0}}),
              "shape.normal is (0, 0, 0); it must be finite and not zero");
}

TEST(GeometryChecks, shared_geometry_must_not_be_null) {
    EXPECT_EQ(error_of(Hull{}), "shape has no data; create it with build_hull");
    EXPECT_EQ(error_of(Hull{std::make_shared<const ConvexHull>()}),
              "shape has no data; create it with build_hull")
        << "put together by hand";
    EXPECT_EQ(error_of(Mesh{}), "shape has no data; create it with build_mesh");
    EXPECT_EQ(error_of(HeightField{}), "shape has no data; create it with build_height_field");
    EXPECT_EQ(error_of(Compound{}), "shape has no data; create it with build_compound");
}

TEST(GeometryChecks, ranges_are_inclusive) {
    EXPECT_EQ(error_of(Sphere{min_shape_size}), "");
    EXPECT_EQ(error_of(Sphere{max_shape_size}), "");
    EXPECT_NE(error_of(Sphere{std::nextafter(min_shape_size, 0)}), "");
    EXPECT_NE(error_of(Sphere{std::nextafter(max_shape_size, 2e4)}), "");
    EXPECT_EQ(error_of(Plane{{0, 1e-5, 0}}), "") << "any length of a normal but zero";
}

}  // namespace
}  // namespace jostle::test
