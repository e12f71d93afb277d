// SPDX-License-Identifier: MIT
//
// Assigns entities to interest cells, so that clients with an area of interest are sent only nearby
// cells. Cells are squares on the ground, columns of any height. Entities that are larger than a
// cell or unbounded belong to a cell of their own, `everywhere`, which every client sees. An entity
// changes its cell only an eighth of a cell beyond the border, so that entities on a border do not
// alternate.
//
// Threads: one thread at a time.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "jostle/snapshot/entity_state.h"
#include "server/world/frame.h"

namespace jostle::server {

// 0: everywhere; otherwise two 16-bit coordinates, plus one.
using CellId = std::uint32_t;
inline constexpr CellId everywhere = 0;

struct CellCoordinates {
    int x = 0, z = 0;
};

class CellGrid {
public:
    // `interest_cell_m`: cell edge in m.
    CellGrid(double interest_cell_m, const snapshot::QuantSpec& spec);

    // The entities of the frame by cell; each cell in ascending order of id.
    using Cells = std::unordered_map<CellId, snapshot::QuantizedFrame>;
    Cells split(const snapshot::QuantizedFrame& frame, const EntityList& entities);

    double interest_cell_m() const { return cell_m_; }
    static CellId id_of(CellCoordinates coordinates);
    static CellCoordinates coordinates_of(CellId cell);
    // Distance in m from a point on the ground to a cell; 0 inside, and for `everywhere`.
    double distance(CellId cell, double x_m, double z_m) const;

private:
    CellId cell_of(const snapshot::EntityState& entity, CellId previous) const;

    const double cell_m_, units_per_cell_;
    // Cells of the entities of the last frame, in their order.
    std::vector<std::pair<EntityId, CellId>> known_;
    std::vector<std::pair<EntityId, CellId>> next_;
};

}  // namespace jostle::server
