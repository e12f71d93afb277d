// SPDX-License-Identifier: MIT
//
// Shapes of many parts: meshes, height fields and compounds against anything. One pair of shapes
// then has several manifolds, one per flat piece or child.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/collision/narrowphase/surface_motion.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct ChildManifold {
    std::uint64_t key =
        0;  // child of a in the upper half, of b in the lower, each plus one; pieces
            // of a surface have no key of their own and are told apart by normal
    Manifold manifold;
};

inline bool is_composite(ShapeKind kind) {
    return kind == ShapeKind::mesh || kind == ShapeKind::height_field ||
           kind == ShapeKind::compound;
}

// Appends every part's manifold with points within the margin, in an order that depends on the two
// shapes alone; of more than some 16,000 only the first.
// `stopped`: looked at between parts; when it is set, parts are missing.
// `way`: of what is not a surface; triangles that it does not come near on it have no part either.
void collide_composite(const TransformedShape& a, const TransformedShape& b, double margin,
                       std::vector<ChildManifold>& out, const std::atomic<bool>* stopped = nullptr,
                       const SurfaceMotion* motion = nullptr);

// Whether two shapes of any kind share a point.
bool shapes_overlap(const TransformedShape& a, const TransformedShape& b);

}  // namespace jostle::physics
