// SPDX-License-Identifier: MIT
//
// A body under constant force follows a parabola. Its sweep is a chord of the parabola, from the
// point where only that force acts to the end of the step, and hits other bodies slightly earlier
// or later than the body does.
#pragma once

#include <vector>

#include "physics/src/constraints/impact.h"

namespace jostle::physics {

struct Fall {
    Vec3 gain;        // m/s: velocity change over a whole step
    double from = 0;  // the fraction of the step at which the chord begins
};

// Deviation of the body from its chord at a fraction of the step, m; and `late` seconds after that,
// with the velocity v then, relative to the chord at the fraction.
Vec3 off_the_chord(const Fall& fall, double fraction, Vec3 v, double late, double dt);

// Two bodies whose sweeps touch at a fraction of the step are moved to the contact of their
// parabolas, with the velocities at that time, and so are the points. A bounce then conserves
// energy correctly: a ball that stays on its chord loses g^2 dt^2 / 12 per kg in each bounce on
// average. The rest of the step still starts at the sweep's fraction. Does nothing if the bodies
// close too slowly to bounce.
void put_on_parabolas(ImpactBody& a, const Fall& fall_a, ImpactBody& b, const Fall& fall_b,
                      std::vector<ImpactPoint>& points, double fraction, double dt);

}  // namespace jostle::physics
