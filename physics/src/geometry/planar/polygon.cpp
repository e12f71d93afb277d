// SPDX-License-Identifier: MIT
#include "physics/src/geometry/planar/planar_checks.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/messages.h"

namespace jostle::physics::planar {
namespace {

std::string pair_of(std::size_t i, std::size_t j) {
    return std::to_string(i) + " and " + std::to_string(j);
}

}  // namespace

double signed_area(std::span<const Vec2> polygon) {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); k++)
        twice += cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    return 0.5 * twice;
}

// The leftmost corner (of several, the lowest) is convex.
bool runs_counter_clockwise(std::span<const Vec2> polygon) {
    const std::size_t n = polygon.size();
    std::size_t at = 0;
    ASSERT(n >= 3);
    for (std::size_t k = 1; k < n; k++)
        if (polygon[k].x < polygon[at].x ||
            (polygon[k].x == polygon[at].x && polygon[k].y < polygon[at].y))
            at = k;
    return orientation(polygon[(at + n - 1) % n], polygon[at], polygon[(at + 1) % n]) > 0;
}

Status check_polygon(std::span<const Vec2> polygon) {
    if (Status s = check_points("polygon", polygon, 3, max_polygon_corners); !s.ok()) return s;
    const std::size_t n = polygon.size();
    for (std::size_t k = 0; k < n; k++)
        if (polygon[k] == polygon[(k + 1) % n])
            return invalid_argument(
                "polygon: corners " + pair_of(k, (k + 1) % n) +
                " are equal; list each corner once, the last is connected to the first");
    const auto side = [&](std::size_t k) { return Segment{polygon[k], polygon[(k + 1) % n]}; };
    const auto low = [&](std::size_t k) { return minimum(side(k).from.x, side(k).to.x); };
    const auto high = [&](std::size_t k) { return maximum(side(k).from.x, side(k).to.x); };
    std::vector<std::size_t> order(n);
    for (std::size_t k = 0; k < n; k++) order[k] = k;
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
        return low(i) < low(j) || (low(i) == low(j) && i < j);
    });
    for (std::size_t at = 0; at < n; at++)
        for (std::size_t after = at + 1; after < n; after++) {
            const std::size_t i = std::min(order[at], order[after]),
                              j = std::max(order[at], order[after]);
            if (low(order[after]) > high(order[at])) break;
            const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
            const SegmentRelation relation = intersect(side(i), side(j)).relation;
            if (relation == (neighbours ? SegmentRelation::touching : SegmentRelation::apart))
                continue;
            return invalid_argument("polygon: sides " + pair_of(i, j) +
                                    (neighbours
                                         ? " double back on each other"
                                         : " intersect; sides may share only the corner between "
                                           "neighbours") +
                                    " (side k runs from corner k to the next)");
        }
    return {};
}

}  // namespace jostle::physics::planar
