// SPDX-License-Identifier: MIT
#include "physics/src/constraints/softness.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
double decay(double x) {
    int halvings = 0;
    for (; x > 1 && halvings < 12; halvings++) x *= 0.5;
    if (x > 1) return 0;
    ASSERT(x >= 0);
    double term = 1, sum = 1;
    for (int n = 1; n <= 18; n++) sum += term *= -x / n;
    for (; halvings > 0; halvings--) sum *= sum;
    return sum;
}

Softness soft(double hertz, double damping_ratio, double h) {
    const double omega = 2 * pi * hertz, a1 = 2 * damping_ratio + h * omega;
    const double a2 = h * omega * a1, a3 = 1 / (1 + a2);
    ASSERT(hertz >= 0 && damping_ratio >= 0 && h > 0);
    return {a2 * a3 * (omega / a1), a2 * a3, a3};
}

Softness spring(double hertz, double damping_ratio, double h) {
    const double turn = 2 * pi * hertz * h, damping = 2 * damping_ratio * turn;
    if (turn > tuning::resolved_spring_turn || damping > 1) return soft(hertz, damping_ratio, h);
    const double left = decay(damping);
    return {left * turn * turn / h, 1 - left, left, true};
}

Softness held_spring(double hertz, double damping_ratio, double h) {
    const double turn = 2 * pi * hertz * h, damping = 2 * damping_ratio * turn;
    if (turn > tuning::resolved_spring_turn || damping > 1) return soft(hertz, damping_ratio, h);
    const double left = 1 / (1 + damping);
    return {left * turn * turn / h, damping * left, left, true};
}

Softness damper(double rate, double h) {
    const double share = rate * h / (1 + rate * h);
    ASSERT(rate >= 0 && h > 0);
    return {0, share, 1 - share, true};
}

}  // namespace jostle::physics
