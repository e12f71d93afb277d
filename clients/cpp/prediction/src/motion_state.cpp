// SPDX-License-Identifier: MIT
#include "clients/cpp/prediction/src/motion_state.h"

namespace jostle::client {

using namespace physics;

Transform to_transform(const snapshot::Pose& pose) {
    const auto& p = pose.position;
    const auto& q = pose.rotation;
    return {.position = {p[0], p[1], p[2]}, .rotation = {q[0], q[1], q[2], q[3]}};
}

snapshot::Pose to_pose(const Transform& pose) {
    const Vec3& p = pose.position;
    const Quat& q = pose.rotation;
    return {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}};
}

Vec3 rotation_vector_between(const Quat& a, const Quat& b) {
    Quat q = b * conjugate(a);
    if (q.w < 0) q = {-q.x, -q.y, -q.z, -q.w};
    const Vec3 v{q.x, q.y, q.z};
    const double sine = length(v);
    return sine == 0 ? Vec3{} : v * (2 * arc_tangent(sine, q.w) / sine);
}

Transform interpolate(const Transform& a, const Transform& b, double t) {
    if (t == 0) return a;
    return {.position = a.position + (b.position - a.position) * t,
            .rotation = from_rotation_vector(rotation_vector_between(a.rotation, b.rotation) * t) *
                        a.rotation};
}

}  // namespace jostle::client
