// SPDX-License-Identifier: MIT
//
// Boxes in the cells of an unbounded grid (spatial hashing: Teschner et al. 2003). The cell size is
// two to four times the typical box size. Boxes that cover too many cells are stored in a separate
// list.
#pragma once

#include <array>
#include <unordered_map>

#include "physics/src/collision/broadphase/broad_phase_index.h"

namespace jostle::physics {

class UniformGrid final : public BroadPhaseIndex {
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
        bool alive = false, large = false;
    };
    struct Range {
        std::int64_t low[3], high[3];  // cells, both ends included
        double count() const;
    };
    Range range_of(const Aabb& box) const;
    static std::uint64_t key_of(std::int64_t x, std::int64_t y, std::int64_t z);
    void insert_into_cells(std::int32_t handle);
    void remove_from_cells(std::int32_t handle);
    template <class Visit>
    void for_each_cell(const Range& range, Visit&& visit) const;

    std::vector<Entry> entries_;  // indexed by handle
    std::vector<std::int32_t> free_;
    // Only looked up by key. The iteration order never affects results.
    std::unordered_map<std::uint64_t, std::vector<std::int32_t>> cells_;
    std::vector<std::int32_t> large_;
    double cell_ = 2;            // m
    std::size_t sized_for_ = 0;  // number of entries when the cell size was chosen
};

}  // namespace jostle::physics
