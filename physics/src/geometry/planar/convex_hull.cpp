// SPDX-License-Identifier: MIT
#include "physics/src/geometry/planar/planar_checks.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/physics/planar.h"

namespace jostle::physics::planar {
namespace {

bool left_of(Vec2 a, Vec2 b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// Returns whether `further`, which is collinear with the two points, lies beyond `end` seen from
// `start`.
bool beyond(Vec2 start, Vec2 end, Vec2 further) {
    return end == start || (left_of(start, end) ? left_of(end, further) : left_of(further, end));
}

}  // namespace

std::vector<Vec2> hull_of_checked(std::span<const Vec2> points) {
    std::vector<Vec2> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(), left_of);
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    std::vector<Vec2> chain;
    const auto add = [&](Vec2 p, std::size_t least) {
        while (chain.size() >= least + 2 &&
               orientation(chain[chain.size() - 2], chain.back(), p) <= 0)
            chain.pop_back();
        chain.push_back(p);
    };
    for (const Vec2 p : sorted) add(p, 0);
    // The rightmost point, where the upper chain starts.
    const std::size_t lower = chain.size() - 1;
    ASSERT(chain.size() >= 2);
    for (std::size_t k = sorted.size() - 1; k-- > 0;) add(sorted[k], lower);
    chain.pop_back();  // the last point equals the first
    ASSERT(chain.size() >= 2 && chain.size() <= sorted.size());
    return chain;
}

Result<std::vector<Vec2>> convex_hull(std::span<const Vec2> points) {
    if (Status s = check_points("points", points, 1, max_planar_points); !s.ok()) return s.error();
    return hull_of_checked(points);
}

Result<std::vector<Vec2>> hull_by_gift_wrapping(std::span<const Vec2> points) {
    if (Status s = check_points("points", points, 1, max_planar_points); !s.ok()) return s.error();
    const Vec2 first = *std::min_element(points.begin(), points.end(), left_of);
    std::vector<Vec2> hull;
    Vec2 at = first;
    do {
        hull.push_back(at);
        // Select the next corner such that no point is to the right of the line to it.
        Vec2 next = at;
        for (const Vec2 p : points) {
            if (p == at) continue;
            const int side = next == at ? -1 : orientation(at, next, p);
            if (side < 0 || (side == 0 && beyond(at, next, p))) next = p;
        }
        at = next;
    } while (at != first && hull.size() < points.size());
    return hull;
}

}  // namespace jostle::physics::planar
