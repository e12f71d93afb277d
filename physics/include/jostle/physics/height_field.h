// SPDX-License-Identifier: MIT
//
// Height fields: built once, immutable, shared by any number of shapes and worlds, from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

inline constexpr std::size_t max_height_samples = 16u << 20;

// The grid is centred on the origin: sample (column, row) stands at x = (column - (columns - 1) /
// 2) spacing_x, z likewise, with its height along y. Each cell of four samples is two triangles;
// the diagonal runs from (column, row) to (column + 1, row + 1).
struct HeightGrid {
    // Samples along x and z: at least 2 each, at most max_height_samples in all.
    std::uint32_t columns = 0, rows = 0;
    double spacing_x = 1, spacing_z = 1;  // m, 0.0001 to 10,000; the grid at most 20,000 m wide
    std::vector<double> heights = {};     // m, within 10,000; columns * rows, row after row
    // Of cells, not 0: a hole. (columns - 1) * (rows - 1), row after row; empty: no holes.
    std::vector<std::uint8_t> holes = {};

    // Derived by build_height_field.
    Aabb bounds = {};
    std::uint64_t content_hash = 0;
};

// A height that is NaN makes holes of the cells around it. An error names the height or the size.
Result<std::shared_ptr<const HeightGrid>> build_height_field(HeightGrid grid);

}  // namespace jostle::physics
