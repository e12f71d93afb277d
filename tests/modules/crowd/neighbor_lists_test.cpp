// SPDX-License-Identifier: MIT
#include "modules/crowd/src/neighbor_lists.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::modules::crowd_detail {
namespace {

using physics::Vec3;

struct Points {
    std::vector<Vec3> position, velocity;
    std::vector<double> radius;
    std::vector<std::uint8_t> active;
};

Points random_points(test::Random& random, std::size_t count, double spread, bool flat) {
    Points points;
    for (std::size_t k = 0; k < count; k++) {
        points.position.push_back(random.vector(spread));
        points.velocity.push_back(random.vector(2));
        if (flat) points.position.back().z *= 0.01;
        points.radius.push_back(random.in(0.1, 0.4));
        points.active.push_back(random.below(10) != 0);
    }
    return points;
}

std::vector<NearPoint> brute_force(const Points& points, std::size_t self, double reach,
                                   std::size_t most) {
    std::vector<NearPoint> all;
    for (std::uint32_t k = 0; k < points.position.size(); k++) {
        if (k == self || !points.active[k] || !points.active[self]) continue;
        const double gap = gap_between(points.position[self], points.radius[self],
                                       points.position[k], points.radius[k]);
        if (gap <= reach * reach) all.push_back({gap, k});
    }
    std::ranges::sort(all, [](const NearPoint& a, const NearPoint& b) { return a < b; });
    all.resize(std::min(all.size(), most));
    return all;
}

void expect_equals_brute_force(bool flat, double spread, std::size_t most) {
    test::Random random(5);
    physics::World world;
    Points points = random_points(random, 300, spread, flat);
    NeighborLists lists;
    const double reach = 1.5;
    for (int step = 0; step < 60; step++) {
        lists.update(world, points.position, points.radius, points.active, {reach, most, flat});
        for (std::size_t k = 0; k < points.position.size(); k++) {
            const auto expected = brute_force(points, k, reach, most);
            const auto found = lists.of(k);
            ASSERT_EQ(found.size(), expected.size()) << "step " << step << ", point " << k;
            for (std::size_t n = 0; n < expected.size(); n++) {
                ASSERT_EQ(found[n].index, expected[n].index) << "step " << step << ", point " << k;
                ASSERT_EQ(found[n].gap, expected[n].gap);
            }
        }
        for (std::size_t k = 0; k < points.position.size(); k++)
            points.position[k] += points.velocity[k] * (1.0 / 60);
        points.active[random.below(300)] = 0;
    }
}

TEST(NeighborLists, equal_a_search_over_all_points_in_a_dense_plane) {
    expect_equals_brute_force(true, 3, 10);
}
TEST(NeighborLists, equal_a_search_over_all_points_in_a_sparse_plane) {
    expect_equals_brute_force(true, 30, 16);
}
TEST(NeighborLists, equal_a_search_over_all_points_in_space) {
    expect_equals_brute_force(false, 3, 7);
}

TEST(NeighborLists, points_beyond_the_range_of_cells_are_accepted) {
    Points points;
    for (const double x : {-1e9, -3e7, 0.0, 0.5, 3e7, 1e12}) {
        points.position.push_back({x, x, 0});
        points.radius.push_back(0.2);
        points.active.push_back(1);
    }
    NeighborLists lists;
    lists.update(physics::World(), points.position, points.radius, points.active, {1, 4, true});
    ASSERT_EQ(lists.of(2).size(), 1u);
    EXPECT_EQ(lists.of(2)[0].index, 3u);
    EXPECT_TRUE(lists.of(0).empty());
}

}  // namespace
}  // namespace jostle::modules::crowd_detail
