// SPDX-License-Identifier: MIT
//
// One joint kind per file: what it does with the impulses that it carries, and how it makes new
// ones. joint_table.h picks the kind.
#pragma once

#include "constraints/joints/joint_rows.h"

namespace jostle::physics {

// What a joint exerted on b in one sub-step.
struct JointLoad {
    Vec3 impulse;  // N s
    Vec3 turn;     // N m s
};

void warm_start_ball(JointPair& pair, const BallJoint& kind, Joint& joint);
void solve_ball(JointPair& pair, const JointStep& step, const BallJoint& kind, Joint& joint);
JointLoad load_of_ball(const JointPair& pair, const BallJoint& kind, const Joint& joint);

void warm_start_hinge(JointPair& pair, const HingeJoint& kind, Joint& joint);
void solve_hinge(JointPair& pair, const JointStep& step, const HingeJoint& kind, Joint& joint);
JointLoad load_of_hinge(const JointPair& pair, const HingeJoint& kind, const Joint& joint);
double hinge_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi

void warm_start_cone_twist(JointPair& pair, const ConeTwistJoint& kind, Joint& joint);
void solve_cone_twist(JointPair& pair, const JointStep& step, const ConeTwistJoint& kind,
                      Joint& joint);
JointLoad load_of_cone_twist(const JointPair& pair, const ConeTwistJoint& kind, const Joint& joint);
double twist_angle(Quat frame_a, Quat frame_b);  // rad, -pi..pi
double swing_angle(Quat frame_a, Quat frame_b);  // rad, 0..pi

void warm_start_fixed(JointPair& pair, const FixedJoint& kind, Joint& joint);
void solve_fixed(JointPair& pair, const JointStep& step, const FixedJoint& kind, Joint& joint);
JointLoad load_of_fixed(const JointPair& pair, const FixedJoint& kind, const Joint& joint);

void warm_start_distance(JointPair& pair, const DistanceJoint& kind, Joint& joint);
void solve_distance(JointPair& pair, const JointStep& step, const DistanceJoint& kind,
                    Joint& joint);
JointLoad load_of_distance(const JointPair& pair, const DistanceJoint& kind, const Joint& joint);

}  // namespace jostle::physics
