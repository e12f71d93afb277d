// SPDX-License-Identifier: MIT
//
// The closest points of two segments: the cores of capsules.
#pragma once

#include "jostle/physics/vec3.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

struct SegmentPair {
    double s, t;  // where on a and b, -half..half
};

// Closest points of a + s u, |s| <= ha, and b + t v, |t| <= hb, u and v unit (Ericson, "Real-Time
// Collision Detection", 5.1.9). Parallel segments take the middle of their common part, so that the
// answer does not hang on rounding.
inline SegmentPair closest_on_segments(Vec3 a, Vec3 u, double ha, Vec3 b, Vec3 v, double hb) {
    const Vec3 r = b - a;
    const double c = dot(u, v), ru = dot(r, u), rv = dot(r, v), det = 1 - c * c;
    double s;
    if (det > 1e-12) {
        s = clamp((ru - c * rv) / det, -ha, ha);
    } else {
        const double reach = hb, low = maximum(-ha, ru - reach), high = minimum(ha, ru + reach);
        s = clamp(0.5 * (low + high), -ha, ha);
    }
    double t = c * s - rv;
    if (t < -hb || hb < t) {
        t = clamp(t, -hb, hb);
        s = clamp(ru + c * t, -ha, ha);
    }
    return {s, t};
}

// Round edges that cross at a small angle touch in a long ellipse (Hertz). As one point, which
// every turn moves along them by `distance / sine^2` for each radian, they would rock ever more
// under a load: a step holds it where it was. So they touch in two, this far on both sides of the
// nearest, where their axes, `distance` apart, are by tuning::crossing_gap of `radius` further from
// each other.
inline double half_of_crossing(double distance, double radius, double cosine) {
    return square_root(2 * tuning::crossing_gap * radius * distance /
                       maximum(1 - cosine * cosine, 1e-12));
}

}  // namespace jostle::physics
