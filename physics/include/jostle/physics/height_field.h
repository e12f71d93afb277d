// SPDX-License-Identifier: MIT
//
// Height fields: built once, immutable, shared.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"

namespace jostle::physics {

inline constexpr std::size_t max_height_samples = 16u << 20;

// Sample (column, row) stands at x = (column - (columns - 1) / 2) spacing_x, z likewise, with its
// height along y. Each cell of four samples is two triangles; the diagonal runs from (column, row)
// to (column + 1, row + 1).
struct HeightGrid {
    std::uint32_t columns = 0, rows = 0;  // samples along x and z, at least 2
    double spacing_x = 1, spacing_z = 1;  // m
    std::vector<double> heights;          // m, columns * rows, row after row
    std::vector<std::uint8_t> holes;      // per cell, (columns - 1) * (rows - 1); empty: no holes

    // Derived by build_height_field.
    Aabb bounds;
    std::uint64_t content_hash = 0;
};

// A height that is NaN makes holes of the cells around it.
Result<std::shared_ptr<const HeightGrid>> build_height_field(HeightGrid grid);

}  // namespace jostle::physics
