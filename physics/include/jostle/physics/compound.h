// SPDX-License-Identifier: MIT
//
// Compounds: several convex shapes in one, found through a tree. Built once, immutable, shared by
// any number of shapes and worlds, from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/result.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

class Bvh;

inline constexpr std::size_t max_compound_children = 60000;

struct CompoundChild {
    Geometry geometry = {};  // convex
    Transform pose = {};     // in the compound; coordinates within max_shape_size
};

struct CompoundShape {
    std::vector<CompoundChild> children;

    // Derived by build_compound.
    std::shared_ptr<const Bvh> tree;  // of the children
    Aabb bounds;
    double inner_radius = 0;  // m: of the ball that fits into the thinnest child
    std::uint64_t content_hash = 0;
};

// Of 1 to max_compound_children. Children may overlap; each counts in full for the mass. An error
// names the child: "children[3] ...".
Result<std::shared_ptr<const CompoundShape>> build_compound(std::vector<CompoundChild> children);

}  // namespace jostle::physics
