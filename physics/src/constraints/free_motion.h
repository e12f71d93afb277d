// SPDX-License-Identifier: MIT
//
// Motion of one body that touches nothing, in double.
#pragma once

#include "state/body_store.h"

namespace jostle::physics {

struct FreeMotion {
    Vec3 displacement;  // m, of the centre of mass
    Quat rotation;      // at the end
    Vec3 v, w;          // at the end
};

// Exact under constant force (x += v dt + a dt^2 / 2). Rotation: the implicit midpoint rule on the
// rotation group with the angular momentum as the variable, so |L| is kept to rounding and the
// energy stays bounded (Lewis and Simo, "Conserving algorithms for the dynamics of Hamiltonian
// systems on Lie groups", 1994).
FreeMotion free_motion(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity, double dt);

// Acceleration by gravity and the user's force, m/s^2.
Vec3 acceleration_of(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity);

struct FreeSpin {
    Quat rotation;
    Vec3 w;
};
// The rotational part, without damping.
FreeSpin free_spin(const BodyWarm& warm, const BodyCold& cold, double dt);

// What is left of a velocity after dt with dv/dt = -damping v; second order, never negative.
double damping_factor(double damping, double dt);

}  // namespace jostle::physics
