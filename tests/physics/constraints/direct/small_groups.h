// SPDX-License-Identifier: MIT
//
// Groups of joints without a world, put together by hand.
#pragma once

#include "physics/src/constraints/direct/direct_group.h"

namespace jostle::test {
using namespace physics;

inline constexpr double g = 9.81;

inline DirectBody body_at(Vec3 x, double mass, Vec3 moments) {
    DirectBody body;
    body.pushed = true;
    body.x = x;
    body.mass = mass;
    body.inverse_mass = 1 / mass;
    body.inverse_masses = Vec3{1, 1, 1} * (1 / mass);
    body.moments = moments;
    body.inverse_moments = {1 / moments.x, 1 / moments.y, 1 / moments.z};
    body.force = {0, 0, -g * mass};
    refresh(body);
    return body;
}

inline DirectBody ground() {
    DirectBody body;
    refresh(body);
    return body;
}

inline int join(DirectGroup& group, int a, int b, const JointKind& kind, Vec3 arm_a, Vec3 arm_b,
                Quat frame = {}) {
    DirectJoint joint;
    joint.a = a;
    joint.b = b;
    set_up(joint, kind, {arm_a, frame}, {arm_b, frame});
    write_vectors(joint, group.bodies[static_cast<std::size_t>(a)],
                  group.bodies[static_cast<std::size_t>(b)]);
    group.joints.push_back(joint);
    return static_cast<int>(group.joints.size()) - 1;
}

inline double energy(const DirectGroup& group) {
    double sum = 0;
    for (const DirectBody& body : group.bodies)
        if (body.pushed)
            sum += 0.5 * (dot(body.p, velocity(body)) + dot(body.l, spin(body))) -
                   dot(body.force, body.x);
    return sum;
}

inline double widest_gap(const DirectGroup& group) {
    double most = 0;
    for (const DirectJoint& j : group.joints) {
        const DirectBody &a = group.bodies[static_cast<std::size_t>(j.a)],
                         &b = group.bodies[static_cast<std::size_t>(j.b)];
        most = maximum(most, length((b.x + b.axes * j.arm_b) - (a.x + a.axes * j.arm_a)));
    }
    return most;
}

// hinge axis y, for what falls in the xz plane
inline const Quat about_y = from_axis_angle({1, 0, 0}, -0.5 * pi);

}  // namespace jostle::test
