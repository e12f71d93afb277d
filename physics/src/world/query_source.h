// SPDX-License-Identifier: MIT
//
// What queries are asked of: shapes where they stand, and the broad phases that find them. Either
// the world itself or a copy.
#pragma once

#include <memory>
#include <vector>

#include "collision/broadphase/broad_phase.h"
#include "geometry/placed.h"
#include "jostle/physics/queries.h"

namespace jostle::physics {

struct QueryShape {
    Placed placed;
    ShapeId shape;
    BodyId body;
    Filter filter;
    bool trigger = false;
};

class QuerySource {
public:
    virtual ~QuerySource() = default;
    virtual std::uint64_t step() const = 0;
    virtual QueryShape shape(std::uint32_t index) const = 0;
    virtual const BroadPhaseIndex& fixed() const = 0;
    virtual const BroadPhaseIndex& moving() const = 0;
    virtual const std::vector<std::uint32_t>& planes() const = 0;  // rising
};

}  // namespace jostle::physics
