// SPDX-License-Identifier: MIT
#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/geometry/planar/planar_checks.h"

namespace jostle::physics::planar {
namespace {

constexpr std::uint32_t no_index = 0xffffffff;

// The sides of all parts: 3 t, 3 t + 1 and 3 t + 2 belong to triangle t. Inner sides occur twice,
// once in each direction.
class PartJoiner {
public:
    PartJoiner(std::span<const Vec2> polygon, const std::vector<Triangle>& triangles,
               std::size_t max_corners)
        : corners_(polygon), max_corners_(max_corners) {
        for (std::uint32_t t = 0; t < triangles.size(); t++)
            for (std::uint32_t k = 0; k < 3; k++) {
                from_.push_back(triangles[t][k]);
                next_.push_back(3 * t + (k + 1) % 3);
                previous_.push_back(3 * t + (k + 2) % 3);
                part_.push_back(t);
            }
        removed_.assign(from_.size(), 0);
        size_.assign(triangles.size(), 3);
        for (std::uint32_t t = 0; t < triangles.size(); t++) into_.push_back(t);
        find_twins();
    }

    std::vector<ConvexPart> run() {
        for (std::uint32_t side = 0; side < from_.size(); side++)
            if (twin_[side] != no_index && side < twin_[side]) join_across(side);
        std::vector<ConvexPart> parts;
        std::vector<char> seen = removed_;
        for (std::uint32_t side = 0; side < from_.size(); side++) {
            if (seen[side]) continue;
            ConvexPart& part = parts.emplace_back();
            for (std::uint32_t k = side; !seen[k]; k = next_[k]) {
                part.push_back(from_[k]);
                seen[k] = 1;
            }
        }
        return parts;
    }

private:
    void find_twins() {
        twin_.assign(from_.size(), no_index);
        // Pairs of corners, lower first, with the side. Sorting makes equal pairs adjacent.
        std::vector<std::array<std::uint32_t, 3>> pairs;
        for (std::uint32_t side = 0; side < from_.size(); side++) {
            const std::uint32_t a = from_[side], b = from_[next_[side]];
            pairs.push_back({std::min(a, b), std::max(a, b), side});
        }
        std::sort(pairs.begin(), pairs.end());
        for (std::size_t k = 1; k < pairs.size(); k++)
            if (pairs[k - 1][0] == pairs[k][0] && pairs[k - 1][1] == pairs[k][1]) {
                twin_[pairs[k - 1][2]] = pairs[k][2];
                twin_[pairs[k][2]] = pairs[k - 1][2];
            }
    }

    // Joined parts share a root.
    std::uint32_t root_of(std::uint32_t part) {
        while (into_[part] != part) part = into_[part] = into_[into_[part]];
        return part;
    }

    // Returns whether the corner between `in` and `out` is convex or straight.
    bool convex(std::uint32_t in, std::uint32_t out) const {
        return orientation(corners_[from_[in]], corners_[from_[out]],
                           corners_[from_[next_[out]]]) >= 0;
    }

    void join_across(std::uint32_t side) {
        const std::uint32_t twin = twin_[side];
        ASSERT(twin != side && twin_[twin] == side);
        const std::uint32_t a = root_of(part_[side]), b = root_of(part_[twin]);
        if (size_[a] + size_[b] - 2 > max_corners_) return;
        ASSERT(a != b);
        if (!convex(previous_[side], next_[twin]) || !convex(previous_[twin], next_[side])) return;
        link(previous_[side], next_[twin]);
        link(previous_[twin], next_[side]);
        removed_[side] = removed_[twin] = 1;
        size_[a] += size_[b] - 2;
        into_[b] = a;
    }
    void link(std::uint32_t in, std::uint32_t out) {
        ASSERT(in < next_.size() && out < next_.size());
        next_[in] = out;
        previous_[out] = in;
    }

    std::span<const Vec2> corners_;
    std::size_t max_corners_;
    std::vector<std::uint32_t> from_, next_, previous_, twin_, part_;  // by side
    std::vector<char> removed_;                                        // by side
    std::vector<std::size_t> size_;                                    // by part: number of corners
    std::vector<std::uint32_t> into_;                                  // by part
};

}  // namespace

Result<std::vector<ConvexPart>> convex_parts(std::span<const Vec2> polygon,
                                             std::size_t max_corners) {
    if (max_corners < 3)
        return invalid_argument("max_corners is " + std::to_string(max_corners) +
                                "; it must be at least 3");
    const auto triangles = triangulate(polygon);
    if (!triangles.ok()) return triangles.error();
    return PartJoiner(polygon, *triangles, max_corners).run();
}

}  // namespace jostle::physics::planar
