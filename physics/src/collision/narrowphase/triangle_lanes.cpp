// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/triangle_lanes.h"

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

Float4 absolute4(Float4 a) {
    return larger4(a, -a);
}
Float4 load4(const float* p) {
    return *static_cast<const Float4*>(static_cast<const void*>(p));
}
void fill(Float4 to[3], Vec3 v) {
    for (int k = 0; k < 3; k++) to[k] = splat4(static_cast<float>(v[k]));
}

}  // namespace

TriangleFilter::TriangleFilter(const Convex& shape, double reach)
    : core_(shape.core), reach_(splat4(float_above(reach))) {
    fill(axes_[0], shape.axes.x);
    fill(axes_[1], shape.axes.y);
    fill(axes_[2], shape.axes.z);
    fill(size_, shape.size);
    fill(middle_, transposed_times(shape.axes, middle_of(shape) - shape.position));
    Vec3 low = -shape.size, high = shape.size;
    if (core_ == Core::cylinder || core_ == Core::cone) {
        high = {shape.size.x, shape.size.y, shape.size.x};
        low = -high;
    }
    if (core_ == Core::hull) {
        low = shape.hull->bounds.low;
        high = shape.hull->bounds.high;
        vertex_count_ = static_cast<int>(shape.hull->vertices.size());
        ASSERT(vertex_count_ <= static_cast<int>(max_hull_vertices));
        for (int k = 0; k < vertex_count_; k++)
            for (int c = 0; c < 3; c++)
                vertices_[3 * k + c] =
                    static_cast<float>(shape.hull->vertices[static_cast<std::size_t>(k)][c]);
    }
    fill(low_, low);
    fill(high_, high);
    radius_ = splat4(float_above(length(max(abs(low), abs(high)))));
}

void TriangleFilter::limit(const MotionLimit& motion, const Convex& shape) {
    const auto local = [&](Vec3 v) {
        Float4 to[3];
        fill(to, transposed_times(shape.axes, v));
        return Lanes3{to[0], to[1], to[2]};
    };
    moves_ = true;
    ends_[0] = local(motion.ends[0]);
    ends_[1] = local(motion.ends[1]);
    turn_ = local(motion.turn);
    center_ = local(motion.center - shape.position);
    near_ = splat4(float_above(motion.near + shape.radius));
    furthest_ = splat4(float_above(motion.furthest));
    // Rounding errors are relative to all lengths.
    radius_ += splat4(float_above(length(motion.ends[0]) + length(motion.ends[1]) +
                                  length(motion.center) + motion.furthest));
}

void TriangleFilter::put(const SurfaceTriangle& triangle, Vec3 origin) {
    ASSERT(count_ < 4);
    triangle_[count_] = triangle;
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            corner_[k][c][count_] = static_cast<float>(triangle.corner[k][c] - origin[c]);
    count_++;
}

// The corners in the shape's own frame.
TriangleFilter::Lanes3 TriangleFilter::local(int corner) const {
    const Lanes3 p{load4(corner_[corner][0]), load4(corner_[corner][1]), load4(corner_[corner][2])};
    const auto along = [&](const Float4 axis[3]) {
        return (axis[0] * p.x + axis[1] * p.y) + axis[2] * p.z;
    };
    return {along(axes_[0]), along(axes_[1]), along(axes_[2])};
}

TriangleFilter::Extent TriangleFilter::extent_along(const Lanes3& d) const {
    switch (core_) {
        case Core::point:
        case Core::triangle:
            break;
        case Core::segment: {
            const Float4 reach = absolute4(d.y) * size_[1];
            return {-reach, reach};
        }
        case Core::box: {
            const Float4 reach =
                (absolute4(d.x) * size_[0] + absolute4(d.y) * size_[1]) + absolute4(d.z) * size_[2];
            return {-reach, reach};
        }
        case Core::cylinder: {
            const Float4 reach =
                absolute4(d.y) * size_[1] + root4(d.x * d.x + d.z * d.z) * size_[0];
            return {-reach, reach};
        }
        case Core::cone: {
            const Float4 tip = d.y * size_[1], rim = root4(d.x * d.x + d.z * d.z) * size_[0];
            return {-larger4(-tip, tip + rim), larger4(tip, rim - tip)};
        }
        case Core::hull: {
            Extent extent{splat4(1e30f), splat4(-1e30f)};
            for (int k = 0; k < vertex_count_; k++) {
                const float* v = vertices_ + 3 * k;
                const Float4 at = (d.x * splat4(v[0]) + d.y * splat4(v[1])) + d.z * splat4(v[2]);
                extent.low = smaller4(extent.low, at);
                extent.high = larger4(extent.high, at);
            }
            return extent;
        }
    }
    return {splat4(0), splat4(0)};
}

Mask4 TriangleFilter::beyond_box(const Lanes3 corner[3], Float4 reach) const {
    const auto beyond = [&](Float4 a, Float4 b, Float4 c, int axis) {
        return (smaller4(a, smaller4(b, c)) - high_[axis] > reach) |
               (low_[axis] - larger4(a, larger4(b, c)) > reach);
    };
    return beyond(corner[0].x, corner[1].x, corner[2].x, 0) |
           beyond(corner[0].y, corner[1].y, corner[2].y, 1) |
           beyond(corner[0].z, corner[1].z, corner[2].z, 2);
}

// The direction from the point of a triangle that is nearest to the shape's centre to the centre,
// of any length.
TriangleFilter::Lanes3 TriangleFilter::to_middle(const Lanes3 corner[3],
                                                 const Lanes3& normal) const {
    const Lanes3 middle{middle_[0], middle_[1], middle_[2]};
    const Lanes3 height = minus(middle, corner[0]);
    const Float4 up = dot4(height, normal);
    Lanes3 best = height;
    Float4 least = splat4(3e38f);
    Mask4 inside = up == up;
    for (int k = 0; k < 3; k++) {
        const Lanes3 along = minus(corner[(k + 1) % 3], corner[k]), off = minus(middle, corner[k]);
        const Float4 part =
            smaller4(larger4(dot4(off, along) / dot4(along, along), splat4(0)), splat4(1));
        const Lanes3 to{off.x - along.x * part, off.y - along.y * part, off.z - along.z * part};
        const Float4 square = dot4(to, to);
        const Mask4 nearer = square < least;
        least = nearer ? square : least;
        best = {nearer ? to.x : best.x, nearer ? to.y : best.y, nearer ? to.z : best.z};
        inside &= dot4(cross4(along, off), normal) >= splat4(0);
    }
    const Float4 side = up < splat4(0) ? splat4(-1) : splat4(1);
    return {inside ? normal.x * side : best.x, inside ? normal.y * side : best.y,
            inside ? normal.z * side : best.z};
}

Mask4 TriangleFilter::beyond_motion(const Lanes3& d, Float4 length, Float4 apart, Float4 low,
                                    Float4 rounding) const {
    const Float4 approach = smaller4(splat4(0), smaller4(dot4(ends_[0], d), dot4(ends_[1], d)));
    const Float4 left = apart + approach - (near_ + rounding) * length;
    // The rotation brings no point nearer than the points that are furthest from the centre.
    const Lanes3 across = cross4(turn_, d);
    const Float4 by_turn = root4(dot4(across, across)) * furthest_;
    const Float4 by_extent = furthest_ * length - (dot4(center_, d) - low);
    return left > larger4(splat4(0), smaller4(by_turn, by_extent));
}

// Each direction d separates a triangle by the least d . p of the shape less the largest of the
// corners, divided by the length of d. This bound holds for any d, however it was rounded.
unsigned TriangleFilter::near() const {
    const Lanes3 corner[3] = {local(0), local(1), local(2)};
    Float4 furthest = radius_;
    for (const Lanes3& c : corner)
        furthest = larger4(furthest, (absolute4(c.x) + absolute4(c.y)) + absolute4(c.z));
    const Float4 rounding = furthest * splat4(4e-6f), reach = reach_ + rounding;
    Mask4 far = beyond_box(corner, reach);
    const auto separates = [&](const Lanes3& d, bool both_sides) {
        const Extent extent = extent_along(d);
        const Float4 a = dot4(corner[0], d), b = dot4(corner[1], d), c = dot4(corner[2], d);
        const Float4 length = root4(dot4(d, d)), least = reach * length;
        const Float4 above = extent.low - larger4(a, larger4(b, c));
        Mask4 apart = above > least;
        if (moves_) apart |= beyond_motion(d, length, above, extent.low, rounding);
        if (!both_sides) return apart;
        const Float4 below = smaller4(a, smaller4(b, c)) - extent.high;
        apart |= below > least;
        if (moves_)
            apart |= beyond_motion({-d.x, -d.y, -d.z}, length, below, -extent.high, rounding);
        return apart;
    };
    const Lanes3 normal = cross4(minus(corner[1], corner[0]), minus(corner[2], corner[0]));
    far |= separates(normal, true);
    if (lanes_set(far) == 15) return 0;
    far |= separates(to_middle(corner, normal), false);
    return ~lanes_set(far) & 15;
}

}  // namespace jostle::physics
