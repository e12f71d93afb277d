// SPDX-License-Identifier: MIT
//
// Axis-aligned bounding boxes.
#pragma once

#include "jostle/physics/vec3.h"

namespace jostle::physics {

/// An axis-aligned box, given by its minimum and maximum corner, in metres. Valid if low <= high in
/// each component.
struct Aabb {
    Vec3 low = {}, high = {};  ///< minimum and maximum corner

    bool operator==(const Aabb&) const = default;
};

/// Returns true if the boxes overlap. Boxes that touch overlap.
inline bool overlap(const Aabb& a, const Aabb& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}
/// Returns true if `inner` lies inside `outer`. Common faces are allowed.
inline bool contains(const Aabb& outer, const Aabb& inner) {
    return outer.low.x <= inner.low.x && inner.high.x <= outer.high.x &&
           outer.low.y <= inner.low.y && inner.high.y <= outer.high.y &&
           outer.low.z <= inner.low.z && inner.high.z <= outer.high.z;
}
/// Returns the smallest box that contains both boxes.
inline Aabb unite(const Aabb& a, const Aabb& b) {
    return {min(a.low, b.low), max(a.high, b.high)};
}
/// Returns the box enlarged by `margin` metres on every side.
inline Aabb grow(const Aabb& a, double margin) {
    const Vec3 m{margin, margin, margin};
    return {a.low - m, a.high + m};
}
/// Returns half the surface area, in m^2: the cost metric of the dynamic tree (surface area
/// heuristic).
inline double half_area(const Aabb& a) {
    const Vec3 d = a.high - a.low;
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

/// Intersects the segment origin..origin + motion with a box and returns the fraction of the motion
/// at which the segment enters it. Returns 0 if the segment starts inside the box, and 2 if it does
/// not enter the box within [0, limit].
///
/// Slab test (Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986). Zero components of the
/// motion are handled without a division.
inline double ray_enters(const Aabb& box, Vec3 origin, Vec3 motion, double limit) {
    double enter = 0, leave = limit;
    for (int k = 0; k < 3; k++) {
        const double o = origin[k], d = motion[k];
        if (d == 0) {
            if (o < box.low[k] || box.high[k] < o) return 2;
            continue;
        }
        const double s = 1 / d, t1 = (box.low[k] - o) * s, t2 = (box.high[k] - o) * s;
        enter = maximum(enter, minimum(t1, t2));
        leave = minimum(leave, maximum(t1, t2));
    }
    return enter <= leave ? enter : 2;
}

}  // namespace jostle::physics
