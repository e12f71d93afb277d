// SPDX-License-Identifier: MIT
//
// A spring and damper as numbers of one sub-step (Catto, "Soft Constraints", GDC 2011): an implicit
// spring of angular frequency omega and damping ratio zeta acts on the velocity as
//     lambda' = lambda - mass_scale (v + bias_rate C) / k - impulse_scale lambda.
#pragma once

#include "jostle/physics/scalar.h"

namespace jostle::physics {

struct Softness {
    double bias_rate = 0, mass_scale = 1, impulse_scale = 0;  // as they stand: rigid, no push
};

inline Softness soft(double hertz, double damping_ratio, double h) {
    const double omega = 2 * pi * hertz, a1 = 2 * damping_ratio + h * omega;
    const double a2 = h * omega * a1, a3 = 1 / (1 + a2);
    return {omega / a1, a2 * a3, a3};
}

}  // namespace jostle::physics
