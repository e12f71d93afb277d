// SPDX-License-Identifier: MIT
//
// Two bodies at the moment when they meet: momentum stays, energy never grows.
#include "physics/src/constraints/impact.h"

#include <gtest/gtest.h>

#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

ImpactBody ball(double mass, double radius, Vec3 center, Vec3 velocity) {
    const double inertia = 0.4 * mass * radius * radius;
    return {.center = center,
            .inverse_mass = Vec3{1, 1, 1} / mass,
            .inverse_inertia = diagonal(Vec3{1, 1, 1} / inertia),
            .v = velocity};
}
const ImpactPoint at_origin{.position = {}, .normal = {1, 0, 0}};

TEST(Impact, equal_elastic_balls_exchange_velocities) {
    ImpactBody a = ball(2, 1, {-1, 0, 0}, {3, 0, 0}), b = ball(2, 1, {1, 0, 0}, {-1, 0, 0});
    const HardestPoint hardest = resolve_impact(a, b, std::vector{at_origin}, 1, 0.5);
    EXPECT_NEAR(hardest.approach, 4, 1e-12);
    EXPECT_TRUE(near(a.v, {-1, 0, 0}, 1e-12));
    EXPECT_TRUE(near(b.v, {3, 0, 0}, 1e-12));
}

// Without restitution 1 kg at 6 m/s and 2 kg at rest go on together at 2 m/s.
TEST(Impact, inelastic_balls_move_together) {
    ImpactBody a = ball(1, 1, {-1, 0, 0}, {6, 0, 0}), b = ball(2, 1, {1, 0, 0}, {});
    resolve_impact(a, b, std::vector{at_origin}, 0, 0.5);
    EXPECT_TRUE(near(a.v, {2, 0, 0}, 1e-12));
    EXPECT_TRUE(near(b.v, {2, 0, 0}, 1e-12));
}

// Slower than 0.3 m/s nothing bounces; what goes apart is left alone.
TEST(Impact, slow_contacts_do_not_bounce_and_separating_contacts_are_ignored) {
    ImpactBody slow = ball(1, 1, {-1, 0, 0}, {0.29, 0, 0}), wall{};
    resolve_impact(slow, wall, std::vector{at_origin}, 1, 0);
    EXPECT_NEAR(slow.v.x, 0, 1e-12);
    ImpactBody fast = ball(1, 1, {-1, 0, 0}, {0.31, 0, 0});
    resolve_impact(fast, wall, std::vector{at_origin}, 1, 0);
    EXPECT_NEAR(fast.v.x, -0.31, 1e-12);
    ImpactBody leaving = ball(1, 1, {-1, 0, 0}, {-5, 1, 0});
    EXPECT_EQ(resolve_impact(leaving, wall, std::vector{at_origin}, 1, 1).approach, 0);
    EXPECT_EQ(leaving.v, (Vec3{-5, 1, 0}));
}

// A ball that slides along the wall it hits: friction of 0.1 takes a tenth of the normal impulse
// from its speed, friction of 2 makes it roll, with 5/7 of its speed left.
TEST(Impact, friction_follows_coulomb_until_the_ball_rolls) {
    for (const auto& [friction, left] : {std::pair{0.1, 7 - 0.1 * 4}, {2.0, 5.0}}) {
        ImpactBody a = ball(1, 0.5, {-0.5, 0, 0}, {4, 7, 0}), wall{};
        resolve_impact(a, wall, std::vector{at_origin}, 0, friction);
        EXPECT_NEAR(a.v.y, left, 1e-6) << friction;
        EXPECT_NEAR(a.w.z, -(7 - left) / (0.4 * 0.5), 1e-5);
        EXPECT_EQ(wall.v, Vec3{});
    }
}

// Random rods, points, normals: momentum stays to rounding, energy does not grow.
TEST(Impact, never_adds_energy) {
    Random random(171);
    for (int round = 0; round < 1000; round++) {
        const auto rod = [&](Vec3 center) {
            const Mat3 axes = to_matrix(random.rotation());
            const Vec3 inverse{random.in(0.2, 50), random.in(0.2, 2), random.in(0.2, 2)};
            return ImpactBody{.center = center,
                              .inverse_mass = Vec3{1, 1, 1} * random.in(0.2, 2),
                              .inverse_inertia = axes * diagonal(inverse) * transpose(axes),
                              .v = random.vector(5),
                              .w = random.vector(5)};
        };
        ImpactBody a = rod({}), b = rod(random.vector(2));
        std::vector<ImpactPoint> points;
        const Vec3 normal = random.direction();
        for (std::uint64_t k = 0; k < 1 + random.below(4); k++)
            points.push_back({random.vector(2), normal});
        const auto energy = [&] {
            double sum = 0;
            for (const ImpactBody* body : {&a, &b})
                sum += 0.5 * length_squared(body->v) / body->inverse_mass.x +
                       0.5 * dot(body->w, inverse(body->inverse_inertia) * body->w);
            return sum;
        };
        const auto momentum = [&] { return a.v / a.inverse_mass.x + b.v / b.inverse_mass.x; };
        const double energy_before = energy();
        const Vec3 momentum_before = momentum();
        resolve_impact(a, b, points, 0, random.in(0, 1));
        EXPECT_LE(energy(), energy_before * (1 + 1e-9)) << round;
        EXPECT_TRUE(near(momentum(), momentum_before, 1e-9)) << round;
    }
}

}  // namespace
}  // namespace jostle::test
