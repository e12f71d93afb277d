// SPDX-License-Identifier: MIT
//
// Turbulent air with zero speed causes the drag of still air.
#include <gtest/gtest.h>

#include "jostle/physics/hull.h"
#include "modules/fields/src/body_field_cache.h"
#include "tests/modules/fields/fall.h"
#include "tests/modules/fields/with_fields.h"

namespace jostle::modules {
namespace {

void add_still_air(World& world, double drag) {
    add_field(world, {.law = Turbulence{.speed = 0, .drag = drag}});
}

TEST(Drag, fall_in_still_air_follows_tanh) {
    const double ball = worst_fall_error(add_still_air, ball_of_fall());
    const double box = worst_fall_error(add_still_air, box_of_fall());
    // A feather with a terminal speed of 0.5 m/s.
    const double feather =
        worst_fall_error(add_still_air, {Box{{0.3, 0.005, 0.3}}, 1.5, 0.36, 1.0});
    RecordProperty("ball_error", std::to_string(ball));
    RecordProperty("box_error", std::to_string(box));
    RecordProperty("feather_error", std::to_string(feather));
    EXPECT_LT(ball, 5e-3);
    EXPECT_LT(box, 5e-3);
    EXPECT_LT(feather, 5e-3);
}

TEST(Drag, very_strong_drag_stays_stable) {
    World world = test::make_world({.gravity = {}});
    const BodyId feather =
        test::must(world.create_body({.mass = 1e-4}, {.geometry = Box{{0.5, 0.01, 0.5}}}));
    add_field(world, {.law = Turbulence{.wind = {0, 30, 0}, .speed = 0, .density = 1000}});
    for (int step = 0; step < 120; step++) {
        test::must(world.step(1.0 / 60));
        const double v = test::velocity_of(world, feather).y;
        ASSERT_TRUE(v > 0 && v <= 30) << "step " << step;
    }
}

// The projected area of a single shape equals the area of its outline in any direction.
double projected_shapes(const Geometry& geometry, Vec3 direction) {
    World world = test::make_world();
    const BodyId body = test::add(world, {.geometry = geometry});
    fields_detail::BodyFieldCache body_cache;
    const BodyId bodies[] = {body};
    body_cache.reserve(world.body_index_end());
    body_cache.refresh(world, bodies);
    return fields_detail::projected_area(body_cache.of(body), normalized(direction));
}

TEST(Drag, acts_on_the_projected_area) {
    EXPECT_NEAR(projected_shapes(Sphere{0.5}, {1, 2, 3}), pi / 4, 1e-12);
    EXPECT_NEAR(projected_shapes(Box{{0.5, 1, 2}}, {1, 0, 0}), 8, 1e-12);
    EXPECT_NEAR(projected_shapes(Box{{0.5, 0.5, 0.5}}, {1, 1, 1}), square_root(3), 1e-12);
    EXPECT_NEAR(projected_shapes(Capsule{0.5, 1}, {1, 0, 0}), pi / 4 + 2, 1e-12);
    EXPECT_NEAR(projected_shapes(Capsule{0.5, 1}, {0, 1, 0}), pi / 4, 1e-12);
    EXPECT_NEAR(projected_shapes(Cylinder{0.5, 1}, {0, 0, 1}), 2, 1e-12);
    EXPECT_NEAR(projected_shapes(Cone{0.5, 1}, {1, 0, 0}), 1, 1e-12);
    EXPECT_NEAR(projected_shapes(Cone{0.5, 1}, {0, 1, 0}), pi / 4, 1e-12);
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Geometry wedge = Hull{test::must(build_hull(corners))};
    EXPECT_NEAR(projected_shapes(wedge, {0, 0, 1}), 0.5, 1e-12);
    EXPECT_NEAR(projected_shapes(wedge, {1, 1, 1}), square_root(3) / 2, 1e-12);
}

}  // namespace
}  // namespace jostle::modules
