// SPDX-License-Identifier: MIT
//
// A soft constraint is the implicit spring and damper that it stands for.
#include "constraints/softness.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

// A mass of 2 kg on a spring of 3 Hz, half critically damped, for a step of 1/120 s. Implicit
// Euler: v' = (v - h k/m x) / (1 + h c/m + h^2 k/m).
TEST(Softness, is_a_step_of_implicit_euler) {
    const double m = 2, h = 1.0 / 120, omega = 2 * pi * 3, zeta = 0.5;
    const double k = m * omega * omega, c = 2 * zeta * omega * m;
    const Softness s = soft(3, zeta, h);
    double v = 0.7, x = -0.2, lambda = 0;
    // lambda' = lambda - mass_scale (v + bias_rate x) m - impulse_scale lambda, which acts as v'.
    for (int round = 0; round < 400; round++) {
        const double now = v + lambda / m;
        lambda += -s.mass_scale * (now + s.bias_rate * x) * m - s.impulse_scale * lambda;
    }
    EXPECT_NEAR(v + lambda / m, (v - h * k / m * x) / (1 + h * c / m + h * h * k / m), 1e-12);
}

TEST(Softness, as_it_stands_is_rigid) {
    const Softness rigid;
    EXPECT_EQ(rigid.bias_rate, 0);
    EXPECT_EQ(rigid.mass_scale, 1);
    EXPECT_EQ(rigid.impulse_scale, 0);
}

TEST(Softness, stiffer_than_a_step_can_carry_is_nearly_rigid) {
    const Softness s = soft(1e4, 1, 1.0 / 60);
    EXPECT_NEAR(s.mass_scale, 1, 1e-5);
    EXPECT_NEAR(s.bias_rate, 60, 0.2) << "what is left of the error goes in one step";
}

}  // namespace
}  // namespace jostle::test
