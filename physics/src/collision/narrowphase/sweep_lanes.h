// SPDX-License-Identifier: MIT
//
// Selects which of four boxes a convex shape may touch on the remaining part of its motion. A box
// is selected if the shape's own box intersects it there, and if the direction from the nearest
// point of the box to the shape's centre, at the end of that part, does not separate them. A shape
// that approaches a box along that direction was even further away earlier.
#pragma once

#include "jostle/base/check.h"
#include "physics/src/geometry/box_lanes.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

class SweepLanes {
public:
    // In the frame of the boxes. `middle` and `box`: of the shape at the start of its motion.
    // `gap`: shapes within this distance touch, m.
    SweepLanes(const Convex& shape, Vec3 middle, const Aabb& box, Vec3 motion, double gap)
        : core_(shape.core), middle_(row(middle)), motion_(row(motion)) {
        const double distance = length(motion), reach = 0.5 * length(box.high - box.low);
        const Vec3 off = abs(middle);
        // Ten times the float rounding error.
        const double slack =
            1e-6 * (maximum(off.x, maximum(off.y, off.z)) + 2 * (reach + distance)) + gap;
        const Vec3 s{slack, slack, slack};
        low_ = row(box.low - s);
        high_ = row(box.high + s);
        spread(row(distance > 0 ? motion * (1 / distance) : Vec3{}), ahead_);
        earlier_ = lanes(0.1 * reach);
        set_size(shape, reach, slack);
    }

    // Sets the active part of the motion, in fractions.
    void set_interval(double from, double until) {
        const Float4 at = motion_ * lanes(from), end = motion_ * lanes(until);
        ASSERT(from <= until);
        spread(low_ + smaller4(at, end), overlap_.low);
        spread(high_ + larger4(at, end), overlap_.high);
        spread(middle_ + end, end_);
    }

    // `key` is smaller for boxes nearer to the path of the centre, and for earlier boxes. A single
    // branch is accepted without further tests, because its children are tested.
    unsigned operator()(const BoxLanes& boxes, bool leaf, Float4& key) const {
        const unsigned overlaps = overlapping(overlap_, boxes);
        if (overlaps == 0 || (!leaf && (overlaps & (overlaps - 1)) == 0)) return overlaps;
        Float4 d[3];  // from the box to the centre
        for (int k = 0; k < 3; k++)
            d[k] = end_[k] - larger4(smaller4(end_[k], boxes.high[k]), boxes.low[k]);
        const Float4 along = times(d, ahead_), squared = times(d, d);
        key = squared - along * along - earlier_ * along;
        const Mask4 apart = (squared > extent(d, squared)) & (along <= splat4(0));
        return overlaps & ~lanes_set(apart);
    }

private:
    static constexpr double larger_ = 1.00001;

    static Float4 lanes(double d) { return splat4(static_cast<float>(d)); }
    static Float4 row(Vec3 v) {
        return Float4{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), 0};
    }
    static void spread(Float4 v, Float4 to[3]) {
        for (int k = 0; k < 3; k++) to[k] = splat4(v[k]);
    }
    static Float4 times(const Float4 a[3], const Float4 b[3]) {
        return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
    }
    static Float4 size_along(const Float4 d[3], const Float4 axis[3]) {
        const Float4 along = times(d, axis);
        return larger4(along, -along);
    }
    void set_size(const Convex& shape, double reach, double slack) {
        const bool known = core_ == Core::point || core_ == Core::segment || core_ == Core::box ||
                           core_ == Core::cylinder;
        radius_ = lanes((known ? shape.radius : reach) * larger_ + slack);
        if (!known || core_ == Core::point) return;
        spread(row(shape.size * larger_), size_);
        spread(row(shape.axes.y), y_);
        if (core_ != Core::box) return;
        spread(row(shape.axes.x), x_);
        spread(row(shape.axes.z), z_);
    }
    // Extent of the shape along d, times the length of d.
    Float4 extent(const Float4 d[3], Float4 squared) const {
        const Float4 round = radius_ * root4(squared);
        if (core_ == Core::cylinder) {
            const Float4 along = size_along(d, y_);
            return round + size_[0] * root4(larger4(squared - along * along, splat4(0))) +
                   size_[1] * along;
        }
        if (core_ == Core::segment) return round + size_[1] * size_along(d, y_);
        if (core_ == Core::box)
            return round + ((size_[0] * size_along(d, x_) + size_[1] * size_along(d, y_)) +
                            size_[2] * size_along(d, z_));
        return round;
    }

    Core core_;
    // x, y, z in adjacent lanes.
    Float4 middle_, motion_, low_, high_;
    // The same value in all four lanes.
    BoxLanes overlap_;
    Float4 end_[3], ahead_[3], earlier_, radius_;
    Float4 size_[3], x_[3], y_[3], z_[3];  // only those that the core needs
};

}  // namespace jostle::physics
