// SPDX-License-Identifier: MIT
//
// Motion of one body that touches nothing, in double.
#pragma once

#include <optional>

#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct FreeMotion {
    Vec3 displacement;  // m, of the centre of mass
    Quat rotation;      // at the end
    Vec3 v, w;          // at the end
};

// Exact under constant force (x += v dt + a dt^2 / 2). Rotation: the implicit midpoint rule for
// Euler's equations with the Cayley map, which keeps the angular momentum and the energy to
// rounding (Austin, Krishnaprasad, Wang, "Almost Poisson integration of rigid body systems", 1993).
FreeMotion free_motion(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity, double dt);

// Acceleration by gravity and the user's force, m/s^2.
Vec3 acceleration_of(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity);

// Euler's equations over dt, in the body's axes.
struct EulerStep {
    Quat rotation;  // since the start: the body's rotation times this is where it ends
    Vec3 w;         // rad/s, in the body's axes as they end up
};
EulerStep euler_step(const BodyCold& cold, Vec3 w, double dt);

// All that they need to know of a body whose axes are the principal ones of its inertia, which
// takes less than half the time: the ratios (I3 - I2) / I1, (I1 - I3) / I2, (I2 - I1) / I3.
struct PrincipalRatios {
    Vec3 factors;
};
std::optional<PrincipalRatios> principal_ratios(const BodyCold& cold);
EulerStep euler_step(const PrincipalRatios& bend, Vec3 w, double dt);

// Whether the body turns further than `turn` (rad) in dt, with an uneven inertia: its axes may not
// be taken as they stood at the start.
bool is_gyroscopic(const BodyWarm& warm, const BodyCold& cold, double dt, double turn);

// An even turn from one attitude to the other, rad, of all that end there the one most like
// `wished`: so that the way ends where the body does, however often it went round.
Vec3 rotation_vector_between(Quat from, Quat to, Vec3 wished);

struct FreeSpin {
    Quat rotation;
    Vec3 w;
};
// The rotational part, without damping. A negative dt looks back.
FreeSpin free_spin(const BodyWarm& warm, const BodyCold& cold, double dt);

// What is left of a velocity after dt with dv/dt = -damping v; second order, never negative.
double damping_factor(double damping, double dt);

}  // namespace jostle::physics
