// SPDX-License-Identifier: MIT
//
// The region that a moving shape may approach, in the frame of a surface.
#pragma once

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/surface_motion.h"
#include "physics/src/collision/narrowphase/triangle_lanes.h"
#include "physics/src/geometry/hull_lanes.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// The motion of a shape in the surface's frame, with the shape's position as the origin. Bounds the
// region that the shape may approach.
class ShapeMotion {
public:
    ShapeMotion(const SurfaceMotion& motion, const TransformedShape& surface,
                const TransformedShape& convex, const Convex& shape)
        : limit_{{transposed_times(surface.axes, motion.to_start),
                  transposed_times(surface.axes, motion.to_end)},
                 transposed_times(surface.axes, motion.turn),
                 transposed_times(surface.axes, motion.center - convex.position),
                 motion.near,
                 0} {
        limit_.furthest = shape.core == Core::hull ? length(middle_of(shape) - limit_.center) +
                                                         shape.hull->lanes->outer_radius
                                                   : length(limit_.center) + size_of(shape);
        ASSERT(!(limit_.furthest < 0) && !(limit_.near < 0));
    }

    // The region that the shape may reach, given its current box.
    Aabb reach(const Aabb& now) const {
        const Aabb ball{limit_.center - Vec3{limit_.furthest, limit_.furthest, limit_.furthest},
                        limit_.center + Vec3{limit_.furthest, limit_.furthest, limit_.furthest}};
        const Aabb turned = grow(now, length(limit_.turn) * limit_.furthest);
        const Vec3 low = max(turned.low, ball.low), high = min(turned.high, ball.high);
        const Vec3 back = min(Vec3{}, min(limit_.ends[0], limit_.ends[1])),
                   on = max(Vec3{}, max(limit_.ends[0], limit_.ends[1]));
        return grow({low + back, high + on}, limit_.near);
    }
    // Returns whether the shape stays out of reach of a feature that is `distance` away against the
    // unit vector n.
    bool exceeds_reach(double distance, Vec3 n, const Convex& shape) const {
        const double left = distance +
                            minimum(0, minimum(dot(limit_.ends[0], n), dot(limit_.ends[1], n))) -
                            limit_.near;
        if (left <= 0) return false;
        // Rotation brings no point nearer than the points that are furthest from the centre.
        const double extent = dot(support(shape, -n) - limit_.center, -n) + shape.radius;
        return left >
               minimum(length(cross(limit_.turn, n)) * limit_.furthest, limit_.furthest - extent);
    }

    const MotionLimit& limit() const { return limit_; }

private:
    MotionLimit limit_;
};

}  // namespace jostle::physics
