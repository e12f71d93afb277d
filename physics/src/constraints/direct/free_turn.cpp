// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/free_turn.h"

#include "jostle/base/check.h"

namespace jostle::physics {

Quat turn_by(Vec3 r) {
    const double s = 0.25 * length_squared(r);  // square of half the angle
    if (!(s < 0.25)) return from_rotation_vector(r);
    const double cosine =
        1 - s * (1.0 / 2 -
                 s * (1.0 / 24 -
                      s * (1.0 / 720 - s * (1.0 / 40320 - s * (1.0 / 3628800 - s / 479001600.0)))));
    const double ratio =
        1 -
        s * (1.0 / 6 -
             s * (1.0 / 120 -
                  s * (1.0 / 5040 - s * (1.0 / 362880 - s * (1.0 / 39916800 - s / 6227020800.0)))));
    const double k = 0.5 * ratio;
    return {r.x * k, r.y * k, r.z * k, cosine};
}

namespace {

// Along an axis of the rotated frame.
double component(Quat q, Vec3 v, int axis) {
    const double x2 = q.x + q.x, y2 = q.y + q.y, z2 = q.z + q.z;
    if (axis == 0)
        return dot({1 - q.y * y2 - q.z * z2, q.x * y2 + q.w * z2, q.x * z2 - q.w * y2}, v);
    if (axis == 1)
        return dot({q.x * y2 - q.w * z2, 1 - q.x * x2 - q.z * z2, q.y * z2 + q.w * x2}, v);
    return dot({q.x * z2 + q.w * y2, q.y * z2 - q.w * x2, 1 - q.x * x2 - q.y * y2}, v);
}

// q times the rotation about one of its axes.
Quat turned_about(Quat q, int axis, double angle) {
    const Quat turn = turn_by({angle, 0, 0});
    const double sine = turn.x, cosine = turn.w;
    if (axis == 0)
        return {q.w * sine + q.x * cosine, q.y * cosine + q.z * sine, q.z * cosine - q.y * sine,
                q.w * cosine - q.x * sine};
    if (axis == 1)
        return {q.x * cosine - q.z * sine, q.w * sine + q.y * cosine, q.x * sine + q.z * cosine,
                q.w * cosine - q.y * sine};
    return {q.x * cosine + q.y * sine, q.y * cosine - q.x * sine, q.w * sine + q.z * cosine,
            q.w * cosine - q.z * sine};
}

// The axis whose two other moments are most similar.
int top_axis(Vec3 inverse) {
    const double yz = absolute(inverse.y - inverse.z), zx = absolute(inverse.z - inverse.x),
                 xy = absolute(inverse.x - inverse.y);
    return yz <= zx && yz <= xy ? 0 : (zx <= xy ? 1 : 2);
}

}  // namespace

double turn_rate(Vec3 momentum, Vec3 inverse_moments) {
    const int top = top_axis(inverse_moments);
    return length(momentum) *
           maximum(inverse_moments[(top + 1) % 3], inverse_moments[(top + 2) % 3]);
}

Quat free_turn(Quat q, Vec3 momentum, Vec3 inverse_moments, double h) {
    const Vec3& inverse = inverse_moments;
    if (inverse.x == inverse.y && inverse.y == inverse.z)
        return nearly_unit(turn_by(momentum * (h * inverse.x)) * q);
    const int top = top_axis(inverse);
    ASSERT(inverse.x >= 0 && inverse.y >= 0 && inverse.z >= 0);
    const int i = (top + 1) % 3, j = (top + 2) % 3;
    const double uneven = inverse[j] - inverse[i];
    if (uneven != 0) q = turned_about(q, j, 0.5 * h * uneven * component(q, momentum, j));
    const double along = (inverse[top] - inverse[i]) * component(q, momentum, top);
    q = turn_by(momentum * (h * inverse[i])) * turned_about(q, top, h * along);
    if (uneven != 0) q = turned_about(q, j, 0.5 * h * uneven * component(q, momentum, j));
    return nearly_unit(q);
}

}  // namespace jostle::physics
