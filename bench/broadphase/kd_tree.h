// SPDX-License-Identifier: MIT
//
// A k-d tree of space (Bentley, "Multidimensional binary search trees used for associative
// searching", 1975), as ray tracers use it: planes across x, y or z divide space into cells where
// the sum of (surface area x number of boxes) of both sides is lowest (MacDonald and Booth,
// "Heuristics for ray tracing using space subdivision", 1990). A box is stored in every cell that
// it overlaps. A pair of boxes is reported in the one cell that contains the low corner of their
// intersection.
//
// A moved box leaves its cells and enters others, and a cell with too many boxes is divided. The
// tree is rebuilt when boxes have moved twice on average.
#pragma once

#include "physics/src/collision/broadphase/broad_phase_index.h"

namespace jostle::bench {

class KdTree final : public physics::BroadPhaseIndex {
public:
    std::int32_t insert(const physics::Aabb& box, std::uint32_t item,
                        std::uint32_t category) override;
    void remove(std::int32_t handle) override;
    void move(std::int32_t handle, const physics::Aabb& box) override;
    void query(const physics::Aabb& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override;
    void cast_ray(physics::Vec3 origin, physics::Vec3 motion, std::uint32_t mask,
                  const RayVisit& visit) const override;
    void flush() override;
    std::unique_ptr<physics::BroadPhaseIndex> clone() const override;
    void assign(const physics::BroadPhaseIndex& other) override;
    void cells(std::vector<physics::Aabb>& out) const override;

private:
    struct Entry {
        physics::Aabb box;
        std::uint32_t item = 0, category = 0;
        std::int32_t handle = -1;  // -1: free
    };
    // An inner node with a plane, or a leaf that refers to a cell.
    struct Node {
        double plane = 0;  // m
        int axis = -1;     // -1: a leaf
        // inner node: index of the lower child, the upper one follows; leaf: index of the cell
        std::int32_t below = -1;
    };
    struct Cell {
        physics::Aabb region;        // infinite on sides without a neighbour
        std::vector<Entry> entries;  // boxes that overlap the cell
        // number of entries at which a division is attempted (again)
        std::size_t split_threshold = 0;
    };
    struct Split {
        int axis = -1;
        double plane = 0;
    };
    struct Ray {
        physics::Vec3 origin, motion;
        std::uint32_t mask;
        const RayVisit* visit;
    };

    Node& node(std::int32_t i) { return nodes_[static_cast<std::size_t>(i)]; }
    const Node& node(std::int32_t i) const { return nodes_[static_cast<std::size_t>(i)]; }
    Cell& cell(std::int32_t i) { return cells_[static_cast<std::size_t>(i)]; }
    const Cell& cell(std::int32_t i) const { return cells_[static_cast<std::size_t>(i)]; }
    Entry& entry(std::int32_t handle) { return entries_[static_cast<std::size_t>(handle)]; }

    void rebuild();
    std::int32_t new_cell(const physics::Aabb& region);
    void divide(std::int32_t at, int depth);
    Split best_split(const Cell& cell) const;
    void insert_into(std::int32_t at, const Entry& entry, int depth);
    void remove_from(std::int32_t at, const physics::Aabb& box, std::int32_t handle);
    void replace(std::int32_t at, const physics::Aabb& old, const Entry& entry, int depth);
    void query_below(std::int32_t at, const physics::Aabb& box, std::uint32_t mask,
                     std::vector<std::uint32_t>& found) const;
    double cast_below(std::int32_t at, const Ray& ray, double from, double to, double limit) const;

    std::vector<Entry> entries_;  // by handle
    std::vector<std::int32_t> free_;
    std::vector<Node> nodes_;  // the first is the root
    std::vector<Cell> cells_;
    std::vector<std::int32_t> spare_;  // cells that no node refers to
    std::size_t changes_ = 0;          // since the last rebuild
};

}  // namespace jostle::bench
