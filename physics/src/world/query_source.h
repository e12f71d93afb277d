// SPDX-License-Identifier: MIT
//
// What queries are asked of: shapes where they stand, and what finds them. The world itself, a
// copy, or some shapes of either that stand elsewhere.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "jostle/physics/queries.h"
#include "physics/src/collision/broadphase/broad_phase.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct QueryShape {
    TransformedShape transformed_shape;
    ShapeId shape;
    BodyId body;
    Filter filter;
    bool trigger = false;
};

// Its numbers of shapes rise with their ids.
class QuerySource {
public:
    virtual ~QuerySource() = default;
    virtual std::uint64_t step() const = 0;
    virtual QueryShape shape(std::uint32_t number) const = 0;
    // Nothing when it is not there.
    virtual std::optional<QueryShape> find(ShapeId id) const = 0;
    // Of all but planes, as BroadPhaseIndex has them.
    virtual void query(const Aabb& box, std::uint32_t categories,
                       std::vector<std::uint32_t>& found) const = 0;
    virtual void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t categories,
                          const BroadPhaseIndex::RayVisit& visit) const = 0;
    virtual const std::vector<std::uint32_t>& planes() const = 0;  // rising
};

}  // namespace jostle::physics
