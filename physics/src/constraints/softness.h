// SPDX-License-Identifier: MIT
//
// A spring and damper as numbers of one sub-step: they act on the velocity v and the error C as
//     lambda' = lambda - (velocity_scale v + position_rate C) / k - impulse_scale lambda,
// where lambda is the impulse of the sub-step before, which the warm start has applied, and k is
// what a unit impulse does to v.
#pragma once

#include "jostle/physics/scalar.h"

namespace jostle::physics {

struct Softness {
    double position_rate = 0, velocity_scale = 1, impulse_scale = 0;  // so: rigid, no push
    bool once = false;  // acts in one pass of a sub-step: not in the relaxing one
};

// e^-x for x >= 0, by Taylor's series to 1e-16: the solver calls no libm.
double decay(double x);

// Implicit Euler (Catto, "Soft Constraints", GDC 2011): bounded however stiff, and damps.
Softness soft(double hertz, double damping_ratio, double h);

// A user's spring. As long as a sub-step resolves it: its damping in closed form, and symplectic
// Euler, which keeps the energy of what is not damped and sags under a load as Hooke says. Else
// soft(), in both passes: of stiff springs in a row one pass is too few.
Softness spring(double hertz, double damping_ratio, double h);

// Takes away speed at `rate` per second, implicitly: a share of rate h / (1 + rate h) in h.
Softness damper(double rate, double h);

}  // namespace jostle::physics
