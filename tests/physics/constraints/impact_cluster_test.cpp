// SPDX-License-Identifier: MIT
//
// Simultaneous impacts of touching bodies: independent of their order, along rows to the last body,
// and without a gain of energy.
#include "physics/src/constraints/impact_cluster.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

// A ball of 1 kg and radius 1 m.
ImpactBody ball_at(Vec3 center, Vec3 velocity = {}) {
    return {.center = center,
            .inverse_mass = {1, 1, 1},
            .inverse_inertia = diagonal({2.5, 2.5, 2.5}),
            .v = velocity,
            .w = {}};
}

void touch(ImpactCluster& cluster, std::uint32_t a, std::uint32_t b, double restitution = 1,
           double friction = 0) {
    const Vec3 at = cluster.bodies()[a].center, to = cluster.bodies()[b].center;
    cluster.add_pair({a, b, {{(at + to) * 0.5, normalized(to - at)}}, restitution, friction, {}});
}

double energy_of(const ImpactCluster& cluster) {
    double sum = 0;
    for (const ImpactBody& b : cluster.bodies())
        sum += 0.5 * length_squared(b.v) + 0.5 * 0.4 * length_squared(b.w);
    return sum;
}

void reflect_all(ImpactCluster& cluster) {
    for (int round = 0; round < 200 && cluster.reflect(1e-9, 0); round++) {
    }
}

TEST(ImpactCluster, passes_an_impulse_along_a_row_to_the_last_ball) {
    ImpactCluster cluster;
    for (int k = 0; k < 5; k++)
        cluster.add_body(ball_at({2.0 * k, 0, 0}, {k == 0 ? 3.0 : 0, 0, 0}));
    for (std::uint32_t k = 0; k < 4; k++) touch(cluster, k, k + 1);
    reflect_all(cluster);
    for (std::size_t k = 0; k < 5; k++)
        EXPECT_NEAR(cluster.bodies()[k].v.x, k == 4 ? 3 : 0, 1e-9) << k;
    EXPECT_NEAR(cluster.pairs()[2].hit.normal_impulse, 3, 1e-9);
}

// The ball in the middle has two neighbours at 30 degrees. Both get equal shares: along the line of
// motion it returns at a fifth of its speed (conservation of energy and momentum on paper).
TEST(ImpactCluster, ball_between_two_others_hits_both_equally) {
    for (const bool swapped : {false, true}) {
        ImpactCluster cluster;
        const double s = square_root(3.0);
        cluster.add_body(ball_at({0, 0, 0}, {1, 0, 0}));
        cluster.add_body(ball_at({s, 0, swapped ? -1.0 : 1.0}));
        cluster.add_body(ball_at({s, 0, swapped ? 1.0 : -1.0}));
        touch(cluster, 0, 1);
        touch(cluster, 0, 2);
        reflect_all(cluster);
        EXPECT_TRUE(near(cluster.bodies()[0].v, {-0.2, 0, 0}, 1e-12));
        const Vec3 one = cluster.bodies()[1].v, two = cluster.bodies()[2].v;
        EXPECT_TRUE(near(one, {two.x, 0, -two.z}, 1e-12));
        EXPECT_NEAR(energy_of(cluster), 0.5, 1e-12);
    }
}

TEST(ImpactCluster, never_gains_energy_and_ends_without_approach) {
    Random random(3);
    for (int run = 0; run < 200; run++) {
        ImpactCluster cluster;
        for (int x = 0; x < 3; x++)
            for (int z = 0; z < 3; z++)
                cluster.add_body(ball_at({2.0 * x, 0, 2.0 * z}, random.vector(2)));
        const double restitution = random.in(0, 1), friction = random.in(0, 1);
        for (std::uint32_t k = 0; k < 9; k++) {
            if (k % 3 != 2) touch(cluster, k, k + 1, restitution, friction);
            if (k < 6) touch(cluster, k, k + 3, restitution, friction);
        }
        for (int round = 0; round < 30; round++) {
            const double before = energy_of(cluster);
            if (!cluster.reflect(1e-9, 0.3)) break;
            EXPECT_LE(energy_of(cluster), before * (1 + 1e-12));
        }
        const double before = energy_of(cluster);
        cluster.stop();
        EXPECT_LE(energy_of(cluster), before * (1 + 1e-12));
        EXPECT_LT(cluster.hardest(), 1e-9);
    }
}

TEST(ImpactCluster, slow_impacts_stop) {
    ImpactCluster cluster;
    cluster.add_body(ball_at({0, 0, 0}, {0.2, 0, 0}));
    cluster.add_body(ball_at({2, 0, 0}));
    touch(cluster, 0, 1);
    EXPECT_TRUE(cluster.reflect(1e-9, 0.3));
    EXPECT_NEAR(cluster.bodies()[0].v.x, 0.1, 1e-12);
    EXPECT_NEAR(cluster.bodies()[1].v.x, 0.1, 1e-12);
    EXPECT_FALSE(cluster.reflect(1e-9, 0.3));
}

}  // namespace
}  // namespace jostle::test
