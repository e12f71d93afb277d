// SPDX-License-Identifier: MIT
//
// Compound shapes: several convex shapes in one, indexed by a bounding volume hierarchy.
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

/// Maximum number of children of a compound.
inline constexpr std::size_t max_compound_children = 60000;

/// One child of a compound.
struct CompoundChild {
    Geometry geometry = {};  ///< must be convex (is_convex)
    Transform pose = {};     ///< in the compound's local frame; coordinates within max_shape_size
};

/// A compound shape. Immutable once built, and shared by any number of shapes, worlds and threads.
/// Create it with build_compound().
struct CompoundShape {
    std::vector<CompoundChild> children;  ///< 1 to max_compound_children

    // Derived by build_compound.
    std::shared_ptr<const Bvh> tree;  ///< bounding volume hierarchy of the children
    Aabb bounds;                      ///< in the compound's local frame
    double inner_radius = 0;  ///< m, radius of the largest ball that fits into the thinnest child
    std::uint64_t content_hash = 0;  ///< equal for equal contents
};

/// Builds a compound from 1 to max_compound_children convex children. Children may overlap; each
/// contributes its full mass.
///
/// Errors: invalid_argument, naming the child: "children[3] ...".
Result<std::shared_ptr<const CompoundShape>> build_compound(std::vector<CompoundChild> children);

}  // namespace jostle::physics
