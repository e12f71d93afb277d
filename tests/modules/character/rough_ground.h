// SPDX-License-Identifier: MIT
//
// Rough ground, closed on all sides, as a mesh and as a height field.
#pragma once

#include <array>
#include <vector>

#include "jostle/physics/height_field.h"
#include "jostle/physics/mesh.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {

inline constexpr int rough_samples = 65;
inline constexpr double rough_half = 32;  // m: half the width; the sample spacing is 1 m

// Hills, pits and cliffs, and a rim that no character can climb.
inline double rough_height(test::Random& random, int column, int row) {
    const double x = column - rough_half, z = row - rough_half;
    const double edge = physics::maximum(physics::absolute(x), physics::absolute(z));
    const double rim = edge > 28 ? 40 : 0;
    const double cliff = random.below(12) == 0 ? random.in(-3, 3) : 0;
    return rim + cliff + 1.5 * physics::sin_cos(0.3 * x).sin * physics::sin_cos(0.25 * z).cos +
           random.in(-0.3, 0.3);
}

inline std::vector<double> rough_heights(std::uint64_t seed) {
    test::Random random(seed);
    std::vector<double> heights;
    for (int row = 0; row < rough_samples; row++)
        for (int column = 0; column < rough_samples; column++)
            heights.push_back(rough_height(random, column, row));
    return heights;
}

inline physics::Geometry rough_field(std::uint64_t seed) {
    physics::HeightGrid grid{.columns = rough_samples, .rows = rough_samples};
    grid.heights = rough_heights(seed);
    return physics::HeightField{test::must(physics::build_height_field(std::move(grid)))};
}

inline physics::Geometry rough_mesh(std::uint64_t seed) {
    const std::vector<double> heights = rough_heights(seed);
    std::vector<physics::Vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int row = 0; row < rough_samples; row++)
        for (int column = 0; column < rough_samples; column++)
            corners.push_back({column - rough_half,
                               heights[static_cast<std::size_t>(row * rough_samples + column)],
                               row - rough_half});
    for (std::uint32_t row = 0; row + 1 < rough_samples; row++)
        for (std::uint32_t column = 0; column + 1 < rough_samples; column++) {
            const std::uint32_t a = row * rough_samples + column, b = a + 1, c = a + rough_samples,
                                d = c + 1;
            triangles.push_back({a, c, b});
            triangles.push_back({b, c, d});
        }
    return physics::Mesh{test::must(physics::build_mesh(corners, triangles))};
}

}  // namespace jostle::modules
