// SPDX-License-Identifier: MIT
//
// Contact points for a given normal: finds the feature (face, edge or corner) of each shape that
// faces the other shape and clips one feature to the outline of the other.
#pragma once

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

// The feature of a convex core that faces a direction.
struct Feature {
    int count = 0;  // corners: 1 for a point, 2 for an edge, 3 or more for a face
    UninitializedArray<Vec3, max_face_vertices> corner;
    Vec3 normal;  // unit, out of the shape; for an edge, the normal closest to the direction
};
Feature feature_along(const Convex& shape, Vec3 direction);

// Result of an axis test, GJK or EPA: the separation of the cores along the normal and a pair of
// points at that separation.
struct Witness {
    Vec3 normal;          // unit, from a to b
    double distance = 0;  // m, between the cores
    Vec3 on_a, on_b;
};

// All contact points with a gap of at most `margin`, before reduction. There is at least one point,
// and one point has the gap of the witness.
struct ContactPoints {
    static constexpr int capacity = 2 * static_cast<int>(max_face_vertices);

    ContactPoints() {}  // NOLINT(modernize-use-equals-default): does not clear the arrays
    ContactPoints(const ContactPoints& other) { *this = other; }
    // Copies the used part of the arrays.
    ContactPoints& operator=(const ContactPoints& other) {
        if (this == &other) return *this;
        count = other.count;
        witness_added = other.witness_added;
        for (int k = 0; k < count; k++) {
            point[k] = other.point[k];
            gap[k] = other.gap[k];
        }
        return *this;
    }

    int count = 0;
    UninitializedArray<Vec3, capacity> point;
    double gap[capacity];
    bool witness_added = false;  // the touching features lack the witness, which is the last point
};
ContactPoints contact_points(const Convex& a, const Convex& b, const Witness& witness,
                             double margin);

// The points of b above the face of a with normal n. Empty if no point of b is above the face.
ContactPoints points_over_face(const Convex& a, const Convex& b, Vec3 n, double margin);

// Reduces the points to the best four. `size`: size of the smaller shape, m.
Manifold manifold_of(const ContactPoints& points, Vec3 normal, double size);

}  // namespace jostle::physics
