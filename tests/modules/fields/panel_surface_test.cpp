// SPDX-License-Identifier: MIT
//
// Panel surfaces are closed and enclose the volume of their shapes.
#include "modules/fields/src/panel_surface.h"

#include <gtest/gtest.h>

#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"
#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::modules::fields_detail {
namespace {

using namespace physics;

double volume_of(const PanelSurface& surface) {
    double volume = 0;
    for (const auto& t : surface.triangles)
        volume += dot(surface.vertices[t[0]], area_of(surface, t)) / 3;
    return volume;
}

void expect_closed(const PanelSurface& surface, double volume) {
    Vec3 sum;
    double size = 0;
    for (const auto& t : surface.triangles) {
        sum += area_of(surface, t);
        size += length(area_of(surface, t));
    }
    EXPECT_LT(length(sum), 1e-12 * size);
    EXPECT_NEAR(volume_of(surface), volume, 1e-12 * volume);
}

TEST(PanelSurface, encloses_the_shape_volume_at_any_refinement) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const auto hull = test::must(build_hull(corners));
    const std::pair<Geometry, double> shapes[] = {
        {Box{{0.5, 1, 2}}, 8},      {Sphere{0.5}, pi / 6},  {Capsule{0.5, 1}, pi / 2 + pi / 6},
        {Cylinder{0.5, 1}, pi / 2}, {Cone{0.5, 1}, pi / 6}, {Hull{hull}, hull->volume},
    };
    const Transform pose{{3, -2, 1}, from_axis_angle({1, 2, 3}, 1)};
    for (const auto& [geometry, volume] : shapes) {
        PanelSurface surface = panel_surfaces(geometry, pose).front();
        expect_closed(surface, volume);
        refine(surface, 0.2, 1e30, 4000);
        EXPECT_GT(surface.triangles.size(), 50u);
        expect_closed(surface, volume);
    }
}

TEST(PanelSurface, refines_to_a_length_or_an_area) {
    PanelSurface by_length = panel_surfaces(Box{{2, 0.5, 0.5}}, {}).front();
    PanelSurface by_area = by_length;
    refine(by_length, 0.5, 1e30, 4000);
    for (const auto& t : by_length.triangles)
        for (int k = 0; k < 3; k++)
            EXPECT_LE(length(by_length.vertices[t[k]] - by_length.vertices[t[(k + 1) % 3]]), 0.5);
    refine(by_area, 1e30, 0.1, 4000);
    for (const auto& t : by_area.triangles) {
        EXPECT_LE(length(area_of(by_area, t)), 0.1);
        EXPECT_GE(length(area_of(by_area, t)), 0.05 - 1e-12);
    }
    PanelSurface few = panel_surfaces(Box{}, {}).front();
    refine(few, 1e-3, 1e30, 100);
    EXPECT_EQ(few.triangles.size(), 100u);
}

TEST(PanelSurface, compound_gives_one_surface_per_child) {
    const auto compound = test::must(
        build_compound({{.geometry = Box{}}, {.geometry = Sphere{}, .pose = {{0, 1, 0}, {}}}}));
    const auto surfaces = panel_surfaces(Compound{compound}, {{5, 0, 0}, {}});
    ASSERT_EQ(surfaces.size(), 2u);
    EXPECT_EQ(surfaces[1].ball, 0.5);
    EXPECT_TRUE(test::near(surfaces[1].center, {5, 1, 0}, 1e-12));
    EXPECT_TRUE(panel_surfaces(Plane{}, {}).empty());
}

}  // namespace
}  // namespace jostle::modules::fields_detail
