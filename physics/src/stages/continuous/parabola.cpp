// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/parabola.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// x(t) - chord(t) = -a t (T - t) / 2.
Vec3 off_the_chord(const Fall& fall, double fraction, Vec3 v, double late, double dt) {
    const double share = -0.5 * (fraction - fall.from) * (1 - fraction);
    return fall.gain * (share * dt) + v * late + fall.gain * (0.5 * late * late / dt);
}

void put_on_parabolas(ImpactBody& a, const Fall& fall_a, ImpactBody& b, const Fall& fall_b,
                      std::vector<ImpactPoint>& points, double fraction, double dt) {
    ASSERT(!points.empty() && dt > 0);
    if (fall_a.gain == Vec3{} && fall_b.gain == Vec3{}) return;
    const ImpactPoint& p = points.front();
    const Vec3 u =
        (b.v + cross(b.w, p.position - b.center)) - (a.v + cross(a.w, p.position - a.center));
    // gap - closing t + pull t^2 / 2 = 0, all along the normal.
    const double gap = dot(p.normal, off_the_chord(fall_b, fraction, {}, 0, dt) -
                                         off_the_chord(fall_a, fraction, {}, 0, dt));
    const double closing = -dot(u, p.normal), pull = dot(p.normal, fall_b.gain - fall_a.gain) / dt;
    const double square = closing * closing - 2 * pull * gap;
    if (!(closing > tuning::restitution_speed) || !(square > 0)) return;
    const double late = 2 * gap / (closing + square_root(square));
    if (absolute(late) > dt) return;
    const Vec3 moved_a = off_the_chord(fall_a, fraction, a.v, late, dt),
               moved_b = off_the_chord(fall_b, fraction, b.v, late, dt);
    a.center += moved_a;
    b.center += moved_b;
    a.v += fall_a.gain * (late / dt);
    b.v += fall_b.gain * (late / dt);
    const Vec3 moved = b.inverse_mass == Vec3{}   ? moved_a
                       : a.inverse_mass == Vec3{} ? moved_b
                                                  : (moved_a + moved_b) * 0.5;
    for (ImpactPoint& point : points) point.position += moved;
}

}  // namespace jostle::physics
