// SPDX-License-Identifier: MIT
//
// Which part of a world an entity is in, so that clients that see a part are told of that part:
// square cells of the ground, columns of any height. What is larger than a cell, or has no end, is
// seen from everywhere and in a cell of its own. An entity changes its cell when it is an eighth of
// a cell beyond the border, so that what lies on a border does not come and go.
//
// Thread rule: one thread at a time.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "jostle/snapshot/entity_state.h"
#include "server/world/frame.h"

namespace jostle::server {

// 0: what is seen from everywhere; else two whole numbers of 16 bits, plus one.
using CellId = std::uint32_t;
inline constexpr CellId everywhere = 0;

struct CellCoordinates {
    int x = 0, z = 0;
};

class CellGrid {
public:
    // `interest_cell_m`: edge of a cell.
    CellGrid(double interest_cell_m, const wire::QuantSpec& spec);

    // The entities of the frame by cell, each cell in rising order of id.
    using Cells = std::unordered_map<CellId, wire::QuantizedFrame>;
    Cells split(const wire::QuantizedFrame& frame, const EntityList& entities);

    double interest_cell_m() const { return cell_m_; }
    static CellId id_of(CellCoordinates coordinates);
    static CellCoordinates coordinates_of(CellId cell);
    // m from a point on the ground to the nearest of the cell; 0 within, and to `everywhere`.
    double distance(CellId cell, double x_m, double z_m) const;

private:
    CellId cell_of(const wire::EntityState& entity, CellId before) const;

    const double cell_m_, units_per_cell_;
    // Of the entities of the last frame, in their order.
    std::vector<std::pair<EntityId, CellId>> known_;
    std::vector<std::pair<EntityId, CellId>> next_;
};

}  // namespace jostle::server
