// SPDX-License-Identifier: MIT
//
// Compares nearest_velocity() with a slow search.
#include "modules/character/src/nearest_velocity.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

// Dykstra's algorithm: alternating projections onto the half-spaces with corrections converge to
// the nearest point of their intersection.
Vec3 by_projections(Vec3 desired, const std::vector<VelocityPlane>& planes) {
    std::vector<Vec3> corrections(planes.size());
    Vec3 v = desired;
    for (int round = 0; round < 20000; round++)
        for (std::size_t k = 0; k < planes.size(); k++) {
            const Vec3 from = v + corrections[k];
            v = from +
                planes[k].normal * maximum(0, planes[k].min_speed - dot(planes[k].normal, from));
            corrections[k] = from - v;
        }
    return v;
}

TEST(NearestVelocity, matches_a_brute_force_search) {
    test::Random random(3);
    for (int trial = 0; trial < 200; trial++) {
        std::vector<VelocityPlane> planes;
        const std::uint64_t count = random.below(7);
        // A velocity that all planes allow.
        const Vec3 inside = random.vector(3);
        for (std::uint64_t k = 0; k < count; k++) {
            const Vec3 n = random.direction();
            planes.push_back({n, dot(n, inside) - random.in(0, 1)});
        }
        const Vec3 desired = random.vector(6);
        EXPECT_TRUE(
            test::near(nearest_velocity(desired, planes), by_projections(desired, planes), 1e-4))
            << "trial " << trial;
    }
}

TEST(NearestVelocity, stops_in_a_corner_and_slides_along_a_crease) {
    const std::vector<VelocityPlane> room = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
    EXPECT_EQ(nearest_velocity({-1, -2, -3}, room), (Vec3{0, 0, 0}));
    EXPECT_EQ(nearest_velocity({-1, -2, 3}, room), (Vec3{0, 0, 3}));
    EXPECT_EQ(nearest_velocity({1, 2, 3}, room), (Vec3{1, 2, 3}));
}

TEST(NearestVelocity, stays_finite_between_closing_walls) {
    const std::vector<VelocityPlane> press = {{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}};
    const Vec3 v = nearest_velocity({0, 0, 2}, press);
    EXPECT_TRUE(is_finite(v));
    EXPECT_LE(length(v), 3);
}

// Two planes of one wall that differ by rounding intersect far away.
TEST(NearestVelocity, nearly_parallel_planes_do_not_amplify_velocity) {
    for (const double off : {1e-9, 1e-6, 1e-4, 1e-2}) {
        const Vec3 tilted = normalized(Vec3{1, 0, off});
        const std::vector<VelocityPlane> walls = {{{1, 0, 0}, 0},
                                                  {tilted, 1e-4},
                                                  {{0, 0, 1}, -1e-3},
                                                  {normalized(Vec3{-1, off, 0}), -1e-3}};
        EXPECT_LE(length(nearest_velocity({-1, 0, -2}, walls)), 2.3) << off;
        VelocityPlanes merged;
        for (const VelocityPlane& wall : walls) merged.add(wall.normal, wall.min_speed);
        EXPECT_LE(length(merged.nearest({-1, 0, -2})), 2.3) << off;
    }
}

}  // namespace
}  // namespace jostle::modules::character_detail
