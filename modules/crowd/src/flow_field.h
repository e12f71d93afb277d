// SPDX-License-Identifier: MIT
//
// Directions of the shortest way to a goal around walls, on a grid. The distance to the goal is the
// viscosity solution of the eikonal equation |grad T| = 1, computed by fast marching (J. Sethian,
// "A fast marching level set method for monotonically advancing fronts", PNAS 93, 1996). Cells near
// a wall are very slow instead of closed, so that an agent inside of them is led out again.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "jostle/modules/crowd_def.h"
#include "modules/crowd/src/wall_tree.h"

namespace jostle::modules::crowd_detail {

// Maximum number of cells of a grid.
inline constexpr std::size_t cells_max = std::size_t{1} << 17;

// Columns and rows of a grid.
struct GridSize {
    std::uint32_t columns = 0, rows = 0;
};
// Returns zeros if the grid has no area.
GridSize size_of(const RouteGrid& grid);

inline bool is_inside(const GoalArea& area, physics::Vec2 p) {
    return physics::absolute(p.x - area.center.x) <= area.half_extents.x &&
           physics::absolute(p.y - area.center.y) <= area.half_extents.y;
}

class FlowField {
public:
    void build(const RouteGrid& grid, const WallTree& walls, std::span<const GoalArea> areas);
    // Unit direction of the way; nullopt outside of the grid and if no area is in the grid.
    std::optional<physics::Vec2> direction(physics::Vec2 point) const;
    // Length of the way from the nearest cell, m; 1e30 outside of the grid.
    double distance(physics::Vec2 point) const;

private:
    std::size_t cell_at(std::uint32_t column, std::uint32_t row) const {
        return std::size_t{row} * size_.columns + column;
    }
    physics::Vec2 center_of(std::size_t cell) const;
    void mark_walls(const WallTree& walls, double clearance);
    bool start_from(std::span<const GoalArea> areas);
    void march();
    float solve(std::size_t cell) const;
    void compute_directions();

    GridSize size_;
    physics::Vec2 low_;  // m, corner of the first cell
    double cell_ = 1;    // m
    std::vector<std::uint8_t> blocked_;
    std::vector<float> time_;     // m
    std::vector<float> dx_, dy_;  // unit directions
    std::vector<std::uint8_t> done_;
    // Cells by their distance; equal distances by index.
    struct Front {
        float time;
        std::uint32_t cell;
        bool operator>(const Front& other) const {
            return time > other.time || (time == other.time && cell > other.cell);
        }
    };
    std::vector<Front> heap_;
};

}  // namespace jostle::modules::crowd_detail
