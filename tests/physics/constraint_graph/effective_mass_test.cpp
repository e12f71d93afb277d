// SPDX-License-Identifier: MIT
//
// Effective masses against closed forms: 1/m + (r x n)^2 / I and its like.
#include "physics/src/constraint_graph/effective_mass.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace jostle::test {
namespace {
using namespace physics;

// One lane of a block, in the middle of others.
struct Lane {
    ContactConstraintWide block{};
    ContactConstraintWideMeta meta{};
    RollingWide rolling{};
    static constexpr int lane = 3;
    ContactLaneRef place() { return {&block, &meta, &rolling, lane}; }
};

InverseMass ball(double mass, double radius) {
    const double inertia = 0.4 * mass * radius * radius;
    return {Vec3{1, 1, 1} / mass, diagonal(Vec3{1, 1, 1} / inertia)};
}

// Balls of 2 kg and 3 kg with radii of 0.5 m and 0.25 m, one on the other.
TEST(EffectiveMass, matches_the_closed_form_for_two_balls) {
    Lane lane;
    write_effective_mass(
        lane.place(),
        {.normal = {0, 1, 0}, .tangent = {1, 0, 0}, .arm_a = {0, 0.5, 0}, .arm_b = {0, -0.25, 0}},
        ball(2, 0.5), ball(3, 0.25));
    const double inertia_a = 0.4 * 2 * 0.25, inertia_b = 0.4 * 3 * 0.0625;
    const double turns = 1 / inertia_a + 1 / inertia_b;
    const ContactConstraintWide& block = lane.block;
    const int k = Lane::lane;
    EXPECT_NEAR(block.g[0][k], 1 / 2.0 + 1 / 3.0, 1e-6) << "r x n is nothing: masses alone";
    EXPECT_NEAR(block.g[1][k], 0, 1e-6);
    EXPECT_NEAR(block.g[2][k], 0, 1e-6);
    EXPECT_NEAR(block.g[3][k], turns, 1e-6 * turns);
    EXPECT_NEAR(block.g[4][k], 0, 1e-6);
    EXPECT_NEAR(block.g[5][k], turns, 1e-6 * turns);
    EXPECT_NEAR(block.torsion_mass[k], 1 / turns, 1e-6);
    // Along the surface a ball answers three and a half times as readily: 1/m + r^2 / I = 7/2 / m.
    const double along = 3.5 * (1 / 2.0 + 1 / 3.0);
    EXPECT_NEAR(block.friction_mass[0][k], 1 / along, 1e-6);
    EXPECT_NEAR(block.friction_mass[1][k], 0, 1e-6);
    EXPECT_NEAR(block.friction_mass[2][k], 1 / along, 1e-6);
    for (int other = 0; other < 8; other++) {
        if (other != k) {
            EXPECT_EQ(block.g[0][other], 0) << "its own lane only";
        }
    }
}

// A rod of 12 kg and 2 m along x is hit at its end from below: 1/m + r^2 / I with I = m l^2 / 12.
TEST(EffectiveMass, at_the_end_of_a_rod_is_a_quarter_of_the_mass) {
    Lane lane;
    const InverseMass rod{Vec3{1, 1, 1} / 12, diagonal({1 / 0.01, 1 / 4.0, 1 / 4.0})};
    write_effective_mass(
        lane.place(), {.normal = {0, 1, 0}, .tangent = {1, 0, 0}, .arm_a = {}, .arm_b = {1, 0, 0}},
        {}, rod);
    EXPECT_NEAR(lane.block.g[0][Lane::lane], 4 / 12.0, 1e-6);
}

// What cannot be pushed answers with nothing: no infinite number comes of it.
TEST(EffectiveMass, is_zero_for_immovable_bodies) {
    Lane lane;
    write_effective_mass(lane.place(), {.normal = {0, 1, 0}, .tangent = {1, 0, 0}}, {}, {});
    for (int row = first_saved_row; row < wide_rows; row++)
        EXPECT_TRUE(is_finite(double{float_at(lane.block, row, Lane::lane)})) << row;
    EXPECT_EQ(lane.block.torsion_mass[Lane::lane], 0);
    EXPECT_EQ(lane.block.friction_mass[0][Lane::lane], 0);
}

// A body that moves along x alone: friction along z finds nobody who gives way.
TEST(EffectiveMass, locked_axes_limit_friction_to_one_direction) {
    Lane lane;
    const InverseMass slider{{1 / 4.0, 0, 0}, diagonal({0, 0, 0})};
    write_effective_mass(lane.place(), {.normal = {0, 1, 0}, .tangent = {1, 0, 0}}, slider, {});
    EXPECT_NEAR(lane.block.friction_mass[0][Lane::lane], 4, 1e-6);
    EXPECT_EQ(lane.block.friction_mass[1][Lane::lane], 0);
    EXPECT_EQ(lane.block.friction_mass[2][Lane::lane], 0);
}

// Of any pair: an impulse of friction_mass * slip at the centre stops the slip there.
TEST(EffectiveMass, friction_impulse_stops_slip_in_one_solve) {
    Random random(71);
    for (int round = 0; round < 200; round++) {
        Lane lane;
        const Vec3 n = random.direction(), t1 = normalized(cross(n, random.direction()));
        const Vec3 t2 = cross(n, t1);
        const auto body = [&] {
            const Mat3 axes = to_matrix(random.rotation());
            const Vec3 inverse{random.in(0.1, 2), random.in(0.1, 2), random.in(0.1, 2)};
            return InverseMass{Vec3{1, 1, 1} * random.in(0.1, 2),
                               axes * diagonal(inverse) * transpose(axes)};
        };
        const InverseMass a = body(), b = body();
        const ContactFrame frame{n, t1, random.vector(1), random.vector(1)};
        write_effective_mass(lane.place(), frame, a, b);
        const double u = random.in(-1, 1), v = random.in(-1, 1);  // m/s along the tangents
        const auto& m = lane.block.friction_mass;
        const int k = Lane::lane;
        const Vec3 impulse = t1 * -(double{m[0][k]} * u + double{m[1][k]} * v) +
                             t2 * -(double{m[1][k]} * u + double{m[2][k]} * v);
        const auto answer = [&](const InverseMass& body_mass, Vec3 arm) {
            return scaled(body_mass.linear, impulse) +
                   cross(body_mass.angular * cross(arm, impulse), arm);
        };
        const Vec3 left = t1 * u + t2 * v + answer(a, frame.arm_a) + answer(b, frame.arm_b);
        EXPECT_NEAR(dot(left, t1), 0, 1e-5) << round;
        EXPECT_NEAR(dot(left, t2), 0, 1e-5) << round;
    }
}

// Its mass halves, so a contact that is as soft gives way twice as far for what exceeds its mean:
// the mean comes half as near to the impulse that it has, and the load stays what it is.
TEST(EffectiveMass, rewrite_keeps_the_impulses) {
    Lane lane;
    const ContactFrame frame{
        .normal = {0, 1, 0}, .tangent = {1, 0, 0}, .arm_a = {0, 0.5, 0}, .arm_b = {}};
    put_lane(lane.block.normal, Lane::lane, frame.normal);
    put_lane(lane.block.tangent, Lane::lane, frame.tangent);
    put_lane(lane.block.arm_a, Lane::lane, frame.arm_a);
    write_effective_mass(lane.place(), frame, ball(2, 0.5), {});
    lane.block.lambda[0][Lane::lane] = 10;
    lane.block.mean_impulse[0][Lane::lane] = 8;
    rewrite_effective_mass(lane.place(), ball(1, 0.5), {});
    EXPECT_NEAR(lane.block.g[0][Lane::lane], 1, 1e-6);
    EXPECT_NEAR(lane.block.lambda[0][Lane::lane], 10, 1e-6);
    EXPECT_NEAR(lane.block.mean_impulse[0][Lane::lane], 10 - (10 - 8) / 2.0, 1e-5);
}

}  // namespace
}  // namespace jostle::test
