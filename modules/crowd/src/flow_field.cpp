// SPDX-License-Identifier: MIT
#include "modules/crowd/src/flow_field.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr float never = 1e30f;            // m, of a cell that is not reached yet
constexpr float blocked_slowness = 1e4f;  // way through a cell near a wall, relative to its length
// A wall blocks the cells whose centres are nearer than this many cells, so that no way leads
// through it diagonally.
constexpr double blocked_cells = 0.75;

}  // namespace

GridSize size_of(const RouteGrid& grid) {
    if (!(grid.half_extents.x > 0) || !(grid.half_extents.y > 0)) return {};
    // At most 2e4 m / 0.05 m = 4e5 cells per side.
    const auto count = [&](double half) {
        return static_cast<std::uint32_t>(maximum(std::ceil(2 * half / grid.cell), 1));
    };
    return {count(grid.half_extents.x), count(grid.half_extents.y)};
}

void FlowField::build(const RouteGrid& grid, const WallTree& walls,
                      std::span<const GoalArea> areas) {
    size_ = size_of(grid);
    cell_ = grid.cell;
    low_ = grid.center - Vec2{0.5 * size_.columns, 0.5 * size_.rows} * cell_;
    mark_walls(walls, maximum(grid.clearance, blocked_cells * cell_));
    if (!start_from(areas)) {
        size_ = {};
        return;
    }
    march();
    compute_directions();
}

Vec2 FlowField::center_of(std::size_t cell) const {
    return low_ + Vec2{static_cast<double>(cell % size_.columns) + 0.5,
                       static_cast<double>(cell / size_.columns) + 0.5} *
                      cell_;
}

void FlowField::mark_walls(const WallTree& walls, double clearance) {
    blocked_.assign(std::size_t{size_.columns} * size_.rows, 0);
    for (std::size_t cell = 0; cell < blocked_.size(); cell++)
        blocked_[cell] = walls.is_near(center_of(cell), clearance);
}

// Puts the cells of the areas on the front. An area smaller than a cell has the cell around its
// centre. Returns false if no area is in the grid.
bool FlowField::start_from(std::span<const GoalArea> areas) {
    time_.assign(blocked_.size(), never);
    heap_.clear();
    const auto start = [&](std::size_t cell) {
        if (time_[cell] == 0) return;
        time_[cell] = 0;
        heap_.push_back({0, static_cast<std::uint32_t>(cell)});
    };
    for (const GoalArea& area : areas) {
        for (std::size_t cell = 0; cell < time_.size(); cell++)
            if (is_inside(area, center_of(cell))) start(cell);
        const Vec2 at = (area.center - low_) * (1 / cell_);
        if (at.x >= 0 && at.y >= 0 && at.x < size_.columns && at.y < size_.rows)
            start(cell_at(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y)));
    }
    std::ranges::make_heap(heap_, std::greater<>());
    return !heap_.empty();
}

void FlowField::march() {
    done_.assign(time_.size(), 0);
    while (!heap_.empty()) {
        std::ranges::pop_heap(heap_, std::greater<>());
        const Front front = heap_.back();
        heap_.pop_back();
        if (done_[front.cell]) continue;
        done_[front.cell] = 1;
        const std::uint32_t column = front.cell % size_.columns, row = front.cell / size_.columns;
        const auto update = [&](std::uint32_t c, std::uint32_t r) {
            if (c >= size_.columns || r >= size_.rows) return;  // also after an underflow
            const std::size_t cell = cell_at(c, r);
            if (done_[cell]) return;
            const float time = solve(cell);
            if (!(time < time_[cell])) return;
            time_[cell] = time;
            heap_.push_back({time, static_cast<std::uint32_t>(cell)});
            std::ranges::push_heap(heap_, std::greater<>());
        };
        update(column - 1, row), update(column + 1, row);
        update(column, row - 1), update(column, row + 1);
    }
}

// Distance of a cell from those of its finished neighbours: the upwind scheme of first order.
float FlowField::solve(std::size_t cell) const {
    const std::uint32_t column = static_cast<std::uint32_t>(cell % size_.columns);
    const std::uint32_t row = static_cast<std::uint32_t>(cell / size_.columns);
    const auto time = [&](std::uint32_t c, std::uint32_t r) {
        if (c >= size_.columns || r >= size_.rows) return never;
        const std::size_t other = cell_at(c, r);
        return done_[other] ? time_[other] : never;
    };
    const float x = std::min(time(column - 1, row), time(column + 1, row));
    const float y = std::min(time(column, row - 1), time(column, row + 1));
    const float step = static_cast<float>(cell_) * (blocked_[cell] ? blocked_slowness : 1.f);
    const float difference = x - y;
    if (std::fabs(difference) >= step) return std::min(x, y) + step;
    return 0.5f * (x + y + std::sqrt(2 * step * step - difference * difference));
}

void FlowField::compute_directions() {
    dx_.assign(time_.size(), 0);
    dy_.assign(time_.size(), 0);
    const auto time = [&](std::uint32_t c, std::uint32_t r) {
        return c >= size_.columns || r >= size_.rows ? never : time_[cell_at(c, r)];
    };
    // Descent to the lower neighbour along one axis.
    const auto slope = [](float here, float before, float after) {
        if (before <= after) return before < here ? before - here : 0.f;
        return after < here ? here - after : 0.f;
    };
    for (std::uint32_t row = 0; row < size_.rows; row++)
        for (std::uint32_t column = 0; column < size_.columns; column++) {
            const std::size_t cell = cell_at(column, row);
            const float here = time_[cell];
            const float x = slope(here, time(column - 1, row), time(column + 1, row));
            const float y = slope(here, time(column, row - 1), time(column, row + 1));
            const float size = std::sqrt(x * x + y * y);
            if (!(size > 0)) continue;
            dx_[cell] = x / size;
            dy_[cell] = y / size;
        }
}

std::optional<Vec2> FlowField::direction(Vec2 point) const {
    const Vec2 at = (point - low_) * (1 / cell_);
    if (!(at.x >= 0 && at.y >= 0 && at.x < size_.columns && at.y < size_.rows)) return std::nullopt;
    const std::size_t here =
        cell_at(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y));
    // Bilinear between the four nearest centres; blocked cells do not count for a free one.
    const double left = std::floor(at.x - 0.5), below = std::floor(at.y - 0.5);
    const double x = at.x - 0.5 - left, y = at.y - 0.5 - below;
    Vec2 sum;
    for (int k = 0; k < 4; k++) {
        const double column = left + (k & 1), row = below + (k >> 1);
        if (column < 0 || row < 0 || column >= size_.columns || row >= size_.rows) continue;
        const std::size_t cell =
            cell_at(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        if (blocked_[cell] && !blocked_[here]) continue;
        const double weight = ((k & 1) ? x : 1 - x) * ((k >> 1) ? y : 1 - y);
        sum = sum + Vec2{dx_[cell], dy_[cell]} * weight;
    }
    double size = length(sum);
    // Where ways around both sides meet, the directions cancel.
    if (size < 0.1) {
        sum = {dx_[here], dy_[here]};
        size = length(sum);
    }
    return size > 0 ? sum * (1 / size) : Vec2{};
}

double FlowField::distance(Vec2 point) const {
    const Vec2 at = (point - low_) * (1 / cell_);
    if (!(at.x >= 0 && at.y >= 0 && at.x < size_.columns && at.y < size_.rows)) return never;
    return time_[cell_at(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y))];
}

}  // namespace jostle::modules::crowd_detail
