// SPDX-License-Identifier: MIT
//
// The closest points of two segments, the cores of capsules.
#pragma once

#include "jostle/base/check.h"
#include "jostle/physics/vec3.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

struct SegmentPair {
    double s, t;  // parameters on a and b, -half..half
};

// Closest points of a + s u, |s| <= ha, and b + t v, |t| <= hb, with unit vectors u and v (Ericson,
// "Real-Time Collision Detection", 5.1.9). Parallel segments use the centre of their overlap, so
// that the result does not depend on rounding.
inline SegmentPair closest_on_segments(Vec3 a, Vec3 u, double ha, Vec3 b, Vec3 v, double hb) {
    const Vec3 r = b - a;
    ASSERT(!(ha < 0) && !(hb < 0));
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

// Round edges that cross at a small angle touch in a long ellipse (Hertz). A single contact point
// moves along them by `distance / sine^2` per radian of rotation. It is fixed within a step, so the
// bodies would rock with growing amplitude under load. Such edges therefore touch in two points.
// Each is this distance from the closest point, at the position where the axes, `distance` apart,
// are further apart by tuning::crossing_gap times `radius`.
inline double half_of_crossing(double distance, double radius, double cosine) {
    return square_root(2 * tuning::crossing_gap * radius * distance /
                       maximum(1 - cosine * cosine, 1e-12));
}

}  // namespace jostle::physics
