// SPDX-License-Identifier: MIT
#include <algorithm>

#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/planar/planar_checks.h"

namespace jostle::physics::planar {
namespace {

// The remaining polygon as a ring of corners, counter-clockwise.
class EarClipper {
public:
    explicit EarClipper(std::span<const Vec2> polygon)
        : corners_(polygon),
          next_(polygon.size()),
          previous_(polygon.size()),
          ear_(polygon.size()) {
        const auto n = static_cast<std::uint32_t>(polygon.size());
        const bool left = runs_counter_clockwise(polygon);
        for (std::uint32_t k = 0; k < n; k++) {
            const std::uint32_t next = k + 1 == n ? 0 : k + 1;
            next_[left ? k : next] = left ? next : k;
            previous_[left ? next : k] = left ? k : next;
        }
        for (std::uint32_t k = 0; k < n; k++)
            if (turn(k) <= 0) hollow_.push_back(k);
        for (std::uint32_t k = 0; k < n; k++) ear_[k] = is_ear(k);
    }

    // Traverses the ring and clips every second ear, so that the triangles do not all share a
    // corner. Returns false if a ring has no ear, which is impossible for a simple polygon.
    bool run(std::vector<Triangle>& out) {
        std::uint32_t at = 0, visited = 0;
        for (std::size_t left = corners_.size(); left > 3;) {
            if (!ear_[at]) {
                at = next_[at];
                if (++visited > left) return false;
                continue;
            }
            visited = 0;
            out.push_back({previous_[at], at, next_[at]});
            at = clip(at);
            left--;
        }
        out.push_back({previous_[at], at, next_[at]});
        return true;
    }

private:
    int turn(std::uint32_t k) const {
        return orientation(corners_[previous_[k]], corners_[k], corners_[next_[k]]);
    }

    // A convex corner whose triangle contains no other corner, not even on its new side. If it
    // contains any corner, it contains a reflex one, so only those are tested. For the same reason
    // only the two neighbours of a clipped ear can become ears.
    bool is_ear(std::uint32_t k) const {
        if (turn(k) <= 0) return false;
        const std::uint32_t previous = previous_[k], next = next_[k];
        const Vec2 a = corners_[previous], b = corners_[k], c = corners_[next];
        const double low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
        const double low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
        for (const std::uint32_t h : hollow_) {
            const Vec2 p = corners_[h];
            if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) continue;
            if (h == previous || h == next) continue;
            if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    // Clips an ear and returns the next corner to test.
    std::uint32_t clip(std::uint32_t k) {
        const std::uint32_t previous = previous_[k], next = next_[k];
        next_[previous] = next;
        previous_[next] = previous;
        std::erase_if(hollow_,
                      [&](std::uint32_t h) { return (h == previous || h == next) && turn(h) > 0; });
        ear_[previous] = is_ear(previous);
        ear_[next] = is_ear(next);
        return next_[next];
    }

    std::span<const Vec2> corners_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<char> ear_;
    std::vector<std::uint32_t> hollow_;  // reflex corners; only these can be inside an ear
};

}  // namespace

Result<std::vector<Triangle>> triangles_of_checked(std::span<const Vec2> polygon) {
    std::vector<Triangle> triangles;
    triangles.reserve(polygon.size() - 2);
    if (EarClipper(polygon).run(triangles)) return triangles;
    return invalid_argument(
        "polygon: its corners are too close to each other; use coordinates of at least 1e-130 "
        "m");
}

Result<std::vector<Triangle>> triangulate(std::span<const Vec2> polygon) {
    if (Status s = check_polygon(polygon); !s.ok()) return s.error();
    return triangles_of_checked(polygon);
}

}  // namespace jostle::physics::planar
