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

class TriangleFilter {
public:
    // `shape`: in the frame of the triangles. `reach`: m, from its core.
    TriangleFilter(const Convex& shape, double reach);

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
    Mask4 beyond_box(const Lanes3 corner[3], Float4 reach) const;
    Lanes3 to_middle(const Lanes3 corner[3], const Lanes3& normal) const;

    Core core_;
    Float4 axes_[3][3];  // of the shape: axis, coordinate
    Float4 low_[3], high_[3], middle_[3], size_[3];
    Float4 reach_, radius_;  // m; radius_: of a ball around the origin that contains the core
    int vertex_count_ = 0;
    float vertices_[3 * max_hull_vertices];  // the first vertex_count_ are valid
    SurfaceTriangle triangle_[4];
    alignas(16) float corner_[3][3][4] = {};  // corner, coordinate, lane
    int count_ = 0;
};

}  // namespace jostle::physics
