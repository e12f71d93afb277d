// SPDX-License-Identifier: MIT
//
// A body under way between two steps, as stop_fast_bodies follows it from impact to impact.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "collision/narrowphase/impact_points.h"
#include "collision/narrowphase/time_of_impact.h"
#include "jostle/physics/scalar.h"
#include "state/world_state.h"

namespace jostle::physics {

// One end of an impact, or one body under way.
struct Traveller {
    std::uint32_t body = none;
    // A tumbling body does not turn evenly: its way is cut into legs, each from where it really is
    // to where it really will be.
    Sweep sweep;
    Vec3 velocity, gain;  // m/s at the start of the sweep, and what forces add over a whole step
    // The spin and the attitude at one moment of the step; at others Euler's equations give it.
    double spin_at = 1;  // fraction
    Vec3 spin;           // rad/s
    Quat spin_rotation;
    Quat end_rotation;  // at the end of the step, when it is not met before
    Vec3 end_spin;
    bool fast = false;     // looks for impacts itself
    bool changed = false;  // its pose or velocity is no longer what the step made it
    int impacts = 0;
    // The first impact that is known, if any.
    bool looked = false, to_look = false;
    std::uint32_t anew_in = 0;          // the round in which it last looked at everything
    std::vector<std::uint32_t> turned;  // bodies that go another way since then
    double fraction = Impact::never;
    std::uint32_t own_shape = none, other_shape = none;
    std::vector<ImpactPoint> points;
    Aabb way;                         // holds all that is left of it
    std::vector<std::uint32_t> near;  // shapes that may be in it, in order and once each
};

// An even turn from one attitude to the other, rad, of all that end there the one most like
// `wished`: so that the way ends where the body does, however often it went round.
inline Vec3 way_round(Quat from, Quat to, Vec3 wished) {
    const Quat turn = to * conjugate(from);
    const Vec3 v{turn.x, turn.y, turn.z};
    const double l = length(v);
    const Vec3 axis = l > 1e-12 ? v * (1 / l) : normalized(wished);
    const double angle = 2 * arc_tangent(l, turn.w), round = 2 * pi;
    return axis * (angle + round * std::floor((dot(wished, axis) - angle) / round + 0.5));
}

}  // namespace jostle::physics
