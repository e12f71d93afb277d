// SPDX-License-Identifier: MIT
//
// From a normal to contact points: the feature (face, edge or corner) that each shape turns towards
// the other, one cut to the outline of the other.
#pragma once

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

// The part of a convex core that looks along a direction.
struct Feature {
    int count = 0;  // corners: 1 a point, 2 an edge, more a face
    UninitializedArray<Vec3, max_face_vertices> corner;
    Vec3 normal;  // unit, out of the shape; of an edge: the one nearest to the direction
};
Feature feature_along(const Convex& shape, Vec3 direction);

// What an axis test or GJK or EPA found: the cores' separation along the normal and a pair of
// points where it is attained.
struct Witness {
    Vec3 normal;          // unit, from a to b
    double distance = 0;  // m, between the cores
    Vec3 on_a, on_b;
};

// All contact points with a gap of at most `margin`, before reduction. Always at least one, and one
// of them has the gap of the witness.
struct ContactPoints {
    static constexpr int capacity = 2 * static_cast<int>(max_face_vertices);
    int count = 0;
    UninitializedArray<Vec3, capacity> point;
    double gap[capacity];
};
ContactPoints contact_points(const Convex& a, const Convex& b, const Witness& witness,
                             double margin);

// The points of b that stand over a's face whose normal is n; none when none does.
ContactPoints points_over_face(const Convex& a, const Convex& b, Vec3 n, double margin);

// The best four of them.
// `size`: m, of the smaller shape.
Manifold manifold_of(const ContactPoints& points, Vec3 normal, double size);

}  // namespace jostle::physics
