// SPDX-License-Identifier: MIT
//
// Collision of composite shapes (meshes, height fields and compounds) with any shape. A pair of
// shapes can then have several manifolds, one per flat piece or child.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/collision/narrowphase/seams.h"
#include "physics/src/collision/narrowphase/surface_motion.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

struct ChildManifold {
    // Child of a in the upper half, child of b in the lower half, each plus one. Pieces of a
    // surface have no key of their own and are distinguished by their normals.
    std::uint64_t key = 0;
    Manifold manifold;
};

inline bool is_composite(ShapeKind kind) {
    return kind == ShapeKind::mesh || kind == ShapeKind::height_field ||
           kind == ShapeKind::compound;
}

// Appends the manifold of every part with points within the margin, in an order that depends only
// on the two shapes. Appends at most about 16,000 manifolds and drops the rest.
// `stopped`: polled between parts. If it is set, parts are missing.
// `motion`: motion of the shape that is not a surface. Triangles that it does not approach are
// skipped.
// `neighbours`: shapes whose seams with these do not produce contacts; null if there are none.
// Returns whether a neighbour covers a contact (seams.h).
bool collide_composite(const TransformedShape& a, const TransformedShape& b, double margin,
                       std::vector<ChildManifold>& out, const std::atomic<bool>* stopped = nullptr,
                       const SurfaceMotion* motion = nullptr,
                       const SeamNeighbours* neighbours = nullptr);

// Returns whether two shapes of any kind share a point.
bool shapes_overlap(const TransformedShape& a, const TransformedShape& b);

}  // namespace jostle::physics
