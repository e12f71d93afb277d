// SPDX-License-Identifier: MIT
//
// A body of a joint group, in double. Its axes are the principal axes of its inertia. The state
// stores momentum, not velocity, so that momentum-conserving steps conserve it to rounding.
#pragma once

#include "jostle/physics/quat.h"
#include "physics/src/constraints/direct/symmetric_mat3.h"

namespace jostle::physics {

struct DirectBody {
    // Constant over the step.
    double mass = 0, inverse_mass = 0;  // kg; zero for bodies that joints cannot push
    Vec3 inverse_masses;                // along the world axes: zero along locked axes
    // kg m^2, about the principal axes. For a body that rotates about a single world axis or not at
    // all, the other moments and their inverses are zero.
    Vec3 moments, inverse_moments;
    bool turns_freely = true;
    Vec3 force, torque;  // N, N m, world; gravity included
    double linear_damping = 0, angular_damping = 0;
    bool pushed = false;       // joints can push it; else it moves at v and w regardless of joints
    double spring_square = 0;  // rad^2/s^2: sum of the squared rates of all springs on it

    // State.
    Vec3 x;     // m, centre of mass
    Quat q;     // orientation of the principal axes
    Vec3 p, l;  // kg m/s, kg m^2/s about the centre, world
    Vec3 v, w;  // state of bodies that are not pushed; scratch for others
    // With straight drifts (hold_joints.cpp) the solver that moves the body turns it from this
    // orientation by the sum of this rotation vector and the spin times h.
    Quat turned_from;
    Vec3 turned;
    // Derived from the state.
    Mat3 axes;
    Mat3 inverse_inertia;  // world

    // The end of the current step attempt, and data of the energy-momentum step.
    Vec3 x1;
    Quat q1;
    Mat3 axes1;
    Vec3 v0, w0;           // at the start of the step
    Vec3 mean_w;           // rad/s: the unknown
    Vec3 sum, twist;       // impulse, N s; angular impulse, N m s
    Vec3 residual;         // of the rotation equation, N m s
    Vec3 spin_correction;  // the residual's effect on the spin, rad/s
    Mat3 inertia;          // world, at the start of the step
    Mat3 stiffness;        // of the joint forces against rotation of the body: N m / rad
    Mat3 response;         // inverse of the body's matrix in the step
};

// m diag(d) m^T.
inline Mat3 in_axes(const Mat3& m, Vec3 d) {
    return to_mat3(symmetric_in_axes(m, d));
}

inline Vec3 velocity(const DirectBody& body) {
    return body.pushed ? scaled(body.p, body.inverse_masses) : body.v;
}
inline Vec3 spin(const DirectBody& body) {
    return body.pushed ? body.inverse_inertia * body.l : body.w;
}
// Call after x and q changed.
inline void refresh(DirectBody& body) {
    body.axes = to_matrix(body.q);
    body.inverse_inertia = in_axes(body.axes, body.inverse_moments);
}

}  // namespace jostle::physics
