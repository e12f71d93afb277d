// SPDX-License-Identifier: MIT
//
// The cells of a height field by fours hold their triangles.
#include "physics/src/geometry/grid_lanes.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

std::shared_ptr<const HeightGrid> rough(std::uint32_t columns, std::uint32_t rows) {
    Random random(5);
    HeightGrid grid{.columns = columns, .rows = rows, .spacing_x = 0.3, .spacing_z = 0.7};
    for (std::uint32_t k = 0; k < columns * rows; k++) grid.heights.push_back(random.in(-2, 2));
    grid.holes.assign(std::size_t{columns - 1} * (rows - 1), 0);
    grid.holes[1] = 1;
    return build_height_field(std::move(grid)).value();
}

TEST(GridLanes, boxes_contain_the_triangles_of_their_cells) {
    const auto grid = rough(11, 4);
    GridLanes lanes(*grid);
    for (std::uint32_t row = 0; row < 3; row++) {
        lanes.begin_row(row);
        for (std::uint32_t column = 0; column < 10; column += 4) {
            const BoxLanes& boxes = lanes.boxes_from(column);
            for (std::uint32_t k = 0; k < 4 && column + k < 10; k++)
                visit_cell(*grid, column + k, row, [&](const SurfaceTriangle& t) {
                    for (const Vec3 corner : t.corner)
                        for (int axis = 0; axis < 3; axis++) {
                            EXPECT_LE(double{boxes.low[axis][k]}, corner[axis]);
                            EXPECT_GE(double{boxes.high[axis][k]}, corner[axis]);
                        }
                });
        }
    }
}

// The cell under the point first, each once, no hole.
TEST(GridLanes, all_cells_under_a_box_are_visited) {
    const auto grid = rough(9, 6);
    const Aabb box{{-0.8, -3, -1}, {0.7, 3, 1}};
    std::vector<std::uint32_t> found;
    const auto all = [](const BoxLanes&, bool, Float4&) { return 15u; };
    nearest_cell_first(*grid, box, {0.1, 0, 0.1}, all,
                       [&](const SurfaceTriangle& t) { found.push_back(t.index); });
    std::set<std::uint32_t> expected;
    for_each_triangle(*grid, box, [&](const SurfaceTriangle& t) { expected.insert(t.index); });
    const std::set<std::uint32_t> once(found.begin(), found.end());
    EXPECT_EQ(once.size(), found.size());
    for (const std::uint32_t index : expected) EXPECT_TRUE(once.contains(index));
    const Vec3 corner = triangle_of(*grid, found.front()).corner[0];
    EXPECT_LE(corner.x, 0.1);
    EXPECT_GE(corner.x, -0.2);
}

}  // namespace
}  // namespace jostle::test
