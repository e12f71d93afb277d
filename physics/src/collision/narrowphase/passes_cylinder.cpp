// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/triangle.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/uninitialized_array.h"

namespace jostle::physics {
namespace {

// Coordinates across the axis (x, z) and along it (y).
struct AxisPoint {
    double x, z, y;
};

// A convex polygon with few corners.
struct AxisPolygon {
    UninitializedArray<AxisPoint, 5> point;
    int count = 0;
};

// Clips the polygon to sign * y <= most.
AxisPolygon cut(const AxisPolygon& polygon, double sign, double most) {
    AxisPolygon left;
    ASSERT(polygon.count >= 0 && polygon.count <= 4);
    for (int k = 0; k < polygon.count; k++) {
        const AxisPoint &a = polygon.point[k],
                        &b = polygon.point[k + 1 < polygon.count ? k + 1 : 0];
        const double over_a = sign * a.y - most, over_b = sign * b.y - most;
        if (over_a <= 0) left.point[left.count++] = a;
        if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) {
            const double s = over_a / (over_a - over_b);
            left.point[left.count++] = {a.x + (b.x - a.x) * s, a.z + (b.z - a.z) * s,
                                        a.y + (b.y - a.y) * s};
        }
    }
    return left;
}

// The point of an edge that is nearest to the axis.
AxisPoint nearest_of_edge(const AxisPoint& a, const AxisPoint& b) {
    const double x = b.x - a.x, z = b.z - a.z, length2 = x * x + z * z;
    const double s = length2 > 0 ? clamp(-(a.x * x + a.z * z) / length2, 0, 1) : 0;
    return {a.x + x * s, a.z + z * s, 0};
}

}  // namespace

bool passes_cylinder(const Convex& cylinder, Vec3 middle, Vec3 motion, const Vec3 corner[3],
                     double margin) {
    const Vec3 axis = cylinder.axes.y;
    ASSERT(cylinder.core == Core::cylinder && !(margin < 0));
    if (absolute(dot(motion, axis)) > margin) return false;
    AxisPolygon polygon{.point = {}, .count = 3};
    double low = 1e300, high = -1e300;
    for (int k = 0; k < 3; k++) {
        const Vec3 at = corner[k] - middle;
        const double y = dot(at, axis);
        polygon.point[k] = {dot(at, cylinder.axes.x), dot(at, cylinder.axes.z), y};
        low = minimum(low, y);
        high = maximum(high, y);
    }
    const double half = cylinder.size.y + 2 * margin;
    if (high > half) polygon = cut(polygon, 1, half);
    if (low < -half) polygon = cut(polygon, -1, half);
    if (polygon.count == 0) return true;
    double best = 1e300, left = 1e300, right = -1e300;
    AxisPoint nearest{};
    for (int k = 0; k < polygon.count; k++) {
        const AxisPoint &a = polygon.point[k],
                        &b = polygon.point[k + 1 < polygon.count ? k + 1 : 0];
        const double turn = a.x * b.z - a.z * b.x;
        left = minimum(left, turn);
        right = maximum(right, turn);
        const AxisPoint p = nearest_of_edge(a, b);
        const double d2 = p.x * p.x + p.z * p.z;
        if (d2 < best) {
            best = d2;
            nearest = p;
        }
    }
    // The polygon surrounds the axis: the axis is on the same side of all edges.
    if (left >= 0 || right <= 0) return false;
    const double reach = cylinder.size.x + margin;
    if (best <= reach * reach) return false;
    // The cylinder approaches the polygon, so it was further away earlier.
    return dot(motion, cylinder.axes.x) * nearest.x + dot(motion, cylinder.axes.z) * nearest.z >= 0;
}

}  // namespace jostle::physics
