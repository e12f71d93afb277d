// SPDX-License-Identifier: MIT
//
// Bounding boxes of height-field cells, four of a row at a time, so that most cells under a shape
// are rejected without testing their triangles.
#pragma once

#include <algorithm>
#include <bit>

#include "jostle/base/check.h"
#include "physics/src/geometry/box_lanes.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {

// Visits the two triangles of a cell, unless it is a hole.
template <class Visit>
void visit_cell(const HeightGrid& grid, std::uint32_t column, std::uint32_t row, Visit&& visit) {
    const std::uint32_t cell = row * (grid.columns - 1) + column;
    if (is_hole(grid, cell)) return;
    ASSERT(column + 1 < grid.columns && row + 1 < grid.rows);
    const Vec3 near = sample(grid, column, row), far = sample(grid, column + 1, row + 1);
    visit(SurfaceTriangle{{near, far, sample(grid, column + 1, row)}, cell * 2});
    visit(SurfaceTriangle{{near, sample(grid, column, row + 1), far}, cell * 2 + 1});
}

// Computes the boxes of up to four cells of a row.
class GridLanes {
public:
    explicit GridLanes(const HeightGrid& grid)
        : grid_(grid),
          spacing_(static_cast<float>(grid.spacing_x)),
          margin_x_(static_cast<float>(rounding * grid.bounds.high.x)),
          margin_y_(static_cast<float>(
              rounding * maximum(absolute(grid.bounds.low.y), absolute(grid.bounds.high.y)))) {}

    // Selects a row. Rows may be selected in any order.
    void begin_row(std::uint32_t row) {
        const double z = sample(grid_, 0, row).z;
        ASSERT(row + 1 < grid_.rows);
        boxes_.low[2] = splat4(float_below(z - rounding * absolute(z)));
        boxes_.high[2] = splat4(float_above(z + grid_.spacing_z + rounding * absolute(z)));
        near_ = &grid_.heights[std::size_t{row} * grid_.columns];
    }
    // Returns the boxes of four cells from this column on. Beyond the end of the row, the last cell
    // is repeated.
    const BoxLanes& boxes_from(std::uint32_t column) {
        const double x = (column - 0.5 * (grid_.columns - 1)) * grid_.spacing_x;
        const Float4 from = splat4(static_cast<float>(x)) + Float4{0, 1, 2, 3} * splat4(spacing_);
        boxes_.low[0] = from - splat4(margin_x_);
        boxes_.high[0] = from + splat4(spacing_ + margin_x_);
        std::uint32_t at[5];
        for (std::uint32_t k = 0; k < 5; k++) at[k] = std::min(column + k, grid_.columns - 1);
        const Float4 a = heights(near_, at), b = heights(near_, at + 1);
        const double* far = near_ + grid_.columns;
        const Float4 c = heights(far, at), d = heights(far, at + 1);
        boxes_.low[1] = smaller4(smaller4(a, b), smaller4(c, d)) - splat4(margin_y_);
        boxes_.high[1] = larger4(larger4(a, b), larger4(c, d)) + splat4(margin_y_);
        return boxes_;
    }

private:
    // Exceeds the rounding error of float, relative to the largest value.
    static constexpr double rounding = 1e-6;

    static Float4 heights(const double* row, const std::uint32_t at[4]) {
        return Float4{static_cast<float>(row[at[0]]), static_cast<float>(row[at[1]]),
                      static_cast<float>(row[at[2]]), static_cast<float>(row[at[3]])};
    }

    const HeightGrid& grid_;
    float spacing_, margin_x_, margin_y_;
    const double* near_ = nullptr;
    BoxLanes boxes_;
};

// Calls visit(const SurfaceTriangle&) for the triangles of cells under the box that pass
// test(boxes, leaf, key), which returns a mask. Visits the cell under `first` first, then row by
// row.
template <class Test, class Visit>
void nearest_cell_first(const HeightGrid& grid, const Aabb& box, Vec3 first, Test&& test,
                        Visit&& visit) {
    const CellRange cells = cells_under(grid, box);
    if (cells.column_begin == cells.column_end) return;
    const CellRange under = cells_under(grid, {first, first});
    ASSERT(cells.column_begin < cells.column_end && cells.row_begin < cells.row_end);
    const std::uint32_t column =
        std::clamp(under.column_begin, cells.column_begin, cells.column_end - 1);
    const std::uint32_t row = std::clamp(under.row_begin, cells.row_begin, cells.row_end - 1);
    visit_cell(grid, column, row, visit);
    GridLanes lanes(grid);
    for (std::uint32_t r = cells.row_begin; r < cells.row_end; r++) {
        lanes.begin_row(r);
        for (std::uint32_t c = cells.column_begin; c < cells.column_end; c += 4) {
            Float4 key;
            unsigned overlapping = test(lanes.boxes_from(c), true, key);
            if (cells.column_end - c < 4) overlapping &= (1u << (cells.column_end - c)) - 1;
            for (; overlapping != 0; overlapping &= overlapping - 1) {
                const std::uint32_t at =
                    c + static_cast<std::uint32_t>(std::countr_zero(overlapping));
                if (at != column || r != row) visit_cell(grid, at, r, visit);
            }
        }
    }
}

}  // namespace jostle::physics
