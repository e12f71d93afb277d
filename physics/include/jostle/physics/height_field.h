// SPDX-License-Identifier: MIT
//
// Height fields: a regular grid of heights, immutable once built.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

/// Maximum number of samples of a height field.
inline constexpr std::size_t max_height_samples = 16u << 20;

/// A grid of heights, centred on the local origin. Sample (column, row) is at x = (column -
/// (columns - 1) / 2) spacing_x, z likewise, with its height along y. Each cell between four
/// samples consists of two triangles divided by the diagonal from (column, row) to (column + 1, row
/// + 1).
///
/// Shared by any number of shapes, worlds and threads once built by build_height_field().
struct HeightGrid {
    /// Number of samples along x and z: at least 2 each, at most max_height_samples in total.
    std::uint32_t columns = 0, rows = 0;
    double spacing_x = 1, spacing_z = 1;  ///< m, 0.0001 to 10000; the grid is at most 20000 m wide
    std::vector<double> heights = {};     ///< m, within 10000; columns * rows entries, row by row
    /// Non-zero entries mark cells as holes. (columns - 1) * (rows - 1) entries, row by row; empty:
    /// no holes.
    std::vector<std::uint8_t> holes = {};

    // Derived by build_height_field.
    Aabb bounds = {};                ///< in the local frame
    std::uint64_t content_hash = 0;  ///< equal for equal contents
};

/// Builds a height field. A NaN height turns the adjacent cells into holes.
///
/// Errors: invalid_argument, naming the height or the size.
Result<std::shared_ptr<const HeightGrid>> build_height_field(HeightGrid grid);

}  // namespace jostle::physics
