// SPDX-License-Identifier: MIT
//
// Which four of many points stand for a face. Both cases are of boxes in a heap, seen from above.
#include "physics/src/collision/narrowphase/manifold_reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace jostle::test {
namespace {
using namespace physics;

// The indices that are kept, in rising order.
std::vector<int> kept(std::vector<FacePoint> points) {
    for (std::size_t k = 0; k < points.size(); k++) points[k].index = static_cast<int>(k);
    const int count = reduce_to_four(points.data(), static_cast<int>(points.size()), 1);
    std::vector<int> indices;
    for (int k = 0; k < count; k++) indices.push_back(points[static_cast<std::size_t>(k)].index);
    std::sort(indices.begin(), indices.end());
    return indices;
}

// A box that bears 180 times its weight on the edge between the first two points. By area alone the
// first, which bore all of it, went: the box was thrown at 1 m/s, again and again.
TEST(ManifoldReduction, keeps_both_ends_of_the_loaded_edge) {
    const auto chosen = kept({{-0.2633, -0.2117, -0.0015},
                              {-0.3107, -0.0713, -0.00173},
                              {-0.1419, 0.3594, -0.00006},
                              {0.2218, 0.2208, 0.0024},
                              {0.2393, -0.0371, 0.00225}});
    EXPECT_EQ(std::vector(chosen.begin(), chosen.begin() + 3), (std::vector{0, 1, 2}));
}

// A box that stands on the first corner and is about to tip over the second.
TEST(ManifoldReduction, keeps_the_corner_that_touches_next) {
    const auto chosen = kept({{0.2, 0.1, -0.00005},
                              {0.15, -0.1, 0.0004},
                              {-0.3, -0.2, 0.0163},
                              {-0.3, 0.2, 0.0159},
                              {0.2, 0.25, 0.0049},
                              {-0.1, 0.35, 0.012}});
    EXPECT_EQ(std::vector(chosen.begin(), chosen.begin() + 2), (std::vector{0, 1}));
}

// Flat on eight corners: the deepest, the one across, and one on either side.
TEST(ManifoldReduction, spans_the_face_if_all_points_touch) {
    std::vector<FacePoint> octagon;
    for (int k = 0; k < 8; k++) {
        constexpr double u[] = {2, 1, -1, -2, -2, -1, 1, 2}, v[] = {1, 2, 2, 1, -1, -2, -2, -1};
        octagon.push_back({0.1 * u[k], 0.1 * v[k], k == 0 ? -0.0002 : -0.0001});
    }
    EXPECT_EQ(kept(octagon), (std::vector{0, 2, 4, 6}));
}

}  // namespace
}  // namespace jostle::test
