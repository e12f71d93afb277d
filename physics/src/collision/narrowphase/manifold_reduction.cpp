// SPDX-License-Identifier: MIT
//
// The small constants break ties: among points that are equally good up to rounding the first wins,
// so that a resting manifold keeps its points from step to step.
#include "physics/src/collision/narrowphase/manifold_reduction.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/scalar.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

namespace {

// Same as reduce_to_four() without the preference by depth. Accepts any number of points.
int best_four(FacePoint* points, int count, double scale) {
    if (count <= 4) return count;
    int deepest = 0;
    for (int k = 1; k < count; k++)
        if (points[k].gap < points[deepest].gap - 1e-5 * scale) deepest = k;
    const FacePoint p0 = points[deepest];

    int furthest = 0;
    double most = -1;
    for (int k = 0; k < count; k++) {
        const double u = points[k].u - p0.u, v = points[k].v - p0.v, d2 = u * u + v * v;
        if (d2 > most + 1e-6 * scale * scale) {
            most = d2;
            furthest = k;
        }
    }
    const FacePoint p1 = points[furthest];

    int left = -1, right = -1;
    double max_left = 1e-9 * scale * scale, max_right = -max_left;
    for (int k = 0; k < count; k++) {
        const double area =
            (p1.u - p0.u) * (points[k].v - p0.v) - (p1.v - p0.v) * (points[k].u - p0.u);
        if (area > max_left) {
            max_left = area;
            left = k;
        }
        if (area < max_right) {
            max_right = area;
            right = k;
        }
    }
    FacePoint retained[4];
    ASSERT(left < count && right < count);
    int made = 0;
    retained[made++] = p0;
    retained[made++] = p1;
    if (left >= 0) retained[made++] = points[left];
    if (right >= 0) retained[made++] = points[right];
    std::copy(retained, retained + made, points);
    ASSERT(made >= 2 && made <= 4);
    return made;
}

}  // namespace

int reduce_to_four(FacePoint* points, int count, double size) {
    if (count <= 4) return count;
    // Moves the points from index `from` on with a smaller gap to the front, in their order, and
    // returns the end of that range.
    const auto nearer = [&](int from, double gap) {
        int end = from;
        for (int k = from; k < count; k++)
            if (points[k].gap < gap) std::rotate(points + end++, points + k, points + k + 1);
        return end;
    };
    // Deep points carry most of the load. Points that touch, or may touch before the manifold is
    // rebuilt, form the face on which the body rocks; a wider face is better. The other points come
    // last.
    const double scale = minimum(1, size / tuning::min_usual_size);
    const int deep = nearer(0, -tuning::bearing_overlap * scale),
              close = nearer(deep, tuning::reuse_distance * scale);
    if (deep >= 4) return best_four(points, deep, scale);
    if (deep == 0 && close >= 4) return best_four(points, close, scale);
    if (close == 0) return best_four(points, count, scale);
    // All points of the nearest class, then the points furthest from them.
    int made = deep > 0 ? deep : close;
    ASSERT(made > 0 && made <= 4 && deep <= close && close <= count);
    while (made < 4) {
        const int end = made < close ? close : count;
        int best = made;
        double most = -1;
        for (int k = made; k < end; k++) {
            double nearest = 1e300;
            for (int j = 0; j < made; j++) {
                const double u = points[k].u - points[j].u, v = points[k].v - points[j].v;
                nearest = minimum(nearest, u * u + v * v);
            }
            if (nearest > most + 1e-6 * scale * scale) {
                most = nearest;
                best = k;
            }
        }
        std::swap(points[made++], points[best]);
    }
    return made;
}

}  // namespace jostle::physics
