// SPDX-License-Identifier: MIT
#include "modules/crowd/src/keep_apart.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/random.h"

namespace jostle::modules::crowd_detail {
namespace {

using physics::Vec3;

constexpr double step = 1.0 / 60;

TEST(KeepApart, discs_that_meet_stop_at_contact) {
    std::vector<Vec3> v{{1, 0, 0}, {-1, 0, 0}};
    DiscContact contact{0, 1, {1, 0, 0}, 0.01, 0.5};
    const auto result = keep_apart(v, {&contact, 1}, {}, step, 1e-9, 50);
    EXPECT_NEAR(v[0].x, 0.5 * 0.01 / step, 1e-12);
    EXPECT_NEAR(v[1].x, -0.5 * 0.01 / step, 1e-12);
    EXPECT_LE(result.overlap, 1e-9);
}

TEST(KeepApart, the_heavier_disc_yields_less) {
    std::vector<Vec3> v{{1, 0, 0}, {-1, 0, 0}};
    DiscContact contact{0, 1, {1, 0, 0}, 0, 0.1};
    keep_apart(v, {&contact, 1}, {}, step, 1e-9, 50);
    EXPECT_NEAR(v[0].x, 0.8, 1e-12);  // takes a tenth of the 2 m/s
    EXPECT_NEAR(v[1].x, 0.8, 1e-12);
}

TEST(KeepApart, wall_stops_the_normal_velocity_only) {
    std::vector<Vec3> v{{1, -2, 0}};
    WallContact contact{0, {0, 1, 0}, 0.005};
    keep_apart(v, {}, {&contact, 1}, step, 1e-9, 50);
    EXPECT_EQ(v[0].x, 1);
    EXPECT_NEAR(v[0].y, -0.005 / step, 1e-12);
}

// Discs packed at random that rush to the centre at up to 20 m/s.
TEST(KeepApart, no_pair_of_a_crush_overlaps_after_the_step) {
    test::Random random(9);
    constexpr double radius = 0.25, tolerance = 1e-4;
    std::vector<Vec3> points, v;
    while (points.size() < 140) {
        const Vec3 p{random.in(-4, 4), random.in(-4, 4), 0};
        bool free = true;
        for (const Vec3 other : points) free = free && length(other - p) >= 2 * radius;
        if (!free) continue;
        points.push_back(p);
        v.push_back(p * -5);
    }
    std::vector<DiscContact> contacts;
    for (std::uint32_t a = 0; a < points.size(); a++)
        for (std::uint32_t b = a + 1; b < points.size(); b++) {
            const Vec3 offset = points[b] - points[a];
            const double distance = length(offset);
            if (distance < 2 * radius + 1.0)
                contacts.push_back({a, b, offset * (1 / distance), distance - 2 * radius, 0.5});
        }
    Vec3 before, after;
    for (const Vec3 one : v) before += one;
    const auto result = keep_apart(v, contacts, {}, step, tolerance, 2000);
    for (const Vec3 one : v) after += one;
    EXPECT_LT(result.iterations, 2000);
    EXPECT_LT(length(after - before), 1e-9);  // equal shares preserve the sum
    for (std::size_t a = 0; a < points.size(); a++)
        for (std::size_t b = a + 1; b < points.size(); b++) {
            const Vec3 offset = points[b] + v[b] * step - points[a] - v[a] * step;
            ASSERT_GE(length(offset), 2 * radius - 3 * tolerance);
        }
}

}  // namespace
}  // namespace jostle::modules::crowd_detail
