// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/triangle.h"

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

// The fraction of an edge at a point between its ends; 0 for an edge of zero length.
double part_of(double from_start, double to_end) {
    const double sum = from_start + to_end;
    return sum > 0 ? from_start / sum : 0;
}

Vec3 nearest_on_edges(const Vec3 corner[3], Vec3 p) {
    Vec3 best = corner[0];
    for (int k = 0; k < 3; k++) {
        const Vec3 from = corner[k], along = corner[(k + 1) % 3] - from;
        const double l2 = length_squared(along);
        const double part = l2 > 0 ? clamp(dot(p - from, along) / l2, 0, 1) : 0;
        const Vec3 at = from + along * part;
        if (length_squared(p - at) < length_squared(p - best)) best = at;
    }
    return best;
}

}  // namespace

Vec3 nearest_on_triangle(const Vec3 corner[3], Vec3 p) {
    const Vec3 a = corner[0], b = corner[1], c = corner[2];
    const Vec3 ab = b - a, ac = c - a;
    // In a sliver, rounding decides the Voronoi region of p. An edge is equally close.
    const double longest2 = maximum(length_squared(ab), length_squared(ac));
    if (length_squared(cross(ab, ac)) <= 1e-14 * longest2 * longest2)
        return nearest_on_edges(corner, p);
    const double ab_a = dot(ab, p - a), ac_a = dot(ac, p - a);
    if (ab_a <= 0 && ac_a <= 0) return a;
    const double ab_b = dot(ab, p - b), ac_b = dot(ac, p - b);
    if (ab_b >= 0 && ac_b <= ab_b) return b;
    const double of_c = ab_a * ac_b - ab_b * ac_a;
    if (of_c <= 0 && ab_a >= 0 && ab_b <= 0) return a + ab * part_of(ab_a, -ab_b);
    const double ab_c = dot(ab, p - c), ac_c = dot(ac, p - c);
    if (ac_c >= 0 && ab_c <= ac_c) return c;
    const double of_b = ab_c * ac_a - ab_a * ac_c;
    if (of_b <= 0 && ac_a >= 0 && ac_c <= 0) return a + ac * part_of(ac_a, -ac_c);
    const double of_a = ab_b * ac_c - ab_c * ac_b;
    if (of_a <= 0 && ac_b >= ab_b && ab_c >= ac_c)
        return b + (c - b) * part_of(ac_b - ab_b, ab_c - ac_c);
    const double sum = of_a + of_b + of_c;
    ASSERT(!(sum <= 0));
    return a + ab * (of_b / sum) + ac * (of_c / sum);
}

}  // namespace jostle::physics
