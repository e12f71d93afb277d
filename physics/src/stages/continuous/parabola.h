// SPDX-License-Identifier: MIT
//
// A body that forces accelerate evenly flies along a parabola. Its sweep is a chord of that, from
// where nothing else acts on it to the end of the step, and meets things a little before or after
// the body does.
#pragma once

#include <vector>

#include "physics/src/constraints/impact.h"

namespace jostle::physics {

struct Fall {
    Vec3 gain;        // m/s: what a step adds to the velocity
    double from = 0;  // the fraction of the step at which the chord begins
};

// How far the body is from its chord at a fraction of the step, m; and `late` seconds after that,
// with the velocity v then, from where the chord was at the fraction.
Vec3 off_the_chord(const Fall& fall, double fraction, Vec3 v, double late, double dt);

// Two whose sweeps meet at a fraction of the step are put to where their parabolas meet, with their
// velocities there, and so are the points. Then a bounce keeps what it should: a ball that is left
// on its chord loses g^2 dt^2 / 12 per kg each time, in the mean. What is left of the step is
// counted from the sweep's moment all the same. Does nothing if they close too slowly to bounce.
void put_on_parabolas(ImpactBody& a, const Fall& fall_a, ImpactBody& b, const Fall& fall_b,
                      std::vector<ImpactPoint>& points, double fraction, double dt);

}  // namespace jostle::physics
