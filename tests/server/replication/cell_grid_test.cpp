// SPDX-License-Identifier: MIT
#include "server/replication/cell_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/snapshot/quantize.h"

namespace jostle::server {
namespace {

constexpr double interest_cell_m = 32;

EntityList described(std::size_t count, double bounding_radius = 0.5) {
    EntityList list;
    for (std::size_t i = 1; i <= count; i++) {
        auto entity = std::make_shared<EntityDescription>();
        entity->id = static_cast<EntityId>(i);
        entity->bounding_radius = bounding_radius;
        list.push_back(entity);
    }
    return list;
}

snapshot::EntityState at(EntityId id, double x, double z) {
    return snapshot::quantize(id, {{x, 1, z}, {0, 0, 0, 1}}, false, {});
}

// The cell of the only entity of a world.
CellId cell_of(CellGrid& grid, double x, double z) {
    const auto cells = grid.split({.frame = 1, .entities = {at(1, x, z)}}, described(1));
    EXPECT_EQ(cells.size(), 1u);
    return cells.begin()->first;
}

TEST(CellGrid, cell_ids_and_coordinates_round_trip) {
    for (const int x : {-30000, -1, 0, 1, 29999})
        for (const int z : {-29999, -1, 0, 7}) {
            const CellId cell = CellGrid::id_of({x, z});
            EXPECT_NE(cell, everywhere);
            EXPECT_EQ(CellGrid::coordinates_of(cell).x, x);
            EXPECT_EQ(CellGrid::coordinates_of(cell).z, z);
        }
}

TEST(CellGrid, assigns_entities_to_cells_and_large_ones_everywhere) {
    CellGrid grid(interest_cell_m, {});
    const snapshot::QuantizedFrame frame{
        .frame = 1, .entities = {at(1, 5, 5), at(2, -5, 5), at(3, 40, -70), at(4, 6, 6)}};
    EntityList list = described(4);
    auto ground = std::make_shared<EntityDescription>();
    ground->id = 4;
    ground->bounding_radius = std::numeric_limits<double>::infinity();
    list[3] = ground;
    const auto cells = grid.split(frame, list);
    ASSERT_EQ(cells.size(), 4u);
    EXPECT_EQ(cells.at(CellGrid::id_of({0, 0})).entities[0].id, 1u);
    EXPECT_EQ(cells.at(CellGrid::id_of({-1, 0})).entities[0].id, 2u);
    EXPECT_EQ(cells.at(CellGrid::id_of({1, -3})).entities[0].id, 3u);
    EXPECT_EQ(cells.at(everywhere).entities[0].id, 4u);
}

TEST(CellGrid, hysteresis_prevents_flicker_at_borders) {
    CellGrid grid(interest_cell_m, {});
    const CellId first = cell_of(grid, 31, 3), second = CellGrid::id_of({1, 0});
    int changes = 0;
    CellId now = first;
    for (int k = 0; k < 200; k++) {
        const CellId next = cell_of(grid, 32 + 3 * std::sin(0.3 * k), 3);
        changes += next != now;
        now = next;
    }
    EXPECT_EQ(changes, 0) << "3 m beyond the border is less than one eighth of a cell";
    EXPECT_EQ(cell_of(grid, 37, 3), second);
    EXPECT_EQ(cell_of(grid, 29, 3), second)
        << "the entity returns only one eighth of a cell past the border";
    EXPECT_EQ(cell_of(grid, 27, 3), first);
}

TEST(CellGrid, distance_is_to_the_nearest_point_of_the_cell) {
    const CellGrid grid(interest_cell_m, {});
    const CellId cell = CellGrid::id_of({1, 0});  // x from 32 to 64, z from 0 to 32
    EXPECT_EQ(grid.distance(cell, 40, 10), 0);
    EXPECT_EQ(grid.distance(cell, 2, 10), 30);
    EXPECT_NEAR(grid.distance(cell, 29, 36), 5, 1e-12);
    EXPECT_EQ(grid.distance(everywhere, 1e6, 0), 0);
}

}  // namespace
}  // namespace jostle::server
