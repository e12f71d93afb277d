// SPDX-License-Identifier: MIT
//
// Data source of queries: shapes with their poses, and an index to find them. Implementations: the
// world, a copy of it, and a subset of the shapes of either at other poses.
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

// Shape numbers are in the order of the shape ids.
class QuerySource {
public:
    virtual ~QuerySource() = default;
    virtual std::uint64_t step() const = 0;
    virtual QueryShape shape(std::uint32_t number) const = 0;
    // Returns nullopt if the shape does not exist.
    virtual std::optional<QueryShape> find(ShapeId id) const = 0;
    // All shapes except planes, with the semantics of BroadPhaseIndex.
    virtual void query(const Aabb& box, std::uint32_t categories,
                       std::vector<std::uint32_t>& found) const = 0;
    virtual void cast_ray(Vec3 origin, Vec3 motion, std::uint32_t categories,
                          const BroadPhaseIndex::RayVisit& visit) const = 0;
    virtual const std::vector<std::uint32_t>& planes() const = 0;  // ascending
};

}  // namespace jostle::physics
