// SPDX-License-Identifier: MIT
//
// Rejects triangles that a round shape cannot have touched before it landed on the face of another
// triangle. At a tangential distance t from the touch point, the surface of a shape with radius of
// curvature r in that direction is higher than the face by r - sqrt(r^2 - t^2) >= t^2 / (2 r). A
// triangle below this cup is not touched at the landing. It was not touched earlier either: going
// back along the motion, the shape rises from the face by c per metre and shifts along it by s, and
// while c >= s + s^2 distance / (2 r) no point enters the cup. For a wheel on fine triangles this
// rejects all of them except those at the edge on which it stands.
#pragma once

#include "jostle/base/check.h"
#include "physics/src/geometry/support.h"

namespace jostle::physics {

class SweepCup {
public:
    // `touch`: the touch point on the face with unit normal n, which points towards the shape.
    // `middle`: the centre of the shape at any fraction of its motion. `margin`: allowance for
    // rounding, m.
    void put(const Convex& shape, Vec3 middle, Vec3 motion, Vec3 touch, Vec3 n, double margin) {
        holds_ = false;
        const bool round = shape.core == Core::point || shape.core == Core::segment;
        if (!round && shape.core != Core::cylinder) return;
        const Vec3 axis = shape.axes.y;
        const double radius = round ? shape.radius : shape.size.x;
        ASSERT(radius > 0 && margin >= 0);
        touch_ = touch;
        normal_ = n;
        margin_ = margin;
        half_ = 1e300;
        double upright = 1;
        if (round) {
            if (shape.core == Core::segment && !leaves(axis * (2 * shape.size.y), n, radius))
                return;
            side_ = normalized(absolute(n.x) < 0.6 ? Vec3{0, n.z, -n.y} : Vec3{-n.z, 0, n.x});
            other_ = cross(n, side_);
            other_bend_ = 1 / (2 * radius);
        } else {
            const double along = dot(axis, n);
            upright = square_root(maximum(1 - along * along, 0));
            if (upright < 0.5) return;
            side_ = cross(axis, n) * (1 / upright);
            other_ = axis;
            other_bend_ = 0;
            half_ = shape.size.y + absolute(dot(motion, axis)) + margin;
            middle_ = dot(middle - touch, axis);
        }
        bend_ = upright / (2 * radius);
        holds_ = dot(motion, n) < 0 && leaves(motion, n, radius);
    }

    bool hides(const Vec3 corner[3]) const {
        if (!holds_) return false;
        const Vec3 a = corner[0] - touch_, b = corner[1] - touch_, c = corner[2] - touch_;
        const double across = apart(other_, middle_, a, b, c);
        if (across > half_) return true;
        const double high = largest(dot(normal_, a), dot(normal_, b), dot(normal_, c)) + margin_;
        const double aside = apart(side_, 0, a, b, c);
        return high < bend_ * aside * aside + other_bend_ * across * across;
    }

private:
    // Returns whether a shape that moves back by `distance`, or by any part of it, is higher
    // everywhere.
    static bool leaves(Vec3 distance, Vec3 n, double radius) {
        const double up = absolute(dot(distance, n)),
                     shift = length(distance - n * dot(distance, n));
        return up * 2 * radius >= shift * (2 * radius + shift);
    }
    static double largest(double a, double b, double c) { return maximum(a, maximum(b, c)); }
    // The distance of all three points from `from` along a direction; 0 if `from` is between them.
    static double apart(Vec3 direction, double from, Vec3 a, Vec3 b, Vec3 c) {
        const double x = dot(direction, a) - from, y = dot(direction, b) - from,
                     z = dot(direction, c) - from;
        return maximum(-largest(-x, -y, -z), maximum(-largest(x, y, z), 0));
    }

    bool holds_ = false;
    Vec3 touch_, normal_;
    Vec3 side_, other_;                 // unit, along the face; for a cylinder, other_ is its axis
    double bend_ = 0, other_bend_ = 0;  // 1/m
    double middle_ = 0, half_ = 0;      // m, along the axis of a cylinder
    double margin_ = 0;
};

}  // namespace jostle::physics
