// SPDX-License-Identifier: MIT
#include "server/replication/cell_grid.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"

namespace jostle::server {
namespace {

// in cells: an entity changes its cell only this far beyond the border
constexpr double border_share = 0.125;
constexpr int coordinate_max = 32767;

// Distance in m from a coordinate to the interval [from, from + size]; 0 inside.
double gap(double coordinate, double from, double size) {
    return std::max({0.0, from - coordinate, coordinate - (from + size)});
}

}  // namespace

CellGrid::CellGrid(double interest_cell_m, const snapshot::QuantSpec& spec)
    : cell_m_(interest_cell_m), units_per_cell_(interest_cell_m * spec.units_per_meter) {}

CellId CellGrid::id_of(CellCoordinates coordinates) {
    const auto part = [](int k) {
        return static_cast<std::uint32_t>(std::clamp(k, -coordinate_max, coordinate_max) +
                                          coordinate_max);
    };
    return 1 + (part(coordinates.x) << 16 | part(coordinates.z));
}

CellCoordinates CellGrid::coordinates_of(CellId cell) {
    ASSERT(cell != everywhere);
    const auto part = [](std::uint32_t bits) { return static_cast<int>(bits) - coordinate_max; };
    return {part((cell - 1) >> 16), part((cell - 1) & 0xffff)};
}

double CellGrid::distance(CellId cell, double x_m, double z_m) const {
    if (cell == everywhere) return 0;
    const CellCoordinates coordinates = coordinates_of(cell);
    return std::hypot(gap(x_m, coordinates.x * cell_m_, cell_m_),
                      gap(z_m, coordinates.z * cell_m_, cell_m_));
}

CellId CellGrid::cell_of(const snapshot::EntityState& entity, CellId previous) const {
    const double x = entity.position[0] / units_per_cell_, z = entity.position[2] / units_per_cell_;
    if (previous != everywhere) {
        const CellCoordinates old = coordinates_of(previous);
        if (gap(x, old.x, 1) <= border_share && gap(z, old.z, 1) <= border_share) return previous;
    }
    return id_of({static_cast<int>(std::floor(x)), static_cast<int>(std::floor(z))});
}

CellGrid::Cells CellGrid::split(const snapshot::QuantizedFrame& frame, const EntityList& entities) {
    Cells cells;
    next_.clear();
    next_.reserve(frame.entities.size());
    auto old = known_.begin();
    auto description = entities.begin();
    for (const snapshot::EntityState& entity : frame.entities) {
        while (description != entities.end() && (*description)->id < entity.id) ++description;
        while (old != known_.end() && old->first < entity.id) ++old;
        const bool large =
            description == entities.end() || !((*description)->bounding_radius <= cell_m_);
        const bool is_known = old != known_.end() && old->first == entity.id;
        const CellId cell =
            large ? everywhere : cell_of(entity, is_known ? old->second : everywhere);
        next_.emplace_back(entity.id, cell);
        snapshot::QuantizedFrame& to = cells[cell];
        to.frame = frame.frame;
        to.entities.push_back(entity);
    }
    ASSERT(next_.size() == frame.entities.size());
    known_.swap(next_);
    return cells;
}

}  // namespace jostle::server
