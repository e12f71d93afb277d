// SPDX-License-Identifier: MIT
#include "server/world/point_shapes.h"

#include <gtest/gtest.h>

namespace jostle::server {
namespace {

using physics::PointForm;
using physics::Vec3;

std::shared_ptr<const PointObjectState> make(PointObjectDescription object,
                                             const std::vector<Vec3>& points) {
    object.step_um = 1000;
    object.points = static_cast<std::uint32_t>(points.size());
    auto state = std::make_shared<PointObjectState>();
    state->object = std::make_shared<const PointObjectDescription>(object);
    for (const Vec3& p : points)
        for (const double x : {p.x, p.y, p.z})
            state->values.push_back(static_cast<std::int32_t>(std::lround(1000 * x)));
    state->reach = 100;
    return state;
}

// A rope along x at a height of 2 m, and a sheet of 1 m at a height of 1 m.
PointObjects rope_and_sheet() {
    return {make({.id = 7, .form = PointForm::strands, .radius = 0.1, .strands = {3}},
                 {{-1, 2, 0}, {0, 2, 0}, {1, 2, 0}}),
            make({.id = 9, .form = PointForm::grid, .columns = 2},
                 {{0, 1, 0}, {1, 1, 0}, {0, 1, 1}, {1, 1, 1}})};
}

std::vector<PlacedPoints> placed(const PointObjects& objects) {
    return place_points(
        objects,
        [](EntityId) {
            return std::optional(physics::Transform{{0, 0, 5}, {}});
        },
        [](Vec3, double) { return true; });
}

TEST(PointShapes, rays_hit_the_surface_of_links_and_sheets) {
    const PointShapes shapes(placed(rope_and_sheet()));
    const auto rope = shapes.queries().cast_ray({{0.6, 5, 0}, {0, -10, 0}});
    ASSERT_TRUE(rope.ok() && *rope);
    EXPECT_EQ(shapes.object_of((*rope)->shape), 7u);
    EXPECT_NEAR((*rope)->point.y, 2.1, 1e-9);
    const auto sheet = shapes.queries().cast_ray({{0.6, 5, 0.5}, {0, -10, 0}});
    ASSERT_TRUE(sheet.ok() && *sheet);
    EXPECT_EQ(shapes.object_of((*sheet)->shape), 9u);
    EXPECT_NEAR((*sheet)->point.y, 1, 1e-9);
    const auto below = shapes.queries().cast_ray({{0.6, -5, 0.5}, {0, 10, 0}});
    ASSERT_TRUE(below.ok() && *below) << "sheets have two sides";
    EXPECT_NEAR((*below)->point.y, 1, 1e-9);
    const auto beside = shapes.queries().cast_ray({{1.3, 5, 0.5}, {0, -10, 0}});
    EXPECT_FALSE(*beside);
}

TEST(PointShapes, finds_overlaps_and_closest_points) {
    const PointShapes shapes(placed(rope_and_sheet()));
    const auto overlap =
        shapes.queries().overlap_shape(physics::Sphere{0.25}, {.position = {-0.5, 2.3, 0}});
    ASSERT_TRUE(overlap.ok());
    ASSERT_EQ(overlap->size(), 1u);
    EXPECT_EQ(shapes.object_of(overlap->front()), 7u);
    const Vec3 above[] = {{0.5, 1.25, 0.5}};
    const auto closest = shapes.queries().closest_points(above, 1);
    ASSERT_TRUE(closest.ok() && closest->front());
    EXPECT_EQ(shapes.object_of(closest->front()->shape), 9u);
    EXPECT_NEAR(closest->front()->distance, 0.25, 1e-9);
}

// The ray test of aims agrees with the shapes.
TEST(PointShapes, ray_test_without_shapes_finds_the_same) {
    const std::vector<PlacedPoints> points = placed(rope_and_sheet());
    const PointShapes shapes(points);
    for (int k = 0; k < 200; k++) {
        const physics::Ray ray{{-1.5 + 0.016 * k, 4, 0.7}, {0.3, -6, -0.01 * k}};
        const auto fast = cast_ray(points, ray);
        const auto exact = *shapes.queries().cast_ray(ray);
        ASSERT_EQ(fast.has_value(), exact.has_value()) << k;
        if (!fast) continue;
        EXPECT_EQ(fast->object->id, shapes.object_of(exact->shape)) << k;
        // The test takes a link for a cylinder without caps that is entered at its own angle.
        EXPECT_NEAR(fast->fraction, exact->fraction, 0.02) << k;
    }
}

TEST(PointShapes, points_of_an_entity_follow_it_and_loose_points_have_no_shape) {
    const PointObjects objects = {
        make({.id = 1, .entity = 3, .form = PointForm::strands, .radius = 0.1, .strands = {2}},
             {{0, 0, 0}, {1, 0, 0}}),
        make({.id = 2, .form = PointForm::loose}, {{0, 0, 0}})};
    const std::vector<PlacedPoints> points = placed(objects);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].positions[1], (Vec3{1, 0, 5}));
}

TEST(PointShapes, interpolates_between_two_states) {
    std::vector<PlacedPoints> points = placed(rope_and_sheet());
    std::vector<PlacedPoints> later = points;
    for (Vec3& p : later[0].positions) p += Vec3{0, 1, 0};
    interpolate_points(points, later, 0.25);
    EXPECT_NEAR(points[0].positions[0].y, 2.25, 1e-12);
    EXPECT_EQ(points[1].positions[0].y, 1);
}

}  // namespace
}  // namespace jostle::server
