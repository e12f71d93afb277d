// SPDX-License-Identifier: MIT
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/planar.h"
#include "physics/src/geometry/planar/planar_checks.h"

namespace jostle::physics::planar {
namespace {

Vec2 across(Vec2 axis) {
    return {-axis.y, axis.x};
}

struct Extent {
    double low = 1e300, high = -1e300;

    void add(double x) {
        low = minimum(low, x);
        high = maximum(high, x);
    }
    double half() const { return (high - low) * 0.5; }
    double middle() const { return (high + low) * 0.5; }
};

// The box along a unit axis. Computed relative to the first point, so that points far from the
// origin lose no precision.
OrientedBox box_along(Vec2 axis, std::span<const Vec2> points) {
    const Vec2 origin = points[0];
    Extent along, perpendicular;
    ASSERT(absolute(length_squared(axis) - 1) < 1e-6);
    for (const Vec2 p : points) {
        along.add(dot(p - origin, axis));
        perpendicular.add(dot(p - origin, across(axis)));
    }
    return {origin + axis * along.middle() + across(axis) * perpendicular.middle(), axis,
            along.half(), perpendicular.half()};
}

// Selects one of two opposite axes.
Vec2 forward(Vec2 axis) {
    return axis.x < 0 || (axis.x == 0 && axis.y < 0) ? -axis : axis;
}

OrientedBox longest_first(OrientedBox box) {
    if (box.half_length < box.half_width) {
        box.axis = across(box.axis);
        std::swap(box.half_length, box.half_width);
    }
    box.axis = forward(box.axis);
    return box;
}

// Returns the first corner, starting at `k`, after which the hull recedes along `direction`.
std::size_t walk(std::span<const Vec2> hull, std::size_t k, Vec2 direction) {
    ASSERT(k < hull.size());
    for (std::size_t steps = 0; steps < hull.size(); steps++) {
        const std::size_t next = k + 1 == hull.size() ? 0 : k + 1;
        if (!(dot(hull[next] - hull[k], direction) > 0)) break;
        k = next;
    }
    return k;
}

}  // namespace

Result<OrientedBox> pca_box(std::span<const Vec2> points) {
    if (Status s = check_points("points", points, 1, max_planar_points); !s.ok()) return s.error();
    const Vec2 origin = points[0];
    Vec2 mean;
    for (const Vec2 p : points) mean = mean + (p - origin);
    mean = origin + mean * (1 / static_cast<double>(points.size()));
    double xx = 0, xy = 0, yy = 0;
    for (const Vec2 p : points) {
        const Vec2 d = p - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    // The eigenvector of the larger eigenvalue, (xx + yy) / 2 + root: of the two columns of the
    // matrix minus the other eigenvalue, the one without cancellation.
    const double half = (xx - yy) * 0.5, root = square_root(half * half + xy * xy);
    const Vec2 v = half >= 0 ? Vec2{half + root, xy} : Vec2{xy, root - half};
    const double size = length(v);
    const bool principal = root > 1e-12 * (xx + yy) && size > 0;
    return longest_first(box_along(principal ? forward(v * (1 / size)) : Vec2{1, 0}, points));
}

Result<OrientedBox> smallest_box(std::span<const Vec2> points) {
    if (Status s = check_points("points", points, 1, max_planar_points); !s.ok()) return s.error();
    const std::vector<Vec2> hull = hull_of_checked(points);
    if (hull.size() == 1) return OrientedBox{hull[0], {1, 0}, 0, 0};
    std::size_t right = 0, top = 0, left = 0;
    double smallest = 1e300;
    Vec2 best{1, 0};
    for (std::size_t k = 0; k < hull.size(); k++) {
        const Vec2 side = hull[k + 1 == hull.size() ? 0 : k + 1] - hull[k];
        const Vec2 axis = side * (1 / length(side));
        // Each caliper continues from its last position, so it goes around the hull once in total.
        if (k == 0) right = 1;
        right = walk(hull, right, axis);
        top = walk(hull, k == 0 ? right : top, across(axis));
        left = walk(hull, k == 0 ? top : left, -axis);
        const double area =
            dot(hull[right] - hull[left], axis) * dot(hull[top] - hull[k], across(axis));
        if (area < smallest) {
            smallest = area;
            best = axis;
        }
    }
    return longest_first(box_along(best, hull));
}

}  // namespace jostle::physics::planar
