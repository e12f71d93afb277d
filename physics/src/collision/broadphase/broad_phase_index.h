// SPDX-License-Identifier: MIT
//
// What finds boxes that overlap: the face that every broad phase has. Boxes carry a caller's number
// and category bits; callers that need an order sort what they get.
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

    // Returns a handle that stays until remove().
    virtual std::int32_t insert(const Aabb& box, std::uint32_t item, std::uint32_t category) = 0;
    virtual void remove(std::int32_t handle) = 0;
    virtual void move(std::int32_t handle, const Aabb& box) = 0;
    // Many at once, each at most once.
    struct Move {
        std::int32_t handle;
        Aabb box;
    };
    virtual void move_all(std::span<const Move> moves) {
        for (const Move& m : moves) move(m.handle, m.box);
    }

    // Appends the items whose box overlaps and whose category has a bit in the mask, each once.
    virtual void query(const Aabb& box, std::uint32_t mask,
                       std::vector<std::uint32_t>& found) const = 0;

    // Calls visit(item, limit) for items whose box the segment meets within [0, limit]; visit
    // returns the new limit (the fraction of its best hit so far, or the old limit).
    using RayVisit = std::function<double(std::uint32_t item, double limit)>;
    virtual void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t mask,
                          const RayVisit& visit) const = 0;

    // Brings the index up to date after moves; queries in between are right but may be slow.
    virtual void flush() {}

    virtual std::unique_ptr<BroadPhaseIndex> clone() const = 0;
    // Becomes a copy, in its own memory. The other is of the same kind.
    virtual void assign(const BroadPhaseIndex& other) = 0;
    // Boxes that show how it is organised, for debug views.
    virtual void cells(std::vector<Aabb>& out) const = 0;
};

}  // namespace jostle::physics
