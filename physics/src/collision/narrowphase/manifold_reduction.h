// SPDX-License-Identifier: MIT
//
// Many contact points to the best four, in a fixed order.
#pragma once

namespace jostle::physics {

// A point in the plane of a reference face: along its two tangents, and above it.
struct FacePoint {
    double u = 0, v = 0;  // m
    double gap = 0;       // m
    int index = 0;        // the caller's
};

// Keeps at most four of `points`: the deepest, the furthest from it, and the furthest on either
// side of the line through those two; but what is deep before what may touch before the next look,
// and that before the rest, because a face that tilts bears on those alone. Returns how many; they
// are moved to the front. `size`: m, of the smaller shape.
int reduce_to_four(FacePoint* points, int count, double size);

}  // namespace jostle::physics
