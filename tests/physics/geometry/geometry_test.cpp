// SPDX-License-Identifier: MIT
//
// Kinds have names, and shared shapes are equal when their contents are.
#include "jostle/physics/geometry.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(Geometry, ten_kinds_have_ten_names) {
    std::set<std::string> names;
    for (int k = 0; k < shape_kinds; k++) names.insert(kind_name(static_cast<ShapeKind>(k)));
    EXPECT_EQ(names.size(), 10u);
    EXPECT_EQ(names.count("unknown"), 0u);
    EXPECT_STREQ(kind_name(kind_of(Cone{})), "cone");
}

TEST(Geometry, hulls_of_equal_points_are_equal) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Hull first{must(build_hull(points))}, second{must(build_hull(points))};
    EXPECT_NE(first.data, second.data);
    EXPECT_EQ(Geometry{first}, Geometry{second});
    const Hull other{
        must(build_hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}}))};
    EXPECT_NE(Geometry{first}, Geometry{other});
    EXPECT_NE(Geometry{first}, Geometry{Hull{}});
    EXPECT_EQ(Hull{}, Hull{});
}

TEST(Geometry, meshes_height_fields_and_compounds_compare_by_content) {
    const Vec3 corners[] = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const std::array<std::uint32_t, 3> up[] = {{0, 1, 2}}, down[] = {{0, 2, 1}};
    const auto mesh = [&](auto& triangles) { return Mesh{must(build_mesh(corners, triangles))}; };
    EXPECT_EQ(mesh(up), mesh(up));
    EXPECT_NE(mesh(up), mesh(down));
    const auto field = [](double height) {
        return HeightField{
            must(build_height_field({.columns = 2, .rows = 2, .heights = {0, 0, 0, height}}))};
    };
    EXPECT_EQ(field(1), field(1));
    EXPECT_NE(field(1), field(2));
    const auto compound = [](double radius) {
        return Compound{must(build_compound({{Sphere{radius}, {}}}))};
    };
    EXPECT_EQ(compound(1), compound(1));
    EXPECT_NE(compound(1), compound(2));
}

}  // namespace
}  // namespace jostle::test
