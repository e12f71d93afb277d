// SPDX-License-Identifier: MIT
#include <algorithm>

#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/planar/polygon.h"

namespace jostle::physics::planar {
namespace {

// What is left of the polygon: a ring of corners, counter-clockwise.
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
            const std::uint32_t after = k + 1 == n ? 0 : k + 1;
            next_[left ? k : after] = left ? after : k;
            previous_[left ? after : k] = left ? k : after;
        }
        for (std::uint32_t k = 0; k < n; k++)
            if (turn(k) <= 0) hollow_.push_back(k);
        for (std::uint32_t k = 0; k < n; k++) ear_[k] = is_ear(k);
    }

    // Goes round and takes every other ear, so that triangles do not all share a corner. False when
    // a ring has no ear, which no simple polygon is.
    bool run(std::vector<Triangle>& out) {
        std::uint32_t at = 0, passed = 0;
        for (std::size_t left = corners_.size(); left > 3;) {
            if (!ear_[at]) {
                at = next_[at];
                if (++passed > left) return false;
                continue;
            }
            passed = 0;
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

    // A convex corner whose triangle holds no other corner, not even on the new side. If it holds
    // any it holds one that is not convex, so only those are looked at. For the same reason only
    // the two corners beside an ear that went can become ears.
    bool is_ear(std::uint32_t k) const {
        if (turn(k) <= 0) return false;
        const std::uint32_t before = previous_[k], after = next_[k];
        const Vec2 a = corners_[before], b = corners_[k], c = corners_[after];
        const double low_x = std::min({a.x, b.x, c.x}), high_x = std::max({a.x, b.x, c.x});
        const double low_y = std::min({a.y, b.y, c.y}), high_y = std::max({a.y, b.y, c.y});
        for (const std::uint32_t h : hollow_) {
            const Vec2 p = corners_[h];
            if (p.x < low_x || p.x > high_x || p.y < low_y || p.y > high_y) continue;
            if (h == before || h == after) continue;
            if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    // Returns where to go on.
    std::uint32_t clip(std::uint32_t k) {
        const std::uint32_t before = previous_[k], after = next_[k];
        next_[before] = after;
        previous_[after] = before;
        std::erase_if(hollow_,
                      [&](std::uint32_t h) { return (h == before || h == after) && turn(h) > 0; });
        ear_[before] = is_ear(before);
        ear_[after] = is_ear(after);
        return next_[after];
    }

    std::span<const Vec2> corners_;
    std::vector<std::uint32_t> next_, previous_;
    std::vector<char> ear_;
    std::vector<std::uint32_t> hollow_;  // that are not convex: those alone can be in the way
};

}  // namespace

Result<std::vector<Triangle>> triangles_of_checked(std::span<const Vec2> polygon) {
    std::vector<Triangle> triangles;
    triangles.reserve(polygon.size() - 2);
    if (EarClipper(polygon).run(triangles)) return triangles;
    return invalid_argument(
        "polygon: its corners are too close together to be told apart; give coordinates of 1e-130 "
        "m or more");
}

Result<std::vector<Triangle>> triangulate(std::span<const Vec2> polygon) {
    if (Status s = check_polygon(polygon); !s.ok()) return s.error();
    return triangles_of_checked(polygon);
}

}  // namespace jostle::physics::planar
