// SPDX-License-Identifier: MIT
//
// Four triangles in SIMD layout, in single precision, to reject those that a convex shape does not
// reach. Every test allows for rounding, and the remaining triangles are tested in double
// precision, so results do not depend on single precision.
#pragma once

#include "jostle/physics/hull.h"
#include "physics/src/geometry/box_lanes.h"
#include "physics/src/geometry/support.h"
#include "physics/src/geometry/surface.h"

namespace jostle::physics {

// The motion of a shape around a pose, relative to the triangles: it moves to either end, and turns
// by at most `turn` about `center`.
struct MotionLimit {
    Vec3 ends[2];     // m
    Vec3 turn;        // rad
    Vec3 center;      // m
    double near;      // m: triangles within this distance of the motion are reached
    double furthest;  // m: largest distance of the shape's points from the centre
};

class TriangleFilter {
public:
    // `shape`: in the frame of the triangles. `reach`: m, from its core.
    TriangleFilter(const Convex& shape, double reach);

    // Rejects triangles that a moving shape does not reach either, even if they are near.
    void limit(const MotionLimit& motion, const Convex& shape);

    // Adds a triangle, whose corners are relative to the origin of the shape's frame. At most four.
    void put(const SurfaceTriangle& triangle, Vec3 origin);
    bool full() const { return count_ == 4; }
    // Calls visit(triangle) for the triangles that the shape may reach, in their order, and removes
    // all.
    template <class Visit>
    void flush(Visit&& visit) {
        if (count_ == 0) return;
        const unsigned lanes = near();
        const int count = count_;
        count_ = 0;
        for (int k = 0; k < count; k++)
            if ((lanes >> k & 1) != 0) visit(triangle_[k]);
    }

private:
    struct Lanes3 {
        Float4 x, y, z;
    };
    struct Extent {
        Float4 low, high;
    };
    static Float4 dot4(const Lanes3& a, const Lanes3& b) {
        return (a.x * b.x + a.y * b.y) + a.z * b.z;
    }
    static Lanes3 minus(const Lanes3& a, const Lanes3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    static Lanes3 cross4(const Lanes3& a, const Lanes3& b) {
        return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    }

    unsigned near() const;
    Lanes3 local(int corner) const;
    // The range of d . p over the points p of the core.
    Extent extent_along(const Lanes3& d) const;
    // Whether the core is out of reach along d, where the two are separated by `apart`. All lengths
    // are multiples of that of d.
    Mask4 beyond_motion(const Lanes3& d, Float4 length, Float4 apart, Float4 low,
                        Float4 rounding) const;
    Mask4 beyond_box(const Lanes3 corner[3], Float4 reach) const;
    Lanes3 to_middle(const Lanes3 corner[3], const Lanes3& normal) const;

    Core core_;
    Float4 axes_[3][3];  // of the shape: axis, coordinate
    Float4 low_[3], high_[3], middle_[3], size_[3];
    Float4 reach_,
        radius_;  // m; radius_: of a ball around the origin that contains the core
    bool moves_ = false;
    Lanes3 ends_[2], turn_, center_;  // of the motion, in the shape's own frame
    Float4 near_, furthest_;
    int vertex_count_ = 0;
    float vertices_[3 * max_hull_vertices];  // the first vertex_count_ are valid
    SurfaceTriangle triangle_[4];
    alignas(16) float corner_[3][3][4] = {};  // corner, coordinate, lane
    int count_ = 0;
};

}  // namespace jostle::physics
