// SPDX-License-Identifier: MIT
#include "jostle/base/check.h"
#include "jostle/physics/planar.h"
#include "physics/src/geometry/planar/planar_checks.h"

namespace jostle::physics::planar {
namespace {

// Angular order of directions, starting to the right of straight down. The sides of a hull that
// starts at its leftmost corner (of several, the lowest) are in this order.
bool points_right(Vec2 side) {
    return side.x > 0 || (side.x == 0 && side.y > 0);
}

// Returns -1 if u precedes v in this order, 0 if the directions are equal.
int compare(Vec2 u, Vec2 v) {
    if (points_right(u) != points_right(v)) return points_right(u) ? -1 : 1;
    return -orientation({}, u, v);
}

Vec2 side_direction(std::span<const Vec2> hull, std::size_t k) {
    return hull[(k + 1) % hull.size()] - hull[k];
}

// Both hulls start at their leftmost corner, and so does the sum, whose sides are the sides of both
// hulls sorted by direction. Each corner is the sum of two corners, so rounding errors do not
// accumulate.
std::vector<Vec2> sum_of_hulls(std::span<const Vec2> a, std::span<const Vec2> b) {
    const std::size_t sides_a = a.size() == 1 ? 0 : a.size(),
                      sides_b = b.size() == 1 ? 0 : b.size();
    std::vector<Vec2> corners;
    ASSERT(!a.empty() && !b.empty());
    std::size_t i = 0, j = 0;
    while (i < sides_a || j < sides_b) {
        corners.push_back(a[i % a.size()] + b[j % b.size()]);
        const int order = i == sides_a   ? 1
                          : j == sides_b ? -1
                                         : compare(side_direction(a, i), side_direction(b, j));
        if (order <= 0) i++;
        if (order >= 0) j++;
    }
    if (corners.empty()) corners.push_back(a[0] + b[0]);
    // Rounding may have made corners collinear or equal.
    return hull_of_checked(corners);
}

Result<std::vector<Vec2>> combined(std::span<const Vec2> a, std::span<const Vec2> b, double sign) {
    if (Status s = check_points("a", a, 1, max_planar_points); !s.ok()) return s.error();
    if (Status s = check_points("b", b, 1, max_planar_points); !s.ok()) return s.error();
    std::vector<Vec2> other(b.begin(), b.end());
    for (Vec2& p : other) p = p * sign;
    return sum_of_hulls(hull_of_checked(a), hull_of_checked(other));
}

Vec2 nearest_to_origin(Vec2 from, Vec2 to) {
    const Vec2 side = to - from;
    const double l2 = length_squared(side);
    return l2 > 0 ? from + side * clamp(-dot(from, side) / l2, 0, 1) : from;
}

// The smallest translation of b after which it only touches a.
Separation depth_in(std::span<const Vec2> hull) {
    Separation least{-1e300, {1, 0}};
    ASSERT(hull.size() >= 3);
    for (std::size_t k = 0; k < hull.size(); k++) {
        const Vec2 side = side_direction(hull, k);
        const Vec2 out = Vec2{side.y, -side.x} * (1 / length(side));
        const double depth = maximum(dot(hull[k], out), 0);
        if (-depth > least.distance) least = {-depth, out};
    }
    return least;
}

}  // namespace

Result<std::vector<Vec2>> minkowski_sum(std::span<const Vec2> a, std::span<const Vec2> b) {
    return combined(a, b, 1);
}

Result<std::vector<Vec2>> minkowski_difference(std::span<const Vec2> a, std::span<const Vec2> b) {
    return combined(a, b, -1);
}

Result<Separation> separation(std::span<const Vec2> a, std::span<const Vec2> b) {
    const auto difference = minkowski_difference(a, b);
    if (!difference.ok()) return difference.error();
    const std::vector<Vec2>& hull = *difference;
    bool inside = hull.size() > 2;
    for (std::size_t k = 0; k < hull.size() && inside; k++)
        inside = orientation(hull[k], hull[(k + 1) % hull.size()], {}) >= 0;
    if (inside) return depth_in(hull);
    // The nearest point of the difference is a - b; the direction from a to b is opposite to it.
    Separation out{1e300, {1, 0}};
    for (std::size_t k = 0; k < hull.size(); k++) {
        const Vec2 p = nearest_to_origin(hull[k], hull[(k + 1) % hull.size()]);
        const double distance = length(p);
        if (distance < out.distance)
            out = {distance, distance > 0 ? p * (-1 / distance) : Vec2{1, 0}};
    }
    return out;
}

}  // namespace jostle::physics::planar
