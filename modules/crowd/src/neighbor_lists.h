// SPDX-License-Identifier: MIT
//
// The nearest neighbours of every point, maintained from step to step. Each list contains more
// candidates than neighbours; it is searched again only when a point outside the list may have
// become a neighbour. The result is always that of a complete search, so the lists are not part of
// a saved state.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/world.h"
#include "modules/crowd/src/neighbor_grid.h"

namespace jostle::modules::crowd_detail {

// Maximum number of neighbours of an agent.
inline constexpr std::size_t neighbors_max = 16;

class NeighborLists {
public:
    struct Settings {
        double reach = 2.5;     // m: neighbours have a gap of at most its square
        std::size_t most = 10;  // at most neighbors_max
        bool flat = true;       // as in NeighborGrid::build()
    };
    // Updates the lists of the points k with active[k], on all threads of the world. The others are
    // not listed. Call clear() first if a point became active since the last update or is not the
    // same point.
    void update(const physics::World& world, std::span<const physics::Vec3> points,
                std::span<const double> radii, std::span<const std::uint8_t> active,
                const Settings& settings);
    // Neighbours of a point, nearest first.
    std::span<const NearPoint> of(std::size_t point) const {
        const List& list = lists_[point];
        return {list.near.points.data(), list.count};
    }
    void clear() { lists_.clear(); }

private:
    struct List {
        NearPoints near;
        std::size_t count = 0;  // neighbours: the first ones of `near`
        double clear = 0;       // m, at the search: no other point was nearer than this
        double searched = 0;    // m, travel_ at the search
        bool expired = true;    // needs a search
    };
    void refresh(std::size_t self, std::span<const physics::Vec3> points,
                 std::span<const double> radii, std::span<const std::uint8_t> active);
    void search(std::size_t self, double radius);
    void count_neighbors(List& list) const;

    Settings settings_;
    NeighborGrid grid_;
    double travel_ = 0;  // m, sum over the steps of the largest displacement of a point
    double largest_radius_ = 0;
    std::vector<List> lists_;
    std::vector<physics::Vec3> previous_;  // points of the last update
};

}  // namespace jostle::modules::crowd_detail
