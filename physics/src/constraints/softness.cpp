// SPDX-License-Identifier: MIT
#include "constraints/softness.h"

#include "foundation/tuning.h"

namespace jostle::physics {
namespace {

// e^-x for 0 <= x <= 1 by Taylor's series, to 1e-16: the solver calls no libm.
double decay(double x) {
    double term = 1, sum = 1;
    for (int n = 1; n <= 18; n++) sum += term *= -x / n;
    return sum;
}

}  // namespace

Softness soft(double hertz, double damping_ratio, double h) {
    const double omega = 2 * pi * hertz, a1 = 2 * damping_ratio + h * omega;
    const double a2 = h * omega * a1, a3 = 1 / (1 + a2);
    return {a2 * a3 * (omega / a1), a2 * a3, a3};
}

Softness spring(double hertz, double damping_ratio, double h) {
    const double turn = 2 * pi * hertz * h, damping = 2 * damping_ratio * turn;
    if (turn > tuning::resolved_spring_turn || damping > 1) return soft(hertz, damping_ratio, h);
    const double left = decay(damping);
    return {left * turn * turn / h, 1 - left, left, true};
}

Softness damper(double rate, double h) {
    const double share = rate * h / (1 + rate * h);
    return {0, share, 1 - share, true};
}

}  // namespace jostle::physics
