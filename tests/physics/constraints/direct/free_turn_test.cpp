// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/free_turn.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

double turning_energy(Quat q, Vec3 momentum, Vec3 inverse) {
    const Vec3 l = inverse_rotate(q, momentum);
    return 0.5 * dot(scaled(l, inverse), l);
}

// Dzhanibekov's body for ten minutes: it flips again and again, and its turning_energy does not
// drift.
TEST(FreeTurn, conserves_the_energy_of_a_flipping_body) {
    const Vec3 inverse{1 / 0.1, 1 / 0.2, 1 / 0.28}, momentum{0.001, 1, 0.0028};
    Quat q;
    const double before = turning_energy(q, momentum, inverse);
    double most = 0;
    for (int k = 0; k < 600 * 60; k++) {
        q = free_turn(q, momentum, inverse, 1.0 / 60);
        most = maximum(most, absolute(turning_energy(q, momentum, inverse) / before - 1));
    }
    EXPECT_LT(most, 2e-4);
    EXPECT_NEAR(norm_squared(q), 1, 1e-12);
}

// Half the step, a quarter of the error.
TEST(FreeTurn, is_second_order_accurate) {
    const Vec3 inverse{10, 5, 3}, momentum{0.3, 0.5, -0.2};
    const auto end = [&](int steps) {
        Quat q;
        for (int k = 0; k < steps; k++) q = free_turn(q, momentum, inverse, 1.0 / steps);
        return q;
    };
    const Quat exact = end(20000);
    const auto error = [&](int steps) {
        const Quat off = conjugate(exact) * end(steps);
        return length(Vec3{off.x, off.y, off.z});
    };
    EXPECT_NEAR(error(100) / error(200), 4, 0.2);
}

// A top: its axis goes round the momentum at |L| / I, exactly, in one step of a second.
TEST(FreeTurn, is_exact_for_a_symmetric_body) {
    const Vec3 inverse{1 / 0.3, 1 / 0.3, 1 / 0.1}, momentum{0.2, 0, 0.5};
    const Quat q = free_turn({}, momentum, inverse, 1);
    const double angle = length(momentum) / 0.3;
    const Vec3 axis = rotate(from_axis_angle(momentum, angle), {0, 0, 1});
    EXPECT_LT(length(rotate(q, {0, 0, 1}) - axis), 1e-13);
    EXPECT_NEAR(turn_rate(momentum, inverse), angle, 1e-12);
}

TEST(FreeTurn, is_time_reversible) {
    const Vec3 inverse{10, 5, 3}, momentum{3, -2, 1};
    const Quat start = normalized(Quat{0.1, 0.2, 0.3, 0.9});
    const Quat back = free_turn(free_turn(start, momentum, inverse, 0.1), momentum, inverse, -0.1);
    EXPECT_LT(length(Vec3{back.x - start.x, back.y - start.y, back.z - start.z}), 1e-14);
}

// By series and by the library's sine: the same turn.
TEST(FreeTurn, handles_any_rotation_vector) {
    for (const double angle : {0.0, 1e-9, 0.5, 0.9999, 1.0001, 3.0, 20.0}) {
        const Vec3 r = normalized(Vec3{1, 2, -3}) * angle;
        const Quat a = turn_by(r), b = from_rotation_vector(r);
        EXPECT_LT(absolute(a.w - b.w) + length(Vec3{a.x - b.x, a.y - b.y, a.z - b.z}), 4e-15)
            << angle;
    }
}

}  // namespace
}  // namespace jostle::test
