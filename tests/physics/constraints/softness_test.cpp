// SPDX-License-Identifier: MIT
//
// A soft constraint is the implicit spring and damper that it stands for.
#include "physics/src/constraints/softness.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::test {
namespace {
using namespace physics;

// A mass of 2 kg on a spring of 3 Hz, half critically damped, for a step of 1/120 s. Implicit
// Euler: v' = (v - h k/m x) / (1 + h c/m + h^2 k/m).
TEST(Softness, equals_a_step_of_implicit_euler) {
    const double m = 2, h = 1.0 / 120, omega = 2 * pi * 3, zeta = 0.5;
    const double k = m * omega * omega, c = 2 * zeta * omega * m;
    const Softness s = soft(3, zeta, h);
    double v = 0.7, x = -0.2, lambda = 0;
    for (int round = 0; round < 400; round++) {
        const double now = v + lambda / m;
        lambda += -(s.velocity_scale * now + s.position_rate * x) * m - s.impulse_scale * lambda;
    }
    EXPECT_NEAR(v + lambda / m, (v - h * k / m * x) / (1 + h * c / m + h * h * k / m), 1e-12);
}

TEST(Softness, default_is_rigid) {
    const Softness rigid;
    EXPECT_EQ(rigid.position_rate, 0);
    EXPECT_EQ(rigid.velocity_scale, 1);
    EXPECT_EQ(rigid.impulse_scale, 0);
}

TEST(Softness, too_stiff_for_the_step_is_nearly_rigid) {
    const Softness s = soft(1e4, 1, 1.0 / 60);
    EXPECT_NEAR(s.velocity_scale, 1, 1e-5);
    EXPECT_NEAR(s.position_rate, 60, 0.2) << "what is left of the error goes in one step";
}

// A mass on a spring of 1 Hz in sub-steps of 1/480 s, kicked and then moved, for 60 s.
struct Swing {
    double energy, most, sag;  // at the end and at most, of those at the start; under a force
};
Swing swing(double zeta, double force) {
    const double h = 1.0 / 480, omega = 2 * pi;
    const Softness s = spring(1, zeta, h);
    double x = 1, v = 0, lambda = 0, most = 0;
    for (int k = 0; k < 480 * 60; k++) {
        v += force * h + lambda;  // of 1 kg, with the warm start
        const double d = -(s.velocity_scale * v + s.position_rate * x) - s.impulse_scale * lambda;
        lambda += d;
        v += d;
        x += h * v;
        most = maximum(most, v * v / (omega * omega) + x * x);
    }
    return {v * v / (omega * omega) + x * x, most, x};
}

TEST(Softness, undamped_spring_conserves_energy) {
    const Swing undamped = swing(0, 0);
    EXPECT_NEAR(undamped.energy, 1, 0.01);
    EXPECT_LT(undamped.most, 1.01);
    EXPECT_NEAR(swing(0.01, 0).energy, std::exp(-2 * 0.01 * 2 * pi * 60), 1e-5);
}

TEST(Softness, static_deflection_follows_hooke) {
    EXPECT_NEAR(swing(1, 9.81).sag, 9.81 / (4 * pi * pi), 1e-9);
    EXPECT_NEAR(swing(0.3, 9.81).sag, 9.81 / (4 * pi * pi), 1e-9);
}

TEST(Softness, unresolved_frequencies_are_implicit) {
    const double h = 1.0 / 480;
    EXPECT_EQ(spring(200, 0, h).impulse_scale, soft(200, 0, h).impulse_scale);
    EXPECT_EQ(spring(5, 100, h).impulse_scale, soft(5, 100, h).impulse_scale);
}

}  // namespace
}  // namespace jostle::test
