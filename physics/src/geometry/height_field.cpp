// SPDX-License-Identifier: MIT
#include "jostle/physics/height_field.h"
#include "jostle/base/check.h"

#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"
#include "physics/src/foundation/messages.h"

namespace jostle::physics {
namespace {

Error height_field_error(std::string message) {
    return invalid_argument("height field: " + std::move(message));
}

std::uint64_t hash_of(const HeightGrid& grid) {
    Hasher hasher;
    hasher.add(grid.columns);
    hasher.add(grid.rows);
    hasher.add(bits_of(grid.spacing_x));
    hasher.add(bits_of(grid.spacing_z));
    for (const double h : grid.heights) hasher.add(bits_of(h));
    for (const std::uint8_t hole : grid.holes) hasher.add(hole);
    return hasher.value;
}

}  // namespace

Result<std::shared_ptr<const HeightGrid>> build_height_field(HeightGrid grid) {
    if (grid.columns < 2 || grid.rows < 2)
        return height_field_error("it has " + std::to_string(grid.columns) + " x " +
                                  std::to_string(grid.rows) +
                                  " samples; it must have at least 2 x 2");
    if (grid.columns > max_height_samples || grid.rows > max_height_samples ||
        std::size_t{grid.columns} * grid.rows > max_height_samples)
        return height_field_error("it has more than " + std::to_string(max_height_samples) +
                                  " samples");
    if (grid.heights.size() != std::size_t{grid.columns} * grid.rows)
        return height_field_error("it has " + std::to_string(grid.heights.size()) + " heights; " +
                                  std::to_string(grid.columns) + " x " + std::to_string(grid.rows) +
                                  " samples need " +
                                  std::to_string(std::size_t{grid.columns} * grid.rows));
    for (const double s : {grid.spacing_x, grid.spacing_z})
        if (!(s >= min_shape_size && s <= max_shape_size))
            return height_field_error("its spacing must be from 0.0001 to 10000 m");
    if ((grid.columns - 1) * grid.spacing_x > 2 * max_shape_size ||
        (grid.rows - 1) * grid.spacing_z > 2 * max_shape_size)
        return height_field_error("it is wider than 20000 m");
    const std::size_t cells = std::size_t{grid.columns - 1} * (grid.rows - 1);
    if (!grid.holes.empty() && grid.holes.size() != cells)
        return height_field_error("it has " + std::to_string(grid.holes.size()) +
                                  " hole flags; it must have " + std::to_string(cells) +
                                  ", one per cell");
    bool any_hole = false;
    for (std::uint8_t& hole : grid.holes) {
        hole = hole != 0 ? 1 : 0;
        any_hole = any_hole || hole != 0;
    }
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < grid.heights.size(); i++) {
        double& h = grid.heights[i];
        if (h != h) {
            if (grid.holes.empty()) grid.holes.assign(cells, 0);
            any_hole = true;
            const std::size_t c = i % grid.columns, r = i / grid.columns;
            for (std::size_t dr = 0; dr < 2; dr++)
                for (std::size_t dc = 0; dc < 2; dc++)
                    if (r >= dr && c >= dc && r - dr < grid.rows - 1 && c - dc < grid.columns - 1)
                        grid.holes[(r - dr) * (grid.columns - 1) + (c - dc)] = 1;
            h = 0;
            continue;
        }
        if (!(absolute(h) <= max_shape_size))
            return height_field_error("heights[" + std::to_string(i) + "] is " + text(h) +
                                      "; it must be within +-10000 m");
        low = minimum(low, h);
        high = maximum(high, h);
    }
    if (!any_hole) grid.holes.clear();
    if (low > high) low = high = 0;  // holes only
    const double x = 0.5 * (grid.columns - 1) * grid.spacing_x;
    const double z = 0.5 * (grid.rows - 1) * grid.spacing_z;
    grid.bounds = {{-x, low, -z}, {x, high, z}};
    ASSERT(low <= high && x > 0 && z > 0);
    grid.content_hash = hash_of(grid);
    return std::shared_ptr<const HeightGrid>(std::make_shared<HeightGrid>(std::move(grid)));
}

}  // namespace jostle::physics
