// SPDX-License-Identifier: MIT
//
// Counts where meshes cross, without code of the module.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules::cloth_detail {

/// Whether the segment p q crosses the triangle.
inline bool crosses(physics::Vec3 p, physics::Vec3 q, physics::Vec3 a, physics::Vec3 b,
                    physics::Vec3 c) {
    using namespace physics;
    const Vec3 n = cross(b - a, c - a);
    const double dp = dot(n, p - a), dq = dot(n, q - a);
    if (dp * dq >= 0) return false;
    const Vec3 x = p + (q - p) * (dp / (dp - dq));
    const double u = dot(n, cross(b - a, x - a)), v = dot(n, cross(c - b, x - b)),
                 w = dot(n, cross(a - c, x - c));
    return u > 0 && v > 0 && w > 0;
}

/// Edges of triangles of the first mesh that cross triangles of the second one. Edges at a vertex
/// of a triangle of the same mesh do not count: the meshes are the same if their positions are.
inline int crossings(std::span<const physics::Vec3> first_positions,
                     std::span<const std::array<std::uint32_t, 3>> first,
                     std::span<const physics::Vec3> second_positions,
                     std::span<const std::array<std::uint32_t, 3>> second) {
    using namespace physics;
    const bool is_same = first_positions.data() == second_positions.data();
    using Bounds = std::array<Vec3, 2>;
    const auto bounds = [](std::span<const Vec3> x, const std::array<std::uint32_t, 3>& t) {
        return Bounds{min(x[t[0]], min(x[t[1]], x[t[2]])), max(x[t[0]], max(x[t[1]], x[t[2]]))};
    };
    std::vector<Bounds> boxes;
    for (const auto& t : second) boxes.push_back(bounds(second_positions, t));
    int count = 0;
    for (const auto& t : first) {
        const Bounds box = bounds(first_positions, t);
        for (std::size_t g = 0; g < second.size(); g++) {
            const auto& s = second[g];
            const Vec3 low = max(box[0], boxes[g][0]), high = min(box[1], boxes[g][1]);
            if (low.x > high.x || low.y > high.y || low.z > high.z) continue;
            const auto shared = [&](std::uint32_t v) {
                return is_same && (v == s[0] || v == s[1] || v == s[2]);
            };
            for (std::size_t k = 0; k < 3; k++)
                if (!shared(t[k]) && !shared(t[(k + 1) % 3]) &&
                    crosses(first_positions[t[k]], first_positions[t[(k + 1) % 3]],
                            second_positions[s[0]], second_positions[s[1]], second_positions[s[2]]))
                    count++;
        }
    }
    return count;
}

}  // namespace jostle::modules::cloth_detail
