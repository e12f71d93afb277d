// SPDX-License-Identifier: MIT
//
// Boxes in a list sorted by their lower bound along x (sweep and prune on one axis: Baraff 1992).
// Insertion sort keeps the list ordered, which is cheap while few boxes pass a neighbour.
#pragma once

#include "physics/src/collision/broadphase/broad_phase_index.h"

namespace jostle::physics {

class SortAndSweep final : public BroadPhaseIndex {
public:
    std::int32_t insert(const Aabb& box, std::uint32_t item, std::uint32_t category) override;
    void remove(std::int32_t handle) override;
    void move(std::int32_t handle, const Aabb& box) override;
    void query(const Aabb& box, std::uint32_t mask,
               std::vector<std::uint32_t>& found) const override;
    void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                  const RayVisit& visit) const override;
    void flush() override;
    std::unique_ptr<BroadPhaseIndex> clone() const override;
    void assign(const BroadPhaseIndex& other) override;
    void cells(std::vector<Aabb>& out) const override;

private:
    struct Entry {
        Aabb box;
        std::uint32_t item = 0, category = 0;
        std::int32_t handle = -1;
    };
    std::size_t first_from(double x) const;

    std::vector<Entry> entries_;      // sorted by box.low.x if sorted_
    std::vector<double> reach_;       // [k]: largest box.high.x of entries_[0..k]
    std::vector<std::int32_t> rank_;  // indexed by handle; -1 if free
    std::vector<std::int32_t> free_;
    bool sorted_ = true;
};

}  // namespace jostle::physics
