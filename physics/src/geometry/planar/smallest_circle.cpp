// SPDX-License-Identifier: MIT
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/planar.h"
#include "physics/src/geometry/planar/planar_checks.h"

namespace jostle::physics::planar {
namespace {

constexpr double slack = 1e-13;  // of the squared radius: tolerance for rounding

struct Round {
    Vec2 center;
    double radius_squared = 0;

    bool holds(Vec2 p) const { return length_squared(p - center) <= radius_squared * (1 + slack); }
};

Round around(Vec2 a, Vec2 b) {
    const Vec2 half = (b - a) * 0.5;
    return {a + half, length_squared(half)};
}

// The circle through three corners of a hull, which are not collinear.
Round through(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 u = b - a, v = c - a;
    const double uu = length_squared(u), vv = length_squared(v);
    ASSERT(doubled_area(a, b, c) != 0);
    const double scale = 0.5 / doubled_area(a, b, c);
    const Vec2 offset = Vec2{v.y * uu - u.y * vv, u.x * vv - v.x * uu} * scale;
    return {a + offset, length_squared(offset)};
}

// Welzl's expected time requires a random order. SplitMix64 with a fixed seed shuffles the points,
// so that no input order is slow and the result is deterministic.
void shuffle(std::vector<Vec2>& points) {
    std::uint64_t state = 1991;
    for (std::size_t k = points.size(); k > 1; k--) {
        std::uint64_t z = state += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        std::swap(points[k - 1], points[(z ^ (z >> 31)) % k]);
    }
}

// The smallest circle that contains the first `count` points and has q on its boundary.
Round with_one(std::span<const Vec2> points, std::size_t count, Vec2 q) {
    Round circle{q, 0};
    ASSERT(count <= points.size());
    for (std::size_t j = 0; j < count; j++) {
        if (circle.holds(points[j])) continue;
        circle = around(points[j], q);
        for (std::size_t k = 0; k < j; k++)
            if (!circle.holds(points[k])) circle = through(points[k], points[j], q);
    }
    return circle;
}

}  // namespace

Result<Circle> smallest_circle(std::span<const Vec2> points) {
    if (Status s = check_points("points", points, 1, max_planar_points); !s.ok()) return s.error();
    std::vector<Vec2> corners = hull_of_checked(points);
    shuffle(corners);
    Round round{corners[0], 0};
    for (std::size_t k = 1; k < corners.size(); k++)
        if (!round.holds(corners[k])) round = with_one(corners, k, corners[k]);
    Circle circle{round.center, 0};
    for (const Vec2 p : corners) circle.radius = maximum(circle.radius, length(p - circle.center));
    return circle;
}

}  // namespace jostle::physics::planar
