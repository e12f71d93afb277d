// SPDX-License-Identifier: MIT
//
// A spring and damper as coefficients of one sub-step. They act on the velocity v and the error C
// as
//     lambda' = lambda - (velocity_scale v + position_rate C) / k - impulse_scale lambda,
// where lambda is the impulse of the previous sub-step, which warm starting has applied, and k is
// the response of v to a unit impulse.
#pragma once

#include "jostle/physics/scalar.h"

namespace jostle::physics {

struct Softness {
    double position_rate = 0, velocity_scale = 1,
           impulse_scale = 0;  // default: rigid, without position correction
    bool once = false;         // acts in one pass per sub-step, not in the relaxing one
};

// e^-x for x >= 0, by Taylor series to 1e-16. The solver does not call libm.
double decay(double x);

// Implicit Euler (Catto, "Soft Constraints", GDC 2011): stable for any stiffness, with numerical
// damping.
Softness soft(double hertz, double damping_ratio, double h);

// A user-defined spring. If the sub-step resolves it: closed-form damping and symplectic Euler,
// which conserves the energy of an undamped spring and deflects under load according to Hooke's
// law. Otherwise soft(), in both passes, because one pass is not enough for chained stiff springs.
Softness spring(double hertz, double damping_ratio, double h);

// The same for bodies that a point holds together, whose inertia about the point exceeds their own:
// an implicit damper, because the decay of their own speed would damp them too much.
Softness held_spring(double hertz, double damping_ratio, double h);

// Reduces speed at `rate` per second, implicitly: by the fraction rate h / (1 + rate h) in h.
Softness damper(double rate, double h);

}  // namespace jostle::physics
