// SPDX-License-Identifier: MIT
//
// Interface of the broad phases, which find overlapping boxes. Each box carries a caller-defined
// number and category bits. The order of results is unspecified; callers that need an order sort
// them.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/defs.h"

namespace jostle::physics {

class BroadPhaseIndex {
public:
    virtual ~BroadPhaseIndex() = default;

    // Returns a handle that stays valid until remove().
    virtual std::int32_t insert(const Aabb& box, std::uint32_t item, std::uint32_t category) = 0;
    virtual void remove(std::int32_t handle) = 0;
    virtual void move(std::int32_t handle, const Aabb& box) = 0;
    // Moves many boxes at once. Each handle occurs at most once.
    struct Move {
        std::int32_t handle;
        Aabb box;
    };
    virtual void move_all(std::span<const Move> moves) {
        for (const Move& m : moves) move(m.handle, m.box);
    }

    // Appends the items whose box overlaps `box` and whose category shares a bit with the mask,
    // each once.
    virtual void query(const Aabb& box, std::uint32_t mask,
                       std::vector<std::uint32_t>& found) const = 0;

    // Calls visit(item, limit) for items whose box intersects the segment within [0, limit].
    // visit() returns the new limit: the fraction of its best hit so far, or the old limit.
    using RayVisit = std::function<double(std::uint32_t item, double limit)>;
    virtual void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                          const RayVisit& visit) const = 0;

    // Updates the index after moves. Queries before flush() return correct results but may be slow.
    virtual void flush() {}

    virtual std::unique_ptr<BroadPhaseIndex> clone() const = 0;
    // Copies `other` into memory that this index owns. Both indices have the same kind.
    virtual void assign(const BroadPhaseIndex& other) = 0;
    // Appends boxes that visualise the structure of the index in debug views.
    virtual void cells(std::vector<Aabb>& out) const = 0;
};

}  // namespace jostle::physics
