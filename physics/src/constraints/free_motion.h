// SPDX-License-Identifier: MIT
//
// Motion of one body without contacts and joints, in double.
#pragma once

#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct FreeMotion {
    Vec3 displacement;  // m, of the centre of mass
    Quat rotation;      // at the end
    Vec3 v, w;          // at the end
};

// Exact under constant force (x += v dt + a dt^2 / 2). Rotation uses the implicit midpoint rule for
// Euler's equations with the Cayley map, which conserves angular momentum and energy to rounding
// (Austin, Krishnaprasad, Wang, "Almost Poisson integration of rigid body systems", 1993).
FreeMotion free_motion(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity, double dt);

// Acceleration by gravity and the user's force, m/s^2.
Vec3 acceleration_of(const BodyWarm& warm, const BodyCold& cold, Vec3 gravity);

// Result of Euler's equations over dt, in the body's axes.
struct EulerStep {
    Quat rotation;  // since the start: the final rotation is the body's rotation times this
    Vec3 w;         // rad/s, in the body's final axes
};
EulerStep euler_step(const BodyCold& cold, Vec3 w, double dt);

// The ratios (I3 - I2) / I1, (I1 - I3) / I2, (I2 - I1) / I3, all of the inertia that these
// equations need in the principal axes.
Vec3 bend_of(const PrincipalAxes& axes);

// Returns whether a body with anisotropic inertia rotates by more than `turn` (rad) in dt. Its axes
// at the start of the step are then not a valid approximation.
bool is_gyroscopic(const BodyWarm& warm, const BodyCold& cold, double dt, double turn);

// Constant rotation from one orientation to the other, rad. Among all rotations with that result,
// returns the one closest to `expected`, so that the number of full turns matches the body's
// motion.
Vec3 rotation_vector_between(Quat from, Quat to, Vec3 expected);

struct FreeSpin {
    Quat rotation;
    Vec3 w;
};
// The rotational part, without damping. A negative dt integrates backwards.
FreeSpin free_spin(const BodyWarm& warm, const BodyCold& cold, double dt);

// The fraction of a velocity that remains after dt with dv/dt = -damping v. Second order, never
// negative.
double damping_factor(double damping, double dt);

}  // namespace jostle::physics
