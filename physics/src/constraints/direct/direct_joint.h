// SPDX-License-Identifier: MIT
//
// A joint of a group as rows: what it keeps zero, in double. With v, w the velocities of the two
// bodies, a row's error changes at the rate
//     linear . (v_b - v_a) + angular_a . w_a + angular_b . w_b
// and its multiplier pushes along the same vectors. Rows come in this order: those of the points,
// those that keep directions perpendicular, the limit, the motor.
#pragma once

#include <array>
#include <cstdint>

#include "constraints/direct/direct_body.h"
#include "jostle/physics/joint_defs.h"

namespace jostle::physics {

// Bodies by number in the group.
struct DirectJoint {
    static constexpr int most_rows = 8;
    int a = 0, b = 0;
    int points = 0;  // 3: the ends stay together; 1: at a distance; 0: neither
    int turns = 0;   // directions of a that stay perpendicular to directions of b: 0, 2 or 3
    bool has_limit = false, has_motor = false;  // of the angle about z
    int rows() const { return points + turns + (has_limit ? 1 : 0) + (has_motor ? 1 : 0); }
    int limit_row() const { return points + turns; }
    int motor_row() const { return points + turns + (has_limit ? 1 : 0); }

    // Constant: in the principal axes of the bodies.
    Vec3 arm_a, arm_b;            // of the ends, m
    double distance = 0;          // m, when points is 1
    Vec3 turn_a[3], turn_b[3];    // unit
    Vec3 axis_a, x_a, y_a, x_b;   // of the angle about z
    double lower = 0, upper = 0;  // rad
    double speed = 0, most_torque = 0;

    // Where the two bodies are.
    Vec3 line;              // points 1: the unit vector from a's end to b's
    Vec3 apart;             // of the ends, b's from a's, m
    Vec3 lever_a, lever_b;  // to where the force acts, m
    Vec3 angular_a[most_rows], angular_b[most_rows];
    // Rows that are switched off just now (a limit that is not reached, a motor at its most) have
    // no vectors and no multiplier.
    std::array<bool, most_rows> off{};

    double start[most_rows] = {};    // errors as the step began: a motor's and a limit's the angle
    double target[most_rows] = {};   // what is to be left of them
    double error[most_rows] = {};    // of where the step tries to go: m and rad
    double impulse[most_rows] = {};  // unknowns of the step under way
    double force[most_rows] = {};    // half of what acts on b, N and N m: from step to step
    int at_limit = 0;                // 1: on the lower one, -1: on the upper one, 0: between
    int at_most = 0;                 // the motor gives its most, in this direction; 0: less
    Vec3 force_sum, torque_sum;      // impulses on b over the whole step, N s and N m s
};

// The rows' vectors: at the bodies' state, or means over the step, with which the error changes by
// exactly h J (v, w) where a Cayley map turns the bodies.
void write_vectors(DirectJoint& joint, const DirectBody& a, const DirectBody& b);
void write_mean_vectors(DirectJoint& joint, const DirectBody& a, const DirectBody& b);

// Errors of the state, and of where the step tries to go (`h` later: motors go on by speed h).
void measure_start(DirectJoint& joint, const DirectBody& a, const DirectBody& b);
void measure(DirectJoint& joint, const DirectBody& a, const DirectBody& b, double h);
// The angle about z there, rad in -pi..pi.
double trial_angle(const DirectJoint& joint, const DirectBody& a, const DirectBody& b);

// Which kinds have rows here: those without springs, cones and friction.
bool supported(const JointKind& kind);
struct DirectEnd {
    Vec3 arm;    // of the frame's origin from the centre, principal axes
    Quat frame;  // of the frame, principal axes
};
void set_up(DirectJoint& joint, const JointKind& kind, const DirectEnd& a, const DirectEnd& b);

// What a world keeps of a joint from step to step: impulses of a sub-step of h on b, world axes. Of
// a distance only what acts along it. After write_vectors().
struct KeptImpulses {
    Vec3 point, angular;
    double lower = 0, upper = 0, spring = 0, motor = 0;
};
void load_forces(DirectJoint& joint, const KeptImpulses& kept, double h);
KeptImpulses keep_forces(const DirectJoint& joint, double h);

}  // namespace jostle::physics
