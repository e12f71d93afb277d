// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/angles.h"

namespace jostle::physics {

double hinge_angle(Quat frame_a, Quat frame_b) {
    const Mat3 a = to_matrix(frame_a), b = to_matrix(frame_b);
    return arc_tangent(dot(b.x, a.y), dot(b.x, a.x));
}

double twist_angle(Quat frame_a, Quat frame_b) {
    const Quat q = conjugate(frame_a) * frame_b;
    const double angle = 2 * arc_tangent(q.x, q.w);
    return angle > pi ? angle - 2 * pi : (angle < -pi ? angle + 2 * pi : angle);
}

double swing_angle(Quat frame_a, Quat frame_b) {
    const Vec3 a = rotate(frame_a, {1, 0, 0}), b = rotate(frame_b, {1, 0, 0});
    return arc_tangent(length(cross(a, b)), dot(a, b));
}

}  // namespace jostle::physics
