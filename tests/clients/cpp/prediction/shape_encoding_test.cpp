// SPDX-License-Identifier: MIT
#include "clients/cpp/prediction/wasm/shape_encoding.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "jostle/physics/compound.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::client {
namespace {

using namespace physics;
using Numbers = std::vector<double>;

const Numbers at_one_two_three{1, 2, 3, 0, 0, 0, 1};
const Numbers touch{0.7, 0.2, 0.01, 0.02, 1, 0, -1, 0, 3, 6, 5, -2, 1, 300, 0};

Numbers one(const Numbers& kind, const Numbers& sizes) {
    Numbers numbers{1};
    for (const auto* part : {&kind, &at_one_two_three, &sizes, &touch})
        numbers.insert(numbers.end(), part->begin(), part->end());
    return numbers;
}

Numbers compound(double children) {
    Numbers sizes{children, 1};
    sizes.insert(sizes.end(), at_one_two_three.begin(), at_one_two_three.end());
    sizes.push_back(0.5);
    return one({10}, sizes);
}

}  // namespace

TEST(ShapeEncoding, decodes_pose_size_and_surface_properties_of_a_box) {
    const auto shapes = decode_shapes(one({3}, {0.5, 0.25, 0.125}));
    ASSERT_TRUE(shapes);
    ASSERT_EQ(shapes->size(), 1u);
    const ShapeDef& s = shapes->front();
    EXPECT_EQ(std::get<Box>(s.geometry), (Box{{0.5, 0.25, 0.125}}));
    EXPECT_EQ(s.pose.position, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.material.friction, 0.7);
    EXPECT_EQ(s.material.surface_velocity, (Vec3{1, 0, -1}));
    EXPECT_EQ(s.material.friction_rule, Combine::average);
    EXPECT_EQ(s.material.restitution_rule, Combine::multiply);
    EXPECT_EQ(s.filter, (Filter{6, 5, -2}));
    EXPECT_TRUE(s.trigger);
    EXPECT_EQ(s.density, 300);
    EXPECT_EQ(s.mass, 0);
}

TEST(ShapeEncoding, decodes_hulls_meshes_height_fields_and_compounds) {
    const auto hull =
        decode_shapes(one({7}, {5, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1, 0.1, 0.1}));
    ASSERT_TRUE(hull);
    EXPECT_EQ(std::get<Hull>(hull->front().geometry).data->vertices.size(), 4u)
        << "one point is inside";
    const auto mesh = decode_shapes(one({8}, {3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 2, 1}));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(std::get<Mesh>(mesh->front().geometry).data->triangles.size(), 1u);
    const auto field = decode_shapes(one({9}, {2, 3, 1, 1, 0, 0.1, 0.2, 0.3, 0.4, 0.5, 1, 1}));
    ASSERT_TRUE(field);
    EXPECT_EQ(std::get<HeightField>(field->front().geometry).data->holes,
              (std::vector<std::uint8_t>{0, 1}));
    const auto several = decode_shapes(compound(1));
    ASSERT_TRUE(several);
    EXPECT_EQ(std::get<Compound>(several->front().geometry).data->children.size(), 1u);
}

TEST(ShapeEncoding, rejects_truncated_oversized_and_inconsistent_encodings) {
    const Numbers good = one({8}, {3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 2, 1});
    for (std::size_t end = 0; end < good.size(); end++)
        EXPECT_FALSE(decode_shapes(std::span(good).first(end))) << end;
    Numbers longer = good;
    longer.push_back(0);
    EXPECT_FALSE(decode_shapes(longer));
    EXPECT_FALSE(decode_shapes(compound(2)));
    EXPECT_FALSE(decode_shapes(compound(1e9)));
    EXPECT_FALSE(decode_shapes(one({8}, {3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 2, 3}))) << "a corner";
    EXPECT_FALSE(decode_shapes(one({9}, {60000, 60000, 1, 1, 0}))) << "missing heights";
    EXPECT_FALSE(decode_shapes(one({11}, {1}))) << "no kind";
}

// Random lists cause no crash and decode to valid shapes or nothing.
TEST(ShapeEncoding, does_not_crash_on_random_encodings) {
    std::mt19937 random(7);
    const Numbers odd{-1,
                      0.5,
                      1e300,
                      4294967295.0,
                      4294967296.0,
                      -0.0,
                      std::numeric_limits<double>::quiet_NaN(),
                      std::numeric_limits<double>::infinity(),
                      2,
                      10};
    const std::vector<Numbers> good{one({3}, {1, 1, 1}), compound(1),
                                    one({8}, {3, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 2, 1}),
                                    one({9}, {2, 2, 1, 1, 0, 0, 0, 0, 1, 0})};
    int shapes = 0;
    for (int k = 0; k < 20'000; k++) {
        Numbers corrupted = good[random() % good.size()];
        for (std::size_t n = 1 + random() % 2; n > 0; n--)
            corrupted[random() % corrupted.size()] = odd[random() % odd.size()];
        shapes += decode_shapes(corrupted) ? 1 : 0;
    }
    EXPECT_GT(shapes, 100);
    EXPECT_LT(shapes, 19'000);
}

}  // namespace jostle::client
