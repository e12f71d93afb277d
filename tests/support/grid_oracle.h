// SPDX-License-Identifier: MIT
//
// Reference results for the plane geometry functions, on points with small integer coordinates, for
// which integer arithmetic is exact. Shares only a vector type with the library.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "jostle/physics/vec2.h"
#include "tests/support/random.h"

namespace jostle::test {

struct GridPoint2 {
    std::int64_t x = 0, y = 0;

    auto operator<=>(const GridPoint2&) const = default;
    physics::Vec2 real() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

inline GridPoint2 operator-(GridPoint2 a, GridPoint2 b) {
    return {a.x - b.x, a.y - b.y};
}
inline GridPoint2 operator+(GridPoint2 a, GridPoint2 b) {
    return {a.x + b.x, a.y + b.y};
}
inline std::int64_t cross(GridPoint2 a, GridPoint2 b) {
    return a.x * b.y - a.y * b.x;
}
inline std::int64_t dot(GridPoint2 a, GridPoint2 b) {
    return a.x * b.x + a.y * b.y;
}
inline GridPoint2 grid(physics::Vec2 p) {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
}
inline std::vector<physics::Vec2> real(std::span<const GridPoint2> points) {
    std::vector<physics::Vec2> out;
    for (const GridPoint2 p : points) out.push_back(p.real());
    return out;
}
inline GridPoint2 random_point(Random& random, std::uint64_t side) {
    const auto x = static_cast<std::int64_t>(random.below(side));
    return {x, static_cast<std::int64_t>(random.below(side))};
}

// Uses the projection of p on the line: it equals p and lies between the ends.
inline bool lies_on(GridPoint2 from, GridPoint2 to, GridPoint2 p) {
    const GridPoint2 segment = to - from, offset = p - from;
    const std::int64_t along = dot(segment, offset), l2 = dot(segment, segment);
    if (l2 == 0) return p == from;
    return along >= 0 && along <= l2 && along * along == l2 * dot(offset, offset);
}

// Number of common points of two segments: 0, 1, or 2 for two or more. `inner`: the only common
// point lies inside both.
struct Shared {
    int count = 0;
    bool inner = false;
};
inline Shared shared(GridPoint2 a, GridPoint2 b, GridPoint2 c, GridPoint2 d) {
    std::set<GridPoint2> ends;
    for (const GridPoint2 p : {a, b})
        if (lies_on(c, d, p)) ends.insert(p);
    for (const GridPoint2 p : {c, d})
        if (lies_on(a, b, p)) ends.insert(p);
    if (!ends.empty()) return {static_cast<int>(std::min<std::size_t>(ends.size(), 2)), false};
    // Cramer's rule: a + t (b - a) = c + s (d - c).
    std::int64_t det = cross(b - a, d - c);
    if (det == 0) return {};
    std::int64_t t = cross(c - a, d - c), s = cross(c - a, b - a);
    if (det < 0) det = -det, t = -t, s = -s;
    const bool inner = 0 < t && t < det && 0 < s && s < det;
    return {inner ? 1 : 0, inner};
}

inline bool is_simple(std::span<const GridPoint2> polygon) {
    const std::size_t n = polygon.size();
    const auto at = [&](std::size_t k) { return polygon[k % n]; };
    for (std::size_t i = 0; i < n; i++) {
        if (at(i) == at(i + 1)) return false;
        for (std::size_t j = i + 1; j < n; j++) {
            const int allowed = j == i + 1 || (i == 0 && j == n - 1) ? 1 : 0;
            if (shared(at(i), at(i + 1), at(j), at(j + 1)).count != allowed) return false;
        }
    }
    return true;
}

inline std::int64_t twice_area(std::span<const GridPoint2> polygon) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < polygon.size(); k++)
        sum += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
    return sum;
}

// A simple polygon of up to `corners` vertices in either orientation. It grows from a triangle by
// points that bend one of its sides. On a small grid it has many vertices of 180 degrees and narrow
// bays.
inline std::vector<GridPoint2> random_polygon(Random& random, std::size_t corners,
                                              std::uint64_t side) {
    std::vector<GridPoint2> polygon;
    while (polygon.size() < 3 || !is_simple(polygon))
        polygon = {random_point(random, side), random_point(random, side),
                   random_point(random, side)};
    for (std::size_t tries = 0; tries < 6 * corners && polygon.size() < corners; tries++) {
        const std::size_t k = random.below(polygon.size());
        const GridPoint2 p = random_point(random, side), a = polygon[k],
                         b = polygon[(k + 1) % polygon.size()];
        const std::size_t n = polygon.size();
        bool fits = p != a && p != b && shared(a, p, p, b).count == 1;
        for (std::size_t j = 0; j < n && fits; j++) {
            if (j == k) continue;
            const GridPoint2 c = polygon[j], d = polygon[(j + 1) % n];
            fits = shared(a, p, c, d).count == (d == a ? 1 : 0) &&
                   shared(p, b, c, d).count == (c == b ? 1 : 0);
        }
        if (fits) polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(k + 1), p);
    }
    if (random.below(2) == 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

}  // namespace jostle::test
