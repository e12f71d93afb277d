// SPDX-License-Identifier: MIT
//
// Reduction of many contact points to the best four, in a fixed order.
#pragma once

namespace jostle::physics {

// A point in the frame of a reference face: along its two tangents, and above it.
struct FacePoint {
    double u = 0, v = 0;  // m
    double gap = 0;       // m
    int index = 0;        // index assigned by the caller
};

// Selects at most four of `points`: the deepest, the furthest from it, and the furthest on either
// side of the line through those two. Deep points have priority over points that may touch before
// the next narrow-phase test, and those over all others, because a tilting face rests on those
// alone. Moves the selected points to the front and returns their number. `size`: size of the
// smaller shape, m.
int reduce_to_four(FacePoint* points, int count, double size);

}  // namespace jostle::physics
